"""How an import ends: one message, and on an error the scene as it was."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from .. import scene
from ..logic.messages import explained

if TYPE_CHECKING:
    from bpy.types import Context, Operator


def carry_out(operator: Operator, context: Context, action: Callable[[], str]) -> set[str]:
    """Run an action that returns its message and report it; on an error report that, with nothing changed."""
    try:
        with scene.unchanged_on_error(context):
            message = action()
    except BaseException as error:
        text = explained(error)
        if text is None:
            raise
        operator.report({"ERROR"}, text)
        return {"CANCELLED"}
    operator.report({"INFO"}, message)
    return {"FINISHED"}
