"""The operators behind the panel: what each does, what it says, and why it is grey."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import bpy
import pytest
from bpy.types import Object

from tests import harness
from tests.harness import import_human, module, refusal, select
from tests.panels.scenario import ARM, edit_by_hand, jumping_human, missing_source

stack, compat = module("stack"), module("compat")
operators = bpy.ops.motion_theater


def two_tracks() -> Object:
    """Return an armature with a jump on all bones and, active, a wave on one arm."""
    ob = jumping_human()
    select(ob, ARM)
    return harness.add("wave.amc", selected_only=True, scale_start=20, scale_end=80)


def entry_names(ob: Object) -> list[str]:
    return [entry.name for entry in stack.of(ob).entries]


def selected(ob: Object) -> set[str]:
    return {bone.name for bone in ob.pose.bones if compat.is_selected(bone)}


def test_a_duplicate_lies_above_its_original_and_has_its_settings() -> None:
    ob = two_tracks()
    stack.of(ob).active = 0
    operators.entry_duplicate()
    motion = stack.of(ob)
    assert len(motion.entries) == 3
    assert motion.active == 1
    assert harness.settings(motion.entries[0]) == harness.settings(motion.entries[1])


def test_removing_the_upper_track_gives_the_motion_without_it() -> None:
    without = harness.keys(jumping_human())
    harness.empty_file()
    ob = two_tracks()
    assert not harness.same_keys(harness.keys(ob), without)
    operators.entry_remove()
    assert harness.same_keys(harness.keys(ob), without)
    assert len(stack.of(ob).entries) == 1


def test_moving_down_and_up_again_is_the_identity() -> None:
    ob = two_tracks()
    names, keys = entry_names(ob), harness.keys(ob)
    operators.entry_move(direction="DOWN")
    assert entry_names(ob) == names[::-1]
    assert stack.of(ob).active == 0
    assert not harness.same_keys(harness.keys(ob), keys)
    operators.entry_move(direction="UP")
    assert entry_names(ob) == names
    assert harness.same_keys(harness.keys(ob), keys)


def test_an_entry_at_the_top_does_not_move_further() -> None:
    ob = two_tracks()
    names = entry_names(ob)
    assert operators.entry_move(direction="UP") == {"CANCELLED"}
    assert entry_names(ob) == names


def test_the_bones_of_an_entry_are_selected_alone_or_besides() -> None:
    ob = two_tracks()
    select(ob, ["head"])
    operators.entry_select_bones()
    assert selected(ob) == set(ARM)
    select(ob, ["head"])
    operators.entry_select_bones(extend=True)
    assert selected(ob) == {*ARM, "head"}


def test_selected_bones_replace_those_of_an_entry() -> None:
    ob = two_tracks()
    select(ob, ["rhumerus", "rradius"])
    operators.entry_set_bones()
    entry = stack.of(ob).entries[1]
    assert entry.bones.split("\n") == ["rhumerus", "rradius"]
    assert not entry.all_bones
    assert stack.of(ob).message == f"“{entry.name}” now acts on 2 bones"


def test_a_rebuild_of_what_is_there_changes_nothing() -> None:
    ob = two_tracks()
    keys = harness.keys(ob)
    operators.rebuild()
    assert harness.same_keys(harness.keys(ob), keys)
    assert stack.of(ob).message.startswith("Rebuilt the motion")


def test_a_rebuild_leaves_hand_edits_until_it_is_told_to_go_over_them() -> None:
    ob = jumping_human()
    edit_by_hand(ob, "lhumerus")
    edited = harness.keys(ob)
    assert "lhumerus" in refusal(operators.rebuild)
    assert harness.same_keys(harness.keys(ob), edited)
    operators.rebuild(over_edits=True)
    assert not harness.same_keys(harness.keys(ob), edited)
    assert not stack.of(ob).hand_edited


def test_kept_edits_become_an_entry_and_stay_in_the_motion() -> None:
    ob = jumping_human()
    edit_by_hand(ob, "lhumerus")
    edited = harness.keys(ob)
    operators.keep_edits()
    entry = stack.of(ob).entries[-1]
    assert entry.kind == "KEPT"
    assert entry.bones == "lhumerus"
    of_arm = harness.of_bones(["lhumerus"])
    assert harness.same_keys(harness.keys(ob), edited, of=of_arm)
    assert "lhumerus" in stack.of(ob).message


def test_a_moved_file_is_relinked(tmp_path: Path) -> None:
    ob = jumping_human()
    keys = harness.keys(ob)
    missing_source(ob, tmp_path)
    moved = tmp_path / "found_again.amc"
    shutil.copy(harness.TESTDATA / "step_and_jump.amc", moved)
    operators.relink_source(filepath=str(moved))
    entry = stack.of(ob).entries[0]
    assert Path(bpy.path.abspath(entry.source)) == moved
    assert not entry.error
    assert harness.same_keys(harness.keys(ob), keys)


def test_a_file_that_cannot_be_the_source_leaves_the_track_as_it_was(tmp_path: Path) -> None:
    ob = jumping_human()
    wrong = tmp_path / "wrong.amc"
    wrong.write_text("no motion at all\n")
    before = harness.snapshot()
    assert "wrong.amc" in refusal(lambda: operators.relink_source(filepath=str(wrong)))
    assert harness.snapshot() == before
    assert stack.of(ob).entries[0].source.endswith("step_and_jump.amc")


def test_packed_sources_do_without_their_files_and_come_back(tmp_path: Path) -> None:
    files = [shutil.copy(harness.TESTDATA / name, tmp_path) for name in ("step_and_jump.amc", "wave.amc")]
    import_human()
    for file in files:
        operators.add_track(filepath=str(file))
    ob = harness.armature()
    keys = harness.keys(ob)
    originals = [Path(file).read_bytes() for file in files]
    operators.pack_sources()
    assert "2 tracks" in stack.of(ob).message
    for file in files:
        Path(file).unlink()
    operators.rebuild()
    assert harness.same_keys(harness.keys(ob), keys)
    folder = tmp_path / "unpacked"
    folder.mkdir()
    operators.unpack_sources(directory=str(folder))
    assert [(folder / Path(file).name).read_bytes() for file in files] == originals
    assert not stack.of(ob).packed
    operators.rebuild()
    assert harness.same_keys(harness.keys(ob), keys)


def test_if_one_source_cannot_be_read_none_is_packed(tmp_path: Path) -> None:
    ob = two_tracks()
    missing_source(ob, tmp_path)
    assert "moved_away.amc" in refusal(operators.pack_sources)
    assert not stack.of(ob).packed
    assert not any(entry.packed_key for entry in stack.of(ob).entries)


def test_unpacking_never_overwrites_another_file(tmp_path: Path) -> None:
    ob = jumping_human()
    operators.pack_sources()
    other = tmp_path / "step_and_jump.amc"
    other.write_text("something else\n")
    assert "step_and_jump.amc" in refusal(lambda: operators.unpack_sources(directory=str(tmp_path)))
    assert other.read_text() == "something else\n"
    assert stack.of(ob).entries[0].packed_key


STEPS: dict[str, Callable[[Object], object]] = {
    "duplicate": lambda ob: operators.entry_duplicate("EXEC_DEFAULT", True),
    "remove": lambda ob: operators.entry_remove("EXEC_DEFAULT", True),
    "move": lambda ob: operators.entry_move("EXEC_DEFAULT", True, direction="DOWN"),
    "set bones": lambda ob: operators.entry_set_bones("EXEC_DEFAULT", True),
    "pack": lambda ob: operators.pack_sources("EXEC_DEFAULT", True),
}


@pytest.mark.parametrize("step", STEPS.values(), ids=STEPS.keys())
def test_each_action_is_one_undo_step_and_redo_gives_the_same(step: Callable[[Object], object]) -> None:
    ob = two_tracks()
    select(ob, ["rhumerus", "rradius"])
    bpy.ops.ed.undo_push(message="base")
    before = harness.snapshot()
    step(ob)
    after = harness.snapshot()
    assert after != before
    bpy.ops.ed.undo()
    assert harness.snapshot() == before
    bpy.ops.ed.redo()
    assert harness.snapshot() == after


def grey(operator: Callable[..., object]) -> str:
    """Return why an operator's button is grey."""
    assert not operator.poll()  # type: ignore[attr-defined]
    with pytest.raises(RuntimeError) as refused:
        operator()
    return str(refused.value)


