"""An edit tells of bones whose motion something else decides."""

from __future__ import annotations

import bpy

from tests import harness


def test_drivers_and_modifiers_on_the_stacks_bones_are_told() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    ob.pose.bones["lfemur"].driver_add("rotation_quaternion", 1).driver.expression = "0.0"
    harness.fcurves(ob)['pose.bones["ltibia"].rotation_quaternion', 2].modifiers.new("NOISE")
    ob.motion_theater.entries[0].cut_start = 20
    said = ob.motion_theater.message
    assert "Drivers decide over lfemur: the motion of the stack does not show there" in said
    assert "F-curve modifiers change the motion of ltibia" in said


def test_without_them_nothing_is_told() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    bpy.context.view_layer.update()
    ob.motion_theater.entries[0].cut_start = 20
    assert "Drivers" not in ob.motion_theater.message
    assert "modifiers" not in ob.motion_theater.message
