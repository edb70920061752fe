"""How an import begins: with the file browser, or with a dialog of its options for a file that was dropped."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bpy.props import StringProperty

from .. import preferences

if TYPE_CHECKING:
    from bpy.types import Context, Operator


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
