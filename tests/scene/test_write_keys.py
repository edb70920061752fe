"""Keys that are written as whole arrays, against what Blender makes of the same keys by itself."""

from __future__ import annotations

import bpy
import numpy as np
import pytest

from tests import harness


def curve_of(bag: object, name: str) -> bpy.types.FCurve:
    return harness.module("curves.write").new_curve(bag, {}, "bone", (f'["{name}"]', 0))


@pytest.mark.parametrize("frames", [[1.0, 2.0, 3.5, 9.0], [1.0, 1.005, 2.0, 3.0], [3.0, 1.0, 2.0, 4.0]])
def test_linear_keys_are_those_that_an_update_leaves(frames: list[float]) -> None:
    """In order and apart, too near each other, and out of order."""
    harness.empty_file()
    compat, write, read = (harness.module(name) for name in ("compat", "curves.write", "curves.read"))
    ob = bpy.data.objects.new("keys", bpy.data.armatures.new("keys"))
    bag = compat.ensure_bag(ob, bpy.data.actions.new("keys"))
    coordinates = np.array([(frame, frame**2) for frame in frames], np.float32).reshape(-1)

    ours, theirs = curve_of(bag, "ours"), curve_of(bag, "theirs")
    write.write_keys(ours, write.Wanted(coordinates))
    theirs.keyframe_points.add(len(frames))
    theirs.keyframe_points.foreach_set("co", coordinates)
    for point in theirs.keyframe_points:
        point.interpolation = "LINEAR"
    theirs.update()

    found, expected = read.keys(ours), read.keys(theirs)
    assert found.keys() == expected.keys()
    for name, values in expected.items():
        np.testing.assert_array_equal(found[name], values, err_msg=name)
    for frame in np.linspace(0.0, 10.0, 41):
        assert ours.evaluate(float(frame)) == theirs.evaluate(float(frame))
