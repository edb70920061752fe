"""What mouse and keys do in the drawer of pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..library import session
from ..logic.library.field import TextField
from ..logic.library.grid import Grid
from ..logic.library.rect import Rect
from . import buttons, search_bar

if TYPE_CHECKING:
    from .buttons import Placed
    from .view import Host, Input

TILE_WIDTHS = (120.0, 160.0, 210.0, 280.0)
EDGE = 7.0
"""How near the upper edge the mouse takes hold of it."""
LEAST, MOST = 0.25, 1.0
DRAG_FROM = 8.0


class Remembered:
    """What the next grid begins with."""

    share = 0.66
    """The height of the drawer, by that of the view."""
    size = 1
    scroll = 0.0


class GridInput:
    """The places of the last redraw, and how mouse and keys act on them."""

    def __init__(self, host: Host) -> None:
        session.begin()
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
