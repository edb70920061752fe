"""*Browse*: the clips that were found, as a drawer of stills at the bottom of the 3D View."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..library import rows, scanning, session
from ..logic.library import facts
from ..logic.library.grid import Grid
from ..logic.library.rect import Rect
from ..translations import text
from . import buttons, look, search_bar, tile
from .buttons import Button
from .grid_input import TILE_WIDTHS, GridInput, Remembered

if TYPE_CHECKING:
    from .canvas import Canvas
    from .view import Window

PICTURE_ASPECT = 4 / 3
SCROLL_BAR = 9.0


class GridView(GridInput):
    """The drawer, what is under the mouse in it, and what is being dragged."""

    def draw(self, canvas: Canvas, window: Window) -> None:
        """Draw the drawer."""
        session.ensure_open()
        self._lay_out(canvas, window)
        if session.state.ids is not self.seen:
            self.seen = session.state.ids
            self._show_active()
        self._look_under(window)
        radius = 8 * canvas.scale
        canvas.box(self.area.inset(-1), look.LINE, radius)
        canvas.box(self.area, look.BACKGROUND, radius)
        self._draw_bar(canvas)
        canvas.within(self.grid.view)
        found = session.state.ids
        played: Rect | None = None
        for index in self.grid.visible(Remembered.scroll):
            hovered_s = window.now - self.hovered_since if index == self.hovered else None
            place = self.grid.tile(index, Remembered.scroll)
            is_active = index == session.state.active
            bar = tile.draw(canvas, place, int(found[index]), is_active=is_active, hovered_s=hovered_s)
            played = played or bar
        rows.fetch()  # while this redraw goes on, so that the next one has it
        if not len(found):
            self._draw_nothing(canvas)
        if played is not None:
            canvas.layer()
            canvas.box(played, look.ACCENT_HOVERED)
        canvas.within(None)
        handle = self.grid.bar(Remembered.scroll, SCROLL_BAR * canvas.scale)
        if handle is not None:
            canvas.box(handle.inset(1.5 * canvas.scale), look.BUTTON_HOVERED, 4 * canvas.scale)
        self._draw_drag(canvas, window)
        under = buttons.at(self.placed, *window.mouse) if window.is_over and not self.dragged else None
        if under is not None:
            buttons.draw_tip(canvas, under, window.free)

    def _lay_out(self, canvas: Canvas, window: Window) -> None:
        scale, free = canvas.scale, window.free
        self.bounds, self.mouse = free, window.mouse
        least = (look.BAR_HEIGHT + 120) * scale
        height = min(free.height, max(least, Remembered.share * free.height))
        self.area = Rect(free.x + 6 * scale, free.y + 6 * scale, free.width - 12 * scale, height - 12 * scale)
        below = self.area.height - look.BAR_HEIGHT * scale
        view = Rect(self.area.x, self.area.y + 2, self.area.width - SCROLL_BAR * scale, below - 4)
        width = TILE_WIDTHS[Remembered.size] * scale
        tall = width / PICTURE_ASPECT + tile.CAPTION * scale
        self.grid = Grid(view, len(session.state.ids), width, tall, look.GAP * scale)
        Remembered.scroll = self.grid.clamped(Remembered.scroll)
        middle = self.area.top - look.BAR_HEIGHT * scale / 2
        wide = min(300 * scale, 0.34 * self.area.width)
        self.search = Rect(self.area.x + 10 * scale, middle - 12 * scale, wide, 24 * scale)
        left = buttons.row(self._filters(), self.search.right + 8 * scale, middle, scale, canvas.width)
        right = buttons.row_to(self._commands(), self.area.right - 10 * scale, middle, scale, canvas.width)
        self.placed = [*left, *right]

    def _filters(self) -> list[Button]:
        set_filters = sum(1 for value in session.state.filters.values() if value)
        label = text("Filter ({count})", count=set_filters) if set_filters else text("Filter")
        return [
            Button("FILTER", label, "FILTER", text("Show clips of some kinds only"), is_on=bool(set_filters)),
            Button("SORT", text("Sort"), "SORT", text("Choose the order of the clips")),
        ]

    def _commands(self) -> list[Button]:
        nothing = "" if len(session.state.ids) else text("No clips are shown")
        return [
            Button("SMALLER", "-", tip=text("Smaller pictures. Ctrl Wheel"), width=24),
            Button("LARGER", "+", tip=text("Larger pictures. Ctrl Wheel"), width=24),
            Button(),
            Button("ONE", text("Open"), "PLAY", text("Play the selected clip. Double-click"), reason=nothing),
            Button("FOUR", text("Four"), "FOUR", text("Play four clips at a time. 4"), reason=nothing),
            Button(),
            Button(
                "ADD",
                text("Add as Track"),
                "ADD",
                text("Add the selected clip to the active armature. Enter"),
                is_main=True,
                reason=nothing or self.host.reason("library_add_track"),
            ),
            Button("CLOSE", icon="CLOSE", tip=text("Close the library. Esc")),
        ]

    def _draw_bar(self, canvas: Canvas) -> None:
        scale = canvas.scale
        search_bar.draw(canvas, self.search, self.field, is_misunderstood=bool(session.state.misunderstood))
        pressed = buttons.at(self.placed, *self.mouse)
        buttons.draw(canvas, self.placed, pressed.button.name if pressed else "")
        filters_end = max(one.area.right for one in self.placed if one.button.name == "SORT")
        commands_start = min(one.area.x for one in self.placed if one.button.name == "SMALLER")
        said, ink = self._said()
        x, room = filters_end + 12 * scale, commands_start - filters_end - 24 * scale
        canvas.text(x, self.search.y + 8 * scale, said, ink, width=max(0.0, room))

    def _said(self) -> tuple[str, tuple[float, float, float, float]]:
        state = session.state
        if state.trouble or state.misunderstood:
            return state.trouble or state.misunderstood, look.ALERT
        if scanning.is_running():
            return scanning.progress()[1], look.TEXT_DIM
        if len(state.ids) == state.total:
            return facts.count(state.total, "clip", "clips"), look.TEXT_DIM
        return text("{found} of {total} clips", found=f"{len(state.ids):,}", total=f"{state.total:,}"), look.TEXT_DIM

    def _draw_nothing(self, canvas: Canvas) -> None:
        state = session.state
        if state.folders and state.total:
            said = text("No clip is like that: change the search or the filter")
        elif scanning.is_running():
            said = text("Looking for clips…")
        elif state.folders:
            said = text("There are no clips in these folders")
        else:
            said = text("Add a folder with motion capture: sidebar, tab Motion, panel Library")
        x, y = self.grid.view.middle
        canvas.text(x, y, said, look.TEXT_DIM, 12, align="CENTER")

    def _draw_drag(self, canvas: Canvas, window: Window) -> None:
        """Show what is dragged, and what letting go would do."""
        if self.dragged != "TILE" or self.area.contains(*window.mouse):
            return
        scale, (x, y) = canvas.scale, window.mouse
        said = self._drop_words() if self.bounds.contains(x, y) else text("Let go here to leave it")
        canvas.layer()
        wide = canvas.width(said) + 20 * scale
        place = Rect(x + 14 * scale, y - 30 * scale, wide, 24 * scale)
        canvas.frame(place, look.LINE, 1.0, look.RADIUS * scale, look.ACCENT)
        canvas.text(place.x + 10 * scale, place.y + 8 * scale, said, look.TEXT)

    def _drop_words(self) -> str:
        if self.host.reason("library_add_track"):
            return text("Release to import as new")
        return text("Release to add as track")

    def _look_under(self, window: Window) -> None:
        """Note which tile the mouse is on, and since when."""
        can_hover = window.is_over and not self.dragged
        index = self.grid.at(*window.mouse, Remembered.scroll) if can_hover else None
        if index != self.hovered:
            self.hovered, self.hovered_since = index, window.now

    def is_moving(self, now: float) -> bool:
        """Return whether a strip moves or a cursor blinks."""
        found = session.state.ids
        if self.field.is_active or self.dragged:
            return True
        return self.hovered is not None and self.hovered < len(found) and tile.is_moving(int(found[self.hovered]))

    def help(self) -> list[tuple[str, str]]:
        """Return keys and what they do."""
        if self.field.is_active:
            return [(text("Enter"), text("Leave the Search Box"))]
        return [
            (text("Click"), text("Select")),
            (text("Double-Click"), text("Open")),
            (text("Drag into View"), text("Add")),
            (text("Enter"), text("Add as Track")),
            ("4", text("Four at a Time")),
            (text("Ctrl F"), text("Search")),
            (text("Right-Click"), text("More")),
            (text("Esc"), text("Close")),
        ]
