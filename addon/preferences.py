"""What a user wants every new armature and every new track to start with."""

# mypy: disable-error-code="valid-type"

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import EnumProperty

from .properties import BONE_STYLES, RATES, SCENE_RANGES

if TYPE_CHECKING:
    from bpy.types import Addon, AddonPreferences, Context, Operator


class MotionTheaterPreferences(bpy.types.AddonPreferences):
    """Defaults of the options of an import; the options have the names that the operators give them."""

    bl_idname = __package__

    bone_style: EnumProperty(
        name="Bones", description="How the bones of an imported skeleton are oriented", items=BONE_STYLES
    )
    rate: EnumProperty(
        name="Frame Rate", description="How the rate of a new track meets that of the scene", items=RATES
    )
    scene_range: EnumProperty(
        name="Scene Range",
        description="What becomes of the frame range of the scene when a track is added",
        items=SCENE_RANGES,
    )

    def draw(self, context: Context) -> None:
        """Show the defaults."""
        layout = self.layout
        layout.use_property_split = True
        column = layout.column(heading="New Skeletons")
        column.prop(self, "bone_style")
        column = layout.column(heading="New Tracks")
        column.prop(self, "rate")
        column.prop(self, "scene_range")


def get(context: Context) -> AddonPreferences | None:
    """Return the preferences; None where the add-on was registered by a script that did not enable it."""
    addon: Addon | None = context.preferences.addons.get(__package__)
    return addon.preferences if addon else None


def apply(operator: Operator, context: Context) -> None:
    """Give an operator that a user starts the preferred values of the options that its caller left open.

    Called from `invoke` only: a script gets the documented defaults, whatever the preferences are.
    """
    preferences = get(context)
    if preferences is None:
        return
    for name in MotionTheaterPreferences.__annotations__:
        if name in operator.bl_rna.properties and not operator.properties.is_property_set(name):
            setattr(operator, name, getattr(preferences, name))


CLASSES = (MotionTheaterPreferences,)
