"""Whatever a file holds, an operator says one sentence and leaves the scene as it was."""

from __future__ import annotations

import os
import random
from collections.abc import Callable
from pathlib import Path

import bpy
import pytest

from tests import harness

ASF = (harness.TESTDATA / "human.asf").read_bytes()
AMC = (harness.TESTDATA / "wave.amc").read_bytes()
noise = random.Random(20041).randbytes(4096)


def bones(count: int, hierarchy: str) -> bytes:
    """Return a skeleton of that many bones in a row, with a hierarchy given as text."""
    data = "".join(
        f"  begin\n id {number}\n name b{number}\n direction 0 1 0\n length 1\n axis 0 0 0 XYZ\n dof rx\n  end\n"
        for number in range(1, count + 1)
    )
    head = ASF.decode().partition(":bonedata")[0]
    return f"{head}:bonedata\n{data}:hierarchy\n  begin\n{hierarchy}  end\n".encode()


BAD_SKELETONS: dict[str, bytes] = {
    "empty": b"",
    "noise": noise,
    "noise after a good beginning": ASF[:700] + noise,
    "a motion": AMC,
    "a picture": b"\x89PNG\r\n\x1a\n" + noise,
    "UTF-16": ASF.decode().encode("utf-16"),
    "NaN length": ASF.replace(b"length 7.5", b"length nan", 1),
    "infinite direction": ASF.replace(b"direction 0.34202", b"direction inf", 1),
    "huge length": ASF.replace(b"length 7.5", b"length 1e400", 1),
    "a word for a number": ASF.replace(b"length 7.5", b"length long", 1),
    "duplicate bones": ASF.replace(b"name rfemur", b"name lfemur", 1),
    "unknown bone in the hierarchy": ASF.replace(b"lhipjoint lfemur", b"lhipjoint tail", 1),
    "a cycle": bones(3, "root b1\n b1 b2\n b2 b3\n b3 b1\n"),
    "a bone with two parents": bones(3, "root b1 b2\n b1 b3\n b2 b3\n"),
    "unknown dof": ASF.replace(b"dof rx ry rz", b"dof rx ry qq", 1),
    "no bones": ASF.partition(b":bonedata")[0],
}
BAD_MOTIONS: dict[str, bytes] = {
    "empty": b"",
    "noise": noise,
    "noise after a good beginning": AMC[:900] + noise,
    "a skeleton": ASF,
    "no frames": b":FULLY-SPECIFIED\n:DEGREES\n",
    "UTF-16": AMC.decode().encode("utf-16"),
    "NaN": AMC.replace(b"\nroot ", b"\nroot nan ", 1),
    "infinity": AMC.replace(b"\nlfemur ", b"\nlfemur inf ", 1),
    "huge number": AMC.replace(b"\nlfemur ", b"\nlfemur 1e999 ", 1),
    "too many values": AMC.replace(b"\nlfemur ", b"\nlfemur 1 2 3 4 5 ", 1),
    "unknown bone": AMC.replace(b"\nlfemur ", b"\ntail "),
    "a bone twice": AMC.replace(b"\nlfemur ", b"\nrfemur "),
    "rate of zero": AMC.replace(b":SAMPLES-PER-SECOND 60", b":SAMPLES-PER-SECOND 0", 1),
}


