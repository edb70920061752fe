"""A stack goes out as a file that gives it back, and that the command line turns into the same motion."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness

TOLERANCE_M = 1e-5
RIGHT_ARM = ("rclavicle", "rhumerus", "rradius", "rwrist", "rhand")
operators = bpy.ops.motion_theater


def build(*steps: str) -> bpy.types.Object:
    """Return an armature with a stack of these steps, in a scene of 30 Hz."""
    bpy.context.scene.render.fps = 30
    ob = harness.import_human()
    for step in steps:
        if step == "wave":
            harness.select(ob, RIGHT_ARM)
            harness.add("wave.amc", selected_only=True, cut_end=100, blend_depth=10)
        elif step == "continue":
            harness.add("walk.amc", scale_start=61, preserve=True, preserve_rotation="FULL", preserve_height=True)
        elif step == "euler":
            harness.add("wave.amc", cut_start=5, cut_end=50, scale_start=10, scale_end=40, blend="EULER", blend_depth=5)
        elif step == "filter":
            harness.select(ob, ["lfemur", "ltibia"])
            operators.filter(kind="WEIGHTED", depth=7, selected_only=True)
        else:
            harness.add(step)
    return ob


def entries(ob: bpy.types.Object) -> list[dict[str, object]]:
    """Return all settings of a stack, without what the last rebuild noted; sources in one spelling."""
    noted = ("clip_", "result_")
    found = [
        {name: value for name, value in harness.settings(entry).items() if not name.startswith(noted)}
        for entry in ob.motion_theater.entries
    ]
    return [one | {"source": str(Path(str(one["source"])).resolve()) if one["source"] else ""} for one in found]


@pytest.mark.parametrize("extension", ["toml", "json"])
def test_a_stack_comes_back_from_its_file(tmp_path: Path, extension: str) -> None:
    ob = build("step_and_jump.amc", "wave", "filter")
    ob.motion_theater.entries[1].enabled = False
    before, keys = entries(ob), harness.keys(ob)
    path = tmp_path / f"stack.{extension}"
    operators.stack_export(filepath=str(path))
    harness.empty_file()
    again = build()
    operators.stack_import(filepath=str(path))
    assert entries(again) == before
    assert harness.same_keys(harness.keys(again), keys)
    if extension == "json":
        assert json.loads(path.read_text())["entries"][1]["enabled"] is False


@pytest.mark.parametrize(
    "steps",
    [
        ("step_and_jump.amc",),
        ("step_and_jump.amc", "wave"),
        ("step_and_jump.amc", "wave", "filter"),
        ("walk.amc", "continue"),
        ("step_and_jump.amc", "euler"),
    ],
    ids="-".join,
)
def test_combine_gives_the_motion_that_blender_shows(
    tmp_path: Path, steps: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    ob = build(*steps)
    operators.stack_export(filepath=str(tmp_path / "stack.toml"))
    monkeypatch.setattr(sys, "argv", ["motion-theater", "combine", f"{tmp_path}/stack.toml", f"{tmp_path}/out.bvh"])
    assert motion_theater.main() == 0
    clip = motion_theater.read(tmp_path / "out.bvh")
    start, end = (int(ob.animation_data.action.frame_range[at]) for at in (0, 1))
    assert clip.frames == end - start + 1
    number = {name: at for at, name in enumerate(clip.skeleton.names)}
    pairs = [(at, number[bone]) for at, bone in enumerate(ob.pose.bones.keys()) if bone in number]
    assert len(pairs) == len(ob.pose.bones)
    shown, written = (list(row) for row in zip(*pairs, strict=True))
    for frame in range(clip.frames):
        heads, _, _ = clip.motion.pose(clip.skeleton, clip.first_frame + frame)
        x, y, z = (heads * clip.skeleton.unit_m).T
        matrices = harness.pose(ob, start + frame)
        assert np.abs(np.column_stack((x, -z, y))[written] - matrices[shown, :3, 3]).max() <= TOLERANCE_M, frame


def test_paths_are_relative_to_the_file(tmp_path: Path) -> None:
    for name in ("human.asf", "walk.amc"):
        (tmp_path / name).write_bytes((harness.TESTDATA / name).read_bytes())
    operators.import_skeleton(filepath=str(tmp_path / "human.asf"))
    operators.add_track(filepath=str(tmp_path / "walk.amc"))
    (tmp_path / "stacks").mkdir()
    operators.stack_export(filepath=str(tmp_path / "stacks/a.toml"))
    text = (tmp_path / "stacks/a.toml").read_text()
    assert 'source = "../walk.amc"' in text
    assert 'skeleton = "../human.asf"' in text
    assert [path.name for path in (tmp_path / "stacks").iterdir()] == ["a.toml"]


def test_a_skeleton_whose_file_is_gone_is_written_beside_the_stack(tmp_path: Path) -> None:
    (tmp_path / "my.asf").write_bytes((harness.TESTDATA / "human.asf").read_bytes())
    operators.import_skeleton(filepath=str(tmp_path / "my.asf"))
    harness.add("walk.amc")
    (tmp_path / "my.asf").unlink()
    operators.stack_export(filepath=str(tmp_path / "a.toml"))
    skeletons = [
        motion_theater.read(path).skeleton for path in (tmp_path / "a skeleton.asf", harness.TESTDATA / "human.asf")
    ]
    assert skeletons[0].names == skeletons[1].names
    assert np.array_equal(skeletons[0].heads, skeletons[1].heads)
    harness.empty_file()
    operators.stack_import(filepath=str(tmp_path / "a.toml"))
    assert [entry.name for entry in harness.armature().motion_theater.entries] == ["walk"]


def test_without_an_armature_the_skeleton_is_imported(tmp_path: Path) -> None:
    keys = harness.keys(build("walk.amc"))
    operators.stack_export(filepath=str(tmp_path / "a.toml"))
    harness.empty_file()
    operators.stack_import(filepath=str(tmp_path / "a.toml"), set_rate=True)
    assert harness.same_keys(harness.keys(harness.armature()), keys)
    assert bpy.context.scene.render.fps == 30


def test_entries_come_on_top_or_in_place_of_all(tmp_path: Path) -> None:
    ob = build("walk.amc", "filter")
    operators.stack_export(filepath=str(tmp_path / "a.toml"))
    operators.stack_import(filepath=str(tmp_path / "a.toml"))
    assert [entry.kind for entry in ob.motion_theater.entries] == ["TRACK", "FILTER"] * 2
    operators.stack_import(filepath=str(tmp_path / "a.toml"), replace=True)
    assert [entry.kind for entry in ob.motion_theater.entries] == ["TRACK", "FILTER"]
    operators.entry_remove()
    operators.entry_remove()
    assert ob.animation_data is None or ob.animation_data.action is None, "the base is still that of before"


def test_importing_a_stack_is_one_undo_step(tmp_path: Path) -> None:
    build("walk.amc", "filter")
    path = str(tmp_path / "a.toml")
    operators.stack_export(filepath=path)
    bpy.ops.ed.undo_push(message="Before")
    before = harness.snapshot()
    operators.stack_import("EXEC_DEFAULT", True, filepath=path, replace=True, set_rate=True)
    after = harness.snapshot()
    bpy.ops.ed.undo()
    assert harness.snapshot() == before
    bpy.ops.ed.redo()
    assert harness.snapshot() == after


def test_another_rate_is_said_and_the_scene_keeps_its_own(tmp_path: Path) -> None:
    ob = build("walk.amc")
    operators.stack_export(filepath=str(tmp_path / "a.toml"))
    bpy.context.scene.render.fps = 24
    operators.stack_import(filepath=str(tmp_path / "a.toml"), replace=True)
    assert "The stack was made for 30 frames per second, the scene has 24" in ob.motion_theater.message
    assert bpy.context.scene.render.fps == 24


def test_what_a_stack_file_cannot_hold_is_said_or_refused(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    ob = build("walk.amc")
    curve = harness.fcurves(ob)['pose.bones["root"].location', 0]
    curve.keyframe_points[3].co.y += 1.0
    curve.update()
    harness.refusal(lambda: operators.filter(kind="MEDIAN", depth=3))
    operators.keep_edits()
    capfd.readouterr()
    operators.stack_export(filepath=str(tmp_path / "a.toml"))
    assert "Edits by hand have no place in a stack file: left out Kept Edits" in capfd.readouterr().out
    operators.pack_sources()
    said = harness.refusal(lambda: operators.stack_export(filepath=str(tmp_path / "b.toml")))
    assert said == "“walk” is packed, and a stack file names files: unpack the sources first"
    assert not (tmp_path / "b.toml").exists()


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "a.toml has no entries"),
        ("rate_hz = = 3", "a.toml, line 1, column 11"),
        ('[[entries]]\nsource = "none.amc"', "none.amc cannot be read"),
        ("[[entries]]\nname = 'Wave'", "Wave: there is no source"),
        ('[[entries]]\nsource = "SRC"\nbones = ["tail"]', "“human” has no bone tail"),
        ('[[entries]]\nsource = "SRC"\ncut_end = 99999999999', "cut_end makes no sense: 99999999999"),
        ('[[entries]]\nsource = "SRC"\nrate_hz = inf', "rate_hz makes no sense"),
        ('[[entries]]\nsource = "SRC"\n[[entries]]\nkind = "FILTER"', "Entry 2: filter_kind is missing"),
        ('[[entries]]\nsource = "SRC"\n[[entries]]\nkind = "FILTER"\nfilter_kind = "MEDIAN"\ndepth = 4', "odd number"),
        ('[[entries]]\nkind = "KEPT"', "unknown variant `KEPT`"),
    ],
)
def test_a_wrong_file_is_met_with_words_and_changes_nothing(tmp_path: Path, text: str, expected: str) -> None:
    build("walk.amc")
    path = tmp_path / "a.toml"
    path.write_text(text.replace("SRC", str(harness.TESTDATA / "walk.amc")))
    before = harness.snapshot()
    assert expected in harness.refusal(lambda: operators.stack_import(filepath=str(path), replace=True))
    assert harness.snapshot() == before


def test_a_file_that_is_no_text_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes(b"\xff\xfe\x00")
    said = harness.refusal(lambda: operators.stack_import(filepath=str(tmp_path / "a.toml")))
    assert said == "a.toml: a stack file is UTF-8 text, and this is none"


def test_only_an_armature_with_entries_has_a_stack_to_export() -> None:
    assert not operators.stack_export.poll()
    harness.import_human()
    assert not operators.stack_export.poll()
