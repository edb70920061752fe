"""*Browse*: the clips that were found, as a drawer of stills at the bottom of the 3D View."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..library import scanning, session
from ..logic.library import facts
from ..logic.library.field import TextField
from ..logic.library.grid import Grid
from ..logic.library.rect import Rect
from ..translations import text
from . import buttons, look, search_bar, tile
from .buttons import Button, Placed

if TYPE_CHECKING:
    from .canvas import Canvas
    from .view import Host, Input, Window

TILE_WIDTHS = (120.0, 160.0, 210.0, 280.0)
PICTURE_ASPECT = 4 / 3
EDGE = 7.0
"""How near the upper edge the mouse takes hold of it."""
LEAST, MOST = 0.25, 1.0
DRAG_FROM = 8.0
SCROLL_BAR = 9.0


class Remembered:
    """What the next grid begins with."""

    share = 0.66
    """The height of the drawer, by that of the view."""
    size = 1
    scroll = 0.0


class GridView:
    """The drawer, what is under the mouse in it, and what is being dragged."""

    def __init__(self, host: Host) -> None:
        self.host = host
        self.field = TextField(session.state.words)
        self.area = Rect(0, 0, 0, 0)
        self.bounds = Rect(0, 0, 0, 0)
        self.grid = Grid(self.area, 0, 1, 1, 1)
        self.placed: list[Placed] = []
        self.search = Rect(0, 0, 0, 0)
        self.hovered: int | None = None
        self.hovered_since = 0.0
        self.dragged: str = ""
        self.drag_from = (0.0, 0.0)
        self.grabbed = 0.0
        self.mouse = (0.0, 0.0)
        self.seen = session.state.ids

    # -- Drawing ------------------------------------------------------------------------------------------------------

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
        for index in self.grid.visible(Remembered.scroll):
            hovered_s = window.now - self.hovered_since if index == self.hovered else None
            place = self.grid.tile(index, Remembered.scroll)
            is_active = index == session.state.active
            tile.draw(canvas, place, int(found[index]), is_active=is_active, hovered_s=hovered_s)
        if not len(found):
            self._draw_nothing(canvas)
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

    # -- Events -------------------------------------------------------------------------------------------------------

    def take(self, event: Input) -> bool:
        """Take what happens in the drawer; the rest of the view stays as usual."""
        self.mouse = (event.x, event.y)
        if self.dragged:
            return self._drag(event)
        if self.field.is_active and self._type(event):
            return True
        is_inside = event.is_over and (self.area.contains(event.x, event.y) or self._is_on_edge(event))
        if not is_inside:
            if event.kind == "LEFTMOUSE":
                self.field.end()
            return False
        if event.kind == "MOUSEMOVE":
            return False  # buttons and gizmos of the view must see it leave
        if event.kind == "LEFTMOUSE" and event.is_press:
            return self._press(event)
        if event.kind in {"WHEELUPMOUSE", "WHEELDOWNMOUSE"}:
            return self._wheel(event)
        if event.kind == "RIGHTMOUSE" and event.is_press:
            index = self.grid.at(event.x, event.y, Remembered.scroll)
            if index is not None:
                session.choose(index)
                self.host.menu("MOTION_THEATER_MT_library_clip")
            return True
        return self._key(event) if event.is_press else True

    def _type(self, event: Input) -> bool:
        """Give keys to the search box."""
        if not event.is_press:
            return event.kind not in {"MOUSEMOVE", "LEFTMOUSE"} and not event.kind.startswith(("TIMER", "WHEEL"))
        if event.kind in {"ESC", "RET", "NUMPAD_ENTER", "TAB"}:
            self.field.end()
            return True
        if event.kind in {"LEFTMOUSE", "RIGHTMOUSE", "MIDDLEMOUSE"} or event.kind.startswith(("WHEEL", "TIMER")):
            if event.kind == "LEFTMOUSE" and not self.search.contains(event.x, event.y):
                self.field.end()
            return False
        if event.ctrl and event.kind in {"A", "V"}:
            if event.kind == "A":
                self.field.is_all_selected = True
                return True
            self.field.insert(self.host.paste())
        elif not self.field.press(event.kind, by_word=event.ctrl):
            if not event.text or event.ctrl:
                return True
            self.field.insert(event.text)
        self._search()
        return True

    def _search(self) -> None:
        if session.state.words != self.field.text:
            session.state.words = self.field.text
            Remembered.scroll = 0.0
            session.search()

    def _is_on_edge(self, event: Input) -> bool:
        return abs(event.y - self.area.top) <= EDGE and self.area.x <= event.x < self.area.right

    def _press(self, event: Input) -> bool:
        under = buttons.at(self.placed, event.x, event.y)
        self.drag_from = (event.x, event.y)
        if under is not None:
            if not under.button.reason:
                self._do(under.button.name)
            return True
        if self.search.contains(event.x, event.y):
            if search_bar.cross(self.search).contains(event.x, event.y):
                self.field.clear()
                self._search()
            self.field.begin(select_all=event.value == "DOUBLE_CLICK")
            return True
        self.field.end()
        handle = self.grid.bar(Remembered.scroll, self.area.right - self.grid.view.right)
        index = self.grid.at(event.x, event.y, Remembered.scroll)
        if self._is_on_edge(event):
            self.dragged = "EDGE"
        elif handle is not None and event.x >= handle.x:
            self.dragged = "BAR"
            self.grabbed = event.y - handle.middle[1] if handle.contains(event.x, event.y) else 0.0
        elif index is not None:
            session.choose(index)
            if event.value == "DOUBLE_CLICK":
                self._do("ONE")
            else:
                self.dragged = "PRESSED"
        return True

    def _drag(self, event: Input) -> bool:
        """Follow the mouse with the edge, the scroll bar or a tile, until the button is let go."""
        if event.kind == "ESC" and event.is_press:
            self.dragged = ""
            return True
        if event.kind == "LEFTMOUSE" and event.value == "RELEASE":
            dropped, self.dragged = self.dragged == "TILE", ""
            is_outside = self.bounds.contains(event.x, event.y) and not self.area.contains(event.x, event.y)
            if dropped and is_outside and event.is_over:
                self._do("IMPORT" if self.host.reason("library_add_track") else "ADD")
            return True
        if event.kind != "MOUSEMOVE":
            return not event.kind.startswith("TIMER")
        if self.dragged == "EDGE" and self.bounds.height > 0:
            share = (event.y - self.bounds.y) / self.bounds.height
            Remembered.share = min(max(share, LEAST), MOST)
        elif self.dragged == "BAR":
            handle = self.grid.bar(Remembered.scroll, 1.0)
            if handle is not None:
                Remembered.scroll = self.grid.scroll_at(event.y - self.grabbed, handle.height)
        elif self.dragged == "PRESSED":
            x, y = self.drag_from
            if abs(event.x - x) + abs(event.y - y) > DRAG_FROM:
                self.dragged = "TILE"
        return True

    def _wheel(self, event: Input) -> bool:
        up = event.kind == "WHEELUPMOUSE"
        if event.ctrl:
            self._resize(1 if up else -1)
        else:
            Remembered.scroll = self.grid.clamped(Remembered.scroll + (-0.5 if up else 0.5) * self.grid.stride)
        return True

    def _key(self, event: Input) -> bool:
        active, page = session.state.active, max(1, int(self.grid.view.height // self.grid.stride))
        moves = {
            "LEFT_ARROW": (-1, 0),
            "RIGHT_ARROW": (1, 0),
            "UP_ARROW": (0, -1),
            "DOWN_ARROW": (0, 1),
        }
        if event.kind in moves:
            session.choose(self.grid.moved(max(active, 0), *moves[event.kind]))
            self._show_active()
        elif event.kind in {"PAGE_UP", "PAGE_DOWN"}:
            by = page * self.grid.stride * (-1 if event.kind == "PAGE_UP" else 1)
            Remembered.scroll = self.grid.clamped(Remembered.scroll + by)
        elif event.kind in {"HOME", "END"}:
            Remembered.scroll = 0.0 if event.kind == "HOME" else self.grid.largest_scroll
        elif event.kind == "F" and event.ctrl:
            self.field.begin()
        elif event.ctrl or event.alt:
            return False  # undo, saving: the user's own
        else:
            keys = {"RET": "ADD", "NUMPAD_ENTER": "ADD", "SPACE": "ONE", "FOUR": "FOUR", "NINE": "NINE", "ONE": "ONE"}
            self._do(keys.get(event.kind, "CLOSE" if event.kind == "ESC" else ""))
        return True

    def _do(self, name: str) -> None:
        from .stage_view import StageView

        clip = session.state.active_id
        if name == "CLOSE":
            self.host.leave()
        elif name in {"SMALLER", "LARGER"}:
            self._resize(1 if name == "LARGER" else -1)
        elif name == "FILTER":
            self.host.menu("MOTION_THEATER_PT_library_filter")
        elif name == "SORT":
            self.host.menu("MOTION_THEATER_MT_library_sort")
        elif clip is None:
            return
        elif name in {"ONE", "FOUR", "NINE"}:
            self.host.show(StageView(self.host, {"ONE": 1, "FOUR": 4, "NINE": 9}[name]))
        elif name in {"ADD", "IMPORT"}:
            self.host.run("library_add_track" if name == "ADD" else "library_import", clip=clip)

    def _resize(self, by: int) -> None:
        Remembered.size = min(max(Remembered.size + by, 0), len(TILE_WIDTHS) - 1)

    def _show_active(self) -> None:
        if session.state.active >= 0:
            Remembered.scroll = self.grid.scroll_to(session.state.active, Remembered.scroll)

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
