"""Files of all kinds come in together: each is tried, what fails is said, and the scene holds the rest."""

from __future__ import annotations

import shutil
from pathlib import Path

import bpy
import pytest

from tests import harness
from tests.scene.test_bvh import OWN

operator = bpy.ops.motion_theater.import_motion_capture


def drop(folder: Path, *names: str, **options: object) -> set[str]:
    """Import files as a drop does."""
    return operator(directory=str(folder), files=[{"name": name} for name in names], **options)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with two BVHs, a skeleton with two motions, and files that nothing reads."""
    (tmp_path / "one.bvh").write_text(OWN)
    (tmp_path / "two.bvh").write_text(OWN.replace("Leg", "Shin"))
    (tmp_path / "broken.bvh").write_text(OWN.replace("JOINT Leg", "JOINT").replace("OFFSET 10", "OFFSET ten"))
    (tmp_path / "notes.txt").write_text("nothing of the kind\n")
    (tmp_path / "empty.amc").write_text("")
    for source, target in (("human.asf", "zebra.asf"), ("walk.amc", "walk.amc"), ("wave.amc", "wave.amc")):
        shutil.copy(harness.TESTDATA / source, tmp_path / target)
    (tmp_path / "other.asf").write_text((harness.TESTDATA / "human.asf").read_text().replace("lfemur", "thigh"))
    return tmp_path


def armatures() -> dict[str, int]:
    """Return the number of bones of each armature."""
    return {ob.name: len(ob.data.bones) for ob in bpy.data.objects if ob.type == "ARMATURE"}


def test_each_file_of_many_gets_an_armature_of_its_own(folder: Path) -> None:
    assert drop(folder, "one.bvh", "two.bvh") == {"FINISHED"}
    assert armatures() == {"one": 3, "two": 3}


def test_a_skeleton_and_motions_dropped_together_belong_together(folder: Path) -> None:
    assert drop(folder, "zebra.asf", "walk.amc", "other.asf", "wave.amc") == {"FINISHED"}
    sources = sorted(
        (Path(ob.motion_theater.skeleton_source).name, [Path(one.source).name for one in ob.motion_theater.entries])
        for ob in bpy.data.objects
    )
    assert sources == [("other.asf", []), ("zebra.asf", ["walk.amc"]), ("zebra.asf", ["wave.amc"])]


def test_an_amc_alone_finds_its_skeleton_or_takes_the_active_armature(tmp_path: Path) -> None:
    operator(filepath=str(harness.TESTDATA / "walk.amc"))
    ob = harness.armature()
    assert len(ob.motion_theater.entries) == 1
    operator(filepath=str(harness.TESTDATA / "wave.amc"))
    assert harness.armature() == ob
    assert len(ob.motion_theater.entries) == 2
    operator(filepath=str(harness.TESTDATA / "wave.amc"), target="NEW")
    assert harness.armature() != ob


def test_bad_files_are_skipped_with_their_reason_and_stop_nothing(
    folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    names = ("one.bvh", "broken.bvh", "notes.txt", "empty.amc", "missing.bvh", "two.bvh")
    assert drop(folder, *names) == {"FINISHED"}
    assert armatures() == {"one": 3, "two": 3}
    said = capfd.readouterr().out
    assert "Imported 2 files, skipped 4" in said
    for name in ("broken.bvh", "notes.txt", "empty.amc", "missing.bvh"):
        assert said.count(name) == 1, said
    assert "Traceback" not in said


def test_a_batch_of_which_nothing_can_be_read_leaves_everything_as_it_was(folder: Path) -> None:
    harness.import_human()
    before = harness.snapshot()
    said = harness.refusal(lambda: drop(folder, "broken.bvh", "notes.txt", rate="SCENE"))
    assert said.startswith("Imported 0 files, skipped 2")
    assert harness.snapshot() == before


def test_a_mistake_of_our_own_costs_only_its_file(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    tracks = harness.module("tracks")
    add_track = tracks.add_track

    def fails(context: object, ob: object, request: object) -> str:
        if request.path.endswith("one.bvh"):  # type: ignore[attr-defined]
            raise KeyError("unforeseen")
        return add_track(context, ob, request)

    monkeypatch.setattr(tracks, "add_track", fails)
    assert drop(folder, "one.bvh", "two.bvh") == {"FINISHED"}
    assert armatures() == {"two": 3}
    assert "please report it: KeyError('unforeseen')" in capfd.readouterr().out


def test_a_file_is_recognised_by_its_content(folder: Path) -> None:
    (folder / "one.bvh").rename(folder / "one.amc")
    operator(filepath=str(folder / "one.amc"))
    assert armatures() == {"one": 3}


def test_the_first_motion_sets_the_rate_of_the_scene_and_the_others_follow(folder: Path) -> None:
    (folder / "fast.bvh").write_text(OWN.replace("0.0333333", "0.0166667"))
    drop(folder, "one.bvh", "fast.bvh", rate="SCENE")
    render = bpy.context.scene.render
    assert (render.fps, render.fps_base) == (30, 1.0)
    ends = {ob.name: ob.motion_theater.entries[0].result_end for ob in bpy.data.objects}
    assert ends == {"one": 4.0, "fast": 2.0}


def test_without_a_file_nothing_happens() -> None:
    assert harness.refusal(operator) == "No file was chosen"


def test_the_redo_panel_can_change_what_was_inferred(folder: Path) -> None:
    operator(filepath=str(folder / "one.bvh"), scale=3.0, up="Z", bone_style="AXES", rate_hz=15.0, rate="SAMPLES")
    ob = harness.armature()
    stack = ob.motion_theater
    assert (stack.up, stack.bone_style) == ("Z", "AXES")
    assert stack.unit_m == pytest.approx(0.03)
    assert stack.entries[0].result_end == pytest.approx(1 + 3 * 24 / 15)
