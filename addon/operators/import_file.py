"""How an import begins: with the file browser, or with a dialog of its options for a file that was dropped."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bpy.props import EnumProperty, FloatProperty, StringProperty

from .. import preferences, properties

if TYPE_CHECKING:
    from bpy.types import Context, Operator


class RateOptions:
    """How the time of a file meets that of the scene."""

    rate: EnumProperty(
        name="Frame Rate", description="How the rate of the file meets that of the scene", items=properties.RATES
    )
    rate_hz: FloatProperty(
        name="Samples per Second",
        description="The rate of the file, where its own is missing or wrong. Zero takes the rate of the file",
        min=0.0,
        soft_max=1000.0,
    )
    scene_range: EnumProperty(
        name="Scene Range",
        description="What becomes of the frame range of the scene",
        items=properties.SCENE_RANGES,
    )


class SizeOption:
    """How large the content of a file becomes."""

    scale: FloatProperty(
        name="Scale",
        description="Factor on the size that the file gives, which is brought to meters",
        default=1.0,
        min=1e-6,
        soft_min=0.01,
        soft_max=100.0,
    )


def path() -> object:
    """Return the property `filepath` of an operator that reads one file.

    It is not remembered: a path left from the last import would look like a dropped file.
    """
    return StringProperty(
        name="File Path",
        description="The file to import",
        maxlen=1024,
        subtype="FILE_PATH",
        options={"HIDDEN", "SKIP_PRESET", "SKIP_SAVE"},
    )


def preferred(operator: Operator, context: Context) -> None:
    """Give the options that were left open their preferred values."""
    preferences.apply(operator, context)


def ask(operator: Operator, context: Context) -> set[str]:
    """Ask for what is not known yet, with the preferred options."""
    preferred(operator, context)
    if operator.properties.is_property_set("filepath"):
        return set(context.window_manager.invoke_props_dialog(operator))
    context.window_manager.fileselect_add(operator)
    return {"RUNNING_MODAL"}
