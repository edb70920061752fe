"""What decides over a bone besides the curves that a stack writes: drivers, and modifiers of these curves."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from .. import compat
from ..logic.messages import listing
from . import read

if TYPE_CHECKING:
    from bpy.types import Object


def notices(ob: Object, bones: Collection[str]) -> list[str]:
    """Return what the user should know of bones whose motion is not shown as the stack makes it."""
    animation = ob.animation_data
    if animation is None:
        return []
    owner = {path: bone for bone in bones for path, _ in read.slots(bone)}
    driven = dict.fromkeys(owner[curve.data_path] for curve in animation.drivers if curve.data_path in owner)
    bag = compat.bag_of(ob, animation.action) if animation.action is not None else None
    curves = read.index(bag)
    bent = dict.fromkeys(owner[path] for (path, _), curve in curves.items() if path in owner and len(curve.modifiers))
    told = []
    if driven:
        told.append(f"Drivers decide over {listing(list(driven))}: the motion of the stack does not show there")
    if bent:
        told.append(f"F-curve modifiers change the motion of {listing(list(bent))}")
    return told
