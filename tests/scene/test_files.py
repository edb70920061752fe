"""The stack in saved, appended, linked and copied armatures, and the result without the extension."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

from tests import harness

stack = harness.module("stack")
compat = harness.module("compat")
UserError = harness.module("logic.messages").UserError
FRAMES = (1, 13, 40, 77)


def performing() -> bpy.types.Object:
    ob = harness.import_human()
    harness.add("walk.amc")
    harness.select(ob, ["lhumerus", "lradius"])
    harness.add("wave.amc", selected_only=True, cut_start=20, blend_depth=5)
    return ob


def edited_and_back(ob: bpy.types.Object) -> bool:
    """Return whether editing the top track changes the curves, and editing it back gives the same ones."""
    before = harness.keys(ob)
    entry = ob.motion_theater.entries[-1]
    was = entry.cut_start
    entry.cut_start = was + 20
    changed = not harness.same_keys(before, harness.keys(ob))
    entry.cut_start = was
    return changed and harness.same_keys(before, harness.keys(ob)) and ob.motion_theater.hand_edited == ""


def test_saving_and_opening(tmp_path: Path) -> None:
    before = harness.keys(performing())
    path = str(tmp_path / "saved.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    harness.empty_file()
    bpy.ops.wm.open_mainfile(filepath=path)
    ob = bpy.data.objects["human"]
    assert harness.same_keys(before, harness.keys(ob))
    assert edited_and_back(ob)


def test_appending(tmp_path: Path) -> None:
    ob = performing()
    before = harness.keys(ob)
    path = str(tmp_path / "library.blend")
    bpy.data.libraries.write(path, {ob})
    harness.empty_file()
    appended = harness.load_human(path, link=False)
    assert harness.same_keys(before, harness.keys(appended))
    assert edited_and_back(appended)


def test_linking_with_an_override(tmp_path: Path) -> None:
    ob = performing()
    before = harness.keys(ob)
    path = str(tmp_path / "library.blend")
    bpy.data.libraries.write(path, {ob})
    harness.empty_file()
    linked = harness.load_human(path, link=True)
    own = linked.override_create(remap_local_usages=True)
    own.override_library.is_system_override = False
    assert harness.same_keys(before, harness.keys(own))
    own.motion_theater.entries[1].cut_start = 50
    action = own.animation_data.action
    assert action.library is None
    assert own.motion_theater.hand_edited == ""
    assert not harness.same_keys(before, harness.keys(own))
    bpy.context.view_layer.objects.active = own
    harness.add("turn.amc", cut_start=30)
    assert [entry.name for entry in own.motion_theater.entries] == ["walk", "wave", "turn"]
    now = harness.keys(own)
    saved = str(tmp_path / "shot.blend")
    bpy.ops.wm.save_as_mainfile(filepath=saved)
    harness.empty_file()
    bpy.ops.wm.open_mainfile(filepath=saved)
    (reopened,) = (ob for ob in bpy.data.objects if ob.override_library)
    assert harness.same_keys(now, harness.keys(reopened))
    assert [entry.name for entry in reopened.motion_theater.entries] == ["walk", "wave", "turn"]
    assert edited_and_back(reopened)


def test_entries_of_the_library_stay_in_place_in_an_override(tmp_path: Path) -> None:
    path = str(tmp_path / "library.blend")
    bpy.data.libraries.write(path, {performing()})
    harness.empty_file()
    own = harness.load_human(path, link=True).override_create(remap_local_usages=True)
    own.override_library.is_system_override = False
    bpy.context.view_layer.objects.active = own

    def names() -> list[str]:
        return [entry.name for entry in own.motion_theater.entries]

    for refused in (lambda: stack.remove_entry(own, 0), lambda: stack.move_entry(own, 1, -1)):
        with pytest.raises(UserError, match="switch it off instead"):
            refused()
    assert "before it starts" in harness.refusal(lambda: harness.add("turn.amc", cut_start=5, cut_end=2))
    assert names() == ["walk", "wave"]
    harness.add("turn.amc")
    stack.duplicate_entry(own, 0)
    assert names() == ["walk", "wave", "walk", "turn"]
    stack.move_entry(own, 2, 1)
    stack.remove_entry(own, 3)
    assert names() == ["walk", "wave", "turn"]
    own.motion_theater.entries[0].enabled = False
    assert own.motion_theater.hand_edited == ""


@pytest.mark.parametrize("linked", [False, True], ids=["Shift+D", "Alt+D"])
def test_copies_of_an_armature_are_independent(linked: bool) -> None:
    ob = performing()
    before = harness.keys(ob)
    bpy.ops.object.duplicate(linked=linked)
    copy = bpy.context.view_layer.objects.active
    assert copy != ob
    assert edited_and_back(copy)
    assert edited_and_back(ob)
    copy.motion_theater.entries[1].cut_start = 50
    assert harness.same_keys(before, harness.keys(ob))
    stack.remove_entry(copy, 1)
    stack.remove_entry(copy, 0)
    assert harness.same_keys(before, harness.keys(ob))


def test_a_copy_by_script_shares_no_curves_after_an_edit() -> None:
    ob = performing()
    before = harness.keys(ob)
    copy = ob.copy()
    bpy.context.scene.collection.objects.link(copy)
    assert copy.animation_data.action == ob.animation_data.action
    copy.motion_theater.entries[1].cut_start = 50
    assert harness.same_keys(before, harness.keys(ob))
    assert not harness.same_keys(before, harness.keys(copy))


def test_an_action_of_several_slots_keeps_the_others() -> None:
    if not compat.SLOTTED:
        assert not hasattr(bpy.types.Action.bl_rna.properties, "slots")
        return
    ob = harness.import_human()
    bone = ob.pose.bones["lfemur"]
    bone.keyframe_insert("rotation_quaternion", frame=1)
    action = ob.animation_data.action
    other = bpy.data.objects.new("prop", None)
    bpy.context.scene.collection.objects.link(other)
    compat.assign(other, action)
    other.keyframe_insert("location", frame=3)
    assert {slot.name_display for slot in action.slots} >= {"human", "prop"}
    harness.add("walk.amc")
    assert other.animation_data.action == action
    assert len(harness.fcurves(other)) == 3
    stack.remove_entry(ob, 0)
    assert ob.animation_data.action == action
    assert harness.key_rows(ob, "lfemur", "rotation_quaternion").shape[0] == 1


PLAY = """
import json, sys
import bpy
import numpy as np
bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
assert not hasattr(bpy.types.Object, "motion_theater")
ob, poses = bpy.data.objects["human"], []
for frame in json.loads(sys.argv[2]):
    bpy.context.scene.frame_set(frame)
    matrices = np.empty(16 * len(ob.pose.bones), np.float32)
    ob.pose.bones.foreach_get("matrix", matrices)
    poses.append(matrices.tolist())
open(sys.argv[3], "w").write(json.dumps(poses))
import os
os._exit(0)
"""


def test_the_file_plays_without_the_extension(tmp_path: Path) -> None:
    ob = performing()
    expected = [harness.pose(ob, frame) for frame in FRAMES]
    path, out = str(tmp_path / "saved.blend"), tmp_path / "poses.json"
    bpy.ops.wm.save_as_mainfile(filepath=path)
    command = [sys.executable, "-c", PLAY, path, json.dumps(FRAMES), str(out)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env={**os.environ}, timeout=120)
    for matrices, expected_pose in zip(json.loads(out.read_text()), expected, strict=True):
        shown = np.array(matrices).reshape(-1, 4, 4).transpose(0, 2, 1)
        assert np.array_equal(shown.astype(np.float32), expected_pose.astype(np.float32))
