"""Where tracks come from: packed into the .blend, written out again, moved away, found again."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import bpy
import pytest

from tests import harness

relinking, sources = harness.module("relinking"), harness.module("sources")
stack = harness.module("stack")
UserError = harness.module("logic.messages").UserError


@pytest.fixture
def clip(tmp_path: Path) -> Path:
    path = tmp_path / "walk.amc"
    shutil.copy(harness.TESTDATA / "walk.amc", path)
    return path


def walking(clip: Path) -> bpy.types.Object:
    ob = harness.import_human()
    bpy.ops.motion_theater.add_track(filepath=str(clip))
    return ob


def test_the_stack_works_when_the_skeleton_file_is_gone(tmp_path: Path, clip: Path) -> None:
    skeleton = tmp_path / "human.asf"
    shutil.copy(harness.TESTDATA / "human.asf", skeleton)
    bpy.ops.motion_theater.import_skeleton(filepath=str(skeleton))
    skeleton.unlink()
    bpy.ops.motion_theater.add_track(filepath=str(clip))
    assert len(harness.armature().motion_theater.entries) == 1


def test_a_moved_file_is_said_and_the_motion_stays(clip: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ob = walking(clip)
    entry = ob.motion_theater.entries[0]
    assert not sources.is_missing(ob, entry)
    before = harness.keys(ob)
    clip.rename(clip.with_name("elsewhere.amc"))
    monkeypatch.setattr(harness.module("sources.paths"), "MISSING_CHECK_S", 0.0)
    assert sources.is_missing(ob, entry)
    entry.cut_start = 30
    assert "walk.amc cannot be read" in entry.error
    assert "walk.amc cannot be read" in ob.motion_theater.message
    assert harness.same_keys(before, harness.keys(ob))
    bpy.ops.motion_theater.relink_source(filepath=str(clip.with_name("elsewhere.amc")))
    assert entry.error == ""
    assert not harness.same_keys(before, harness.keys(ob))
    assert not sources.is_missing(ob, entry)


def test_relinking_to_a_file_that_does_not_fit_keeps_the_old_one(tmp_path: Path, clip: Path) -> None:
    walking(clip)
    other = tmp_path / "animal.amc"
    other.write_text(clip.read_text().replace("lfemur", "tail"))
    before = harness.snapshot()
    assert "tail" in harness.refusal(lambda: bpy.ops.motion_theater.relink_source(filepath=str(other)))
    assert harness.snapshot() == before


def test_packed_sources_do_without_their_files(clip: Path) -> None:
    ob = walking(clip)
    stack.duplicate_entry(ob, 0)
    data = clip.read_bytes()
    bpy.ops.motion_theater.pack_sources()
    motion = ob.motion_theater
    assert len(motion.packed) == 1
    clip.unlink()
    before = harness.keys(ob)
    for entry in motion.entries:
        assert not sources.is_missing(ob, entry)
        entry.cut_start = 30
        assert entry.error == ""
    assert not harness.same_keys(before, harness.keys(ob))
    bpy.ops.motion_theater.unpack_sources(directory=str(clip.parent))
    assert clip.read_bytes() == data
    assert len(motion.packed) == 0
    assert {entry.source for entry in motion.entries} == {str(clip)}


def test_unpacking_never_overwrites_another_file(clip: Path) -> None:
    ob = walking(clip)
    bpy.ops.motion_theater.pack_sources()
    clip.write_text("someone else's work")
    with pytest.raises(UserError, match="is there already"):
        relinking.unpack(ob, ob.motion_theater.entries[0], str(clip))
    assert clip.read_text() == "someone else's work"
    assert ob.motion_theater.entries[0].packed_key


def test_packing_a_file_that_is_gone_is_refused(clip: Path) -> None:
    ob = walking(clip)
    clip.unlink()
    before = harness.snapshot()
    assert "walk.amc" in harness.refusal(lambda: bpy.ops.motion_theater.pack_sources())
    assert harness.snapshot() == before
    assert len(ob.motion_theater.packed) == 0


def test_a_changed_file_is_read_anew(clip: Path) -> None:
    ob = walking(clip)
    before = harness.keys(ob)
    lines = clip.read_text().splitlines()
    changed = [line.replace("lradius ", "lradius 1") if line.startswith("lradius ") else line for line in lines]
    clip.write_text("\n".join(changed) + "\n")
    os.utime(clip, ns=(1, 1))
    stack.rebuild(ob)
    assert not harness.same_keys(before, harness.keys(ob), of=harness.of_bones(["lradius"]))
    assert harness.same_keys(before, harness.keys(ob), of=harness.of_bones(["lfemur"]))


def test_a_damaged_packed_source_is_said(clip: Path) -> None:
    clip.write_text(clip.read_text() + "# packed content that was not read before\n")
    ob = walking(clip)
    sources.pack(ob, ob.motion_theater.entries[0])
    ob.motion_theater.packed[0].data = "bm90IHpsaWI="
    with pytest.raises(UserError, match=r"walk\.amc is damaged"):
        stack.rebuild(ob)
    with pytest.raises(UserError, match=r"walk\.amc is damaged"):
        relinking.unpack(ob, ob.motion_theater.entries[0], str(clip.with_name("elsewhere.amc")))
    assert not clip.with_name("elsewhere.amc").exists()
