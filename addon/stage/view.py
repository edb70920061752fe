"""What the grid and the stage have in common: what they are told, and what they ask of the window they lie in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from ..logic.library.rect import Rect

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .canvas import Canvas


@dataclass(frozen=True)
class Window:
    """The 3D View at one moment."""

    region: Rect
    free: Rect
    """The part that neither sidebar nor toolbar cover."""
    scale: float
    mouse: tuple[float, float]
    is_over: bool
    """Whether the mouse is in the free part."""
    now: float
    rotation: NDArray
    """(3, 3) rows: the view's right, up and backward axes in the world."""
    location: NDArray
    """(3,) what the view turns about."""
    distance: float
    has_perspective: bool


@dataclass(frozen=True)
class Input:
    """A key or a movement of the mouse; names are those of Blender's events."""

    kind: str
    value: str
    x: float
    y: float
    is_over: bool
    now: float
    text: str = ""
    ctrl: bool = False
    shift: bool = False
    alt: bool = False

    @property
    def is_press(self) -> bool:
        """Whether a key or button goes down."""
        return self.value in {"PRESS", "DOUBLE_CLICK"}


class Host(Protocol):
    """What a view may ask for."""

    def run(self, operator: str, **options: object) -> None:
        """Call an operator of ours, as one undo step, and say what came of it."""

    def menu(self, name: str) -> None:
        """Open a menu or a pop-over where the mouse is."""

    def show(self, view: View) -> None:
        """Show another view; Esc comes back to this one."""

    def leave(self) -> None:
        """Go back to the view before, or close."""

    def reason(self, operator: str) -> str:
        """Return why an operator of ours cannot be used now, or nothing."""

    def paste(self) -> str:
        """Return the text of the clipboard."""


class View(Protocol):
    """The grid or the stage."""

    def draw(self, canvas: Canvas, window: Window) -> None:
        """Draw it."""

    def take(self, event: Input) -> bool:
        """Take an event; False lets it pass through to the 3D View."""

    def is_moving(self, now: float) -> bool:
        """Return whether it must be drawn again and again."""

    def help(self) -> list[tuple[str, str]]:
        """Return keys and what they do, for the status bar."""