def truncated(data: bytes, count: int) -> list[bytes]:
    """Return a file cut off at places spread over it, and in the middle of its last numbers."""
    return [data[: len(data) * part // count] for part in range(1, count)] + [data[:-2], data[:-9]]


def refused_unchanged(call: Callable[[], object]) -> str:
    before = harness.snapshot()
    message = harness.refusal(call)
    assert harness.snapshot() == before
    return message


def import_skeleton(path: Path) -> Callable[[], object]:
    return lambda: bpy.ops.motion_theater.import_skeleton(filepath=str(path))


def add_track(path: Path, **options: object) -> Callable[[], object]:
    return lambda: bpy.ops.motion_theater.add_track(filepath=str(path), **options)


@pytest.mark.parametrize("case", BAD_SKELETONS)
def test_a_bad_skeleton_leaves_nothing(tmp_path: Path, case: str) -> None:
    path = tmp_path / "bad.asf"
    path.write_bytes(BAD_SKELETONS[case])
    assert "bad.asf" in refused_unchanged(import_skeleton(path))
    motion = tmp_path / "wave.amc"
    motion.write_bytes(AMC)
    assert "bad.asf" in refused_unchanged(add_track(motion, skeleton=str(path)))


def test_beside_a_bad_skeleton_the_default_one_stands_in_and_that_is_said(tmp_path: Path) -> None:
    (tmp_path / "bad.asf").write_bytes(BAD_SKELETONS["a cycle"])
    motion = tmp_path / "wave.amc"
    motion.write_bytes(AMC)
    add_track(motion)()
    assert "default skeleton" in harness.armature().motion_theater.message


@pytest.mark.parametrize("case", BAD_MOTIONS)
def test_a_bad_motion_leaves_the_armature_as_it_was(tmp_path: Path, case: str) -> None:
    path = tmp_path / "bad.amc"
    path.write_bytes(BAD_MOTIONS[case])
    (tmp_path / "human.asf").write_bytes(ASF)
    assert "bad.amc" in refused_unchanged(add_track(path))
    ob = harness.import_human()
    harness.add("walk.amc")
    harness.select(ob, ["lfemur"])
    bpy.ops.object.mode_set(mode="POSE")
    assert "bad.amc" in refused_unchanged(add_track(path))
    assert "bad.amc" in refused_unchanged(add_track(path, selected_only=True, rate="SCENE", scene_range="FIT"))


def test_a_file_cut_off_anywhere_is_refused_or_read(tmp_path: Path) -> None:
    ob = harness.import_human()
    path = tmp_path / "cut.asf"
    for data in truncated(ASF, 40):
        path.write_bytes(data)
        before = harness.snapshot()
        try:
            bpy.ops.motion_theater.import_skeleton(filepath=str(path))
        except RuntimeError as error:
            assert "cut.asf" in str(error)
            assert harness.snapshot() == before
        else:
            bpy.ops.object.delete()
            bpy.context.view_layer.objects.active = ob
    path = tmp_path / "cut.amc"
    for data in truncated(AMC, 40):
        path.write_bytes(data)
        before = harness.snapshot()
        try:
            bpy.ops.motion_theater.add_track(filepath=str(path))
        except RuntimeError as error:
            assert "cut.amc" in str(error)
            assert harness.snapshot() == before
        else:
            harness.module("stack").remove_entry(ob, 0)


def test_files_that_cannot_be_opened_are_told_apart(tmp_path: Path) -> None:
    missing, folder = tmp_path / "missing.amc", tmp_path / "folder.amc"
    folder.mkdir()
    assert "No such file" in refused_unchanged(add_track(missing))
    assert "folder.amc" in refused_unchanged(add_track(folder))
    assert "missing.amc" in refused_unchanged(import_skeleton(missing))
    assert "folder.amc" in refused_unchanged(import_skeleton(folder))
    harness.import_human()
    assert "No such file" in refused_unchanged(add_track(missing))
    assert "folder.amc" in refused_unchanged(add_track(folder))


def test_a_file_without_permission_is_told(tmp_path: Path) -> None:
    path = tmp_path / "secret.amc"
    path.write_bytes(AMC)
    path.chmod(0)
    harness.import_human()
    if os.access(path, os.R_OK):  # root may read everything: the system's answer is played instead
        sources = harness.module("sources.files")
        original = sources.motion_theater.read
        sources.motion_theater.read = lambda path: (_ for _ in ()).throw(PermissionError(13, "Permission denied", path))
        try:
            assert "Permission denied" in refused_unchanged(add_track(path))
        finally:
            sources.motion_theater.read = original
    else:
        assert "Permission denied" in refused_unchanged(add_track(path))


def test_a_file_that_vanishes_between_two_calls_is_said_and_the_motion_stays(tmp_path: Path) -> None:
    path = tmp_path / "wave.amc"
    path.write_bytes(AMC)
    ob = harness.import_human()
    bpy.ops.motion_theater.add_track(filepath=str(path))
    path.unlink()
    before = harness.keys(ob)
    assert "wave.amc" in refused_unchanged(lambda: bpy.ops.motion_theater.rebuild())
    assert "wave.amc" in refused_unchanged(lambda: bpy.ops.motion_theater.filter(kind="MEDIAN", depth=3))
    assert harness.same_keys(before, harness.keys(ob))


def test_ranges_that_make_no_sense_are_refused_in_words() -> None:
    harness.import_human()
    harness.add("walk.amc")
    wave = harness.TESTDATA / "wave.amc"
    for options in (
        {"cut_start": 50, "cut_end": 20},
        {"scale_start": 50, "scale_end": 20},
        {"cut_start": 50000},
        {"cut_start": 50000, "cut_end": 50001},
    ):
        message = refused_unchanged(add_track(wave, **options))
        assert message.startswith("wave: ")
        assert "before it starts" in message or "outside" in message


def test_an_error_of_our_own_is_one_sentence_too(monkeypatch: pytest.MonkeyPatch) -> None:
    class PanicException(BaseException):
        """Stands in for a panic of the Rust core, which is no `Exception`."""

    def panics(*_: object) -> None:
        raise PanicException("index out of bounds")

    harness.import_human()
    monkeypatch.setattr(harness.module("rebuild").motion_theater, "evaluate", panics)
    message = refused_unchanged(add_track(harness.TESTDATA / "wave.amc"))
    assert "please report it: index out of bounds" in message


def chain(folder: Path, count: int) -> Path:
    """Write a skeleton of that many bones, each the parent of the next."""
    path = folder / "deep.asf"
    rows = "root b1\n" + "".join(f" b{number} b{number + 1}\n" for number in range(1, count))
    path.write_bytes(bones(count, rows))
    return path


def test_a_deep_hierarchy_is_imported_up_to_what_blender_can_take(tmp_path: Path) -> None:
    bpy.ops.motion_theater.import_skeleton(filepath=str(chain(tmp_path, 500)))
    assert len(harness.armature().data.bones) == 501
    assert "deep.asf has 100001 bones" in refused_unchanged(import_skeleton(chain(tmp_path, 100_000)))


def test_frame_numbers_that_jump_are_said(tmp_path: Path) -> None:
    path = tmp_path / "wave.amc"
    path.write_bytes(AMC.replace(b"\n2\n", b"\n70000000000000\n", 1))
    ob = harness.import_human()
    bpy.ops.motion_theater.add_track(filepath=str(path))
    assert "Frame numbers do not ascend by one" in ob.motion_theater.message