ON_THE_STACK = ("entry_duplicate", "entry_remove", "entry_move", "entry_set_bones", "rebuild", "keep_edits",
                "relink_source", "pack_sources", "unpack_sources")  # fmt: skip


@pytest.mark.parametrize("name", ON_THE_STACK)
def test_without_an_armature_every_button_says_so(name: str) -> None:
    assert "Select an armature first" in grey(getattr(operators, name))


@pytest.mark.parametrize("name", ON_THE_STACK)
def test_with_an_empty_stack_every_button_says_so(name: str) -> None:
    import_human()
    assert "Add a motion track first" in grey(getattr(operators, name))


@pytest.mark.parametrize("name", [*ON_THE_STACK, "filter"])
def test_an_armature_that_cannot_be_edited_greys_every_button(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    jumping_human()
    monkeypatch.setattr(module("rig"), "writable_reason", lambda ob: "The armature is linked from another file")
    assert "linked from another file" in grey(getattr(operators, name))


def test_other_reasons_are_said_too() -> None:
    ob = jumping_human()
    select(ob, ())
    assert "The stack has one entry only" in grey(operators.entry_move)
    assert "Select the bones first" in grey(operators.entry_set_bones)
    assert "No curves were edited by hand" in grey(operators.keep_edits)
    assert "No source is packed" in grey(operators.unpack_sources)
    operators.pack_sources()
    assert "All sources are packed already" in grey(operators.pack_sources)
    operators.filter(kind="MEDIAN", depth=3, selected_only=False)
    assert "Choose a track in the list" in grey(operators.relink_source)
