"""Where markers, joints and objects are at given scene frames, in the world, and what they are called.

Whatever moves them is followed. Where F-curves alone do, they are evaluated, which leaves the current frame alone; else
Blender goes through the frames, and the current one is put back.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .. import scene
from ..curves import read, sampled
from . import keys

if TYPE_CHECKING:
    from bpy.types import Context, Object

    from ..logic.axes import Floats


def of_set(context: Context, ob: Object, bones: Sequence[str], frames: Floats) -> Floats:
    """Return (bones, frames, 3) positions of markers in the world, NaN where they are not shown."""
    if _moved_by_locations_alone(ob, bones):
        positions: Floats = keys.sample_trajectories(ob, bones, frames)
    else:
        matrices = sampled.matrices(ob, context.scene, frames)
        numbers = [ob.pose.bones.find(bone) for bone in bones]
        positions = _shown(matrices[:, numbers].transpose(1, 0, 3, 2))
    if ob.matrix_world.is_identity:
        return positions
    world = np.array(ob.matrix_world)
    return positions @ world[:3, :3].T + world[:3, 3]


def of_objects(context: Context, objects: Sequence[Object], frames: Floats) -> Floats:
    """Return (objects, frames, 3) positions of the origins of objects in the world.

    They are NaN where an object has no size or is switched off in the viewport.
    """
    matrices = np.zeros((len(objects), len(frames), 4, 4))
    with scene.same_frame(context.scene):
        for at, frame in enumerate(frames.tolist()):
            scene.go_to(context.scene, frame)
            graph = context.evaluated_depsgraph_get()
            for number, ob in enumerate(objects):
                if not ob.hide_viewport:
                    matrices[number, at] = np.array(ob.evaluated_get(graph).matrix_world)
    return _shown(matrices)


def _moved_by_locations_alone(ob: Object, bones: Sequence[str]) -> bool:
    """Return whether the curves of location and scale decide where markers are, and nothing bends these."""
    if not sampled.shows_one_action(ob):
        return False
    curves = keys.curves_of(ob)
    own = [curves[slot] for bone in bones for slot in keys.slots(bone) if slot in curves]
    is_plain = all(not curve.mute and not len(curve.modifiers) and curve.extrapolation == "CONSTANT" for curve in own)
    posed = [ob.pose.bones[bone] for bone in bones]
    is_free = all(
        bone.parent is None
        and bone.bone.use_local_location
        and all(one.mute or one.influence == 0.0 for one in bone.constraints)
        and ((read.path(bone.name, "scale"), 0) in curves or bool(bone.scale[0]))
        for bone in posed
    )
    return is_plain and is_free


def _shown(matrices: Floats) -> Floats:
    """Return (points, frames, 3): the places of (points, frames, 4, 4) matrices, NaN where these have no size."""
    places = matrices[..., :3, 3].copy()
    places[np.abs(matrices[..., :3, :3]).max(axis=(2, 3), initial=0.0) == 0.0] = np.nan
    return places
