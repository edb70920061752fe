"""*Play*: one, four or nine clips at a time, each on a stage of its own that turns with the 3D View."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

from ..library import bodies, rows, session
from ..logic.library import clock, figures
from ..logic.library.marks import Marks
from ..logic.library.pages import Pages
from ..logic.library.rect import Rect, cells
from ..translations import text
from . import look, transport
from .performance import CAPS, Performance
from .tile import line

if TYPE_CHECKING:
    import motion_theater

    from .canvas import Canvas
    from .view import Host, Input, Window

NAME_HEIGHT = 40.0
"""Below each figure, for its name and what is known of it."""
# Keys that the 3D View gets while the stage is open: to look around. What is hidden below is safe from the others.
LOOKING = (
    "MOUSEMOVE",
    "INBETWEEN_MOUSEMOVE",
    "MIDDLEMOUSE",
    "WHEEL",
    "TRACKPAD",
    "MOUSEROTATE",
    "NDOF",
    "NUMPAD",
    "TIMER",
    "WINDOW",
    "ACCENT_GRAVE",
    "LEFT_",
    "RIGHT_",
    "OSKEY",
    "F1",
    "F2",
    "F9",
)


class StageView:
    """What plays, when, and how the mouse and the keys act on it."""

    def __init__(self, host: Host, size: int) -> None:
        self.host = host
        self.pages = Pages(len(session.state.ids), size, max(0, session.state.active))
        self.clock = clock.Clock()
        self.follows = True
        """Whether figures stay in the middle while the floor passes below them."""
        self.places: list[Rect] = []
        self.area = Rect(0, 0, 0, 0)
        self.free = Rect(0, 0, 0, 0)
        self.transport = transport.Transport(self)
        self.performance = Performance()
        self.began = False

    # -- What plays ---------------------------------------------------------------------------------------------------

    @property
    def is_single(self) -> bool:
        """Whether one clip is open."""
        return self.pages.size == 1

    @property
    def clip(self) -> motion_theater.LibraryClip | None:
        """The selected clip."""
        return rows.active()

    def body(self) -> figures.Body | None:
        """Return the figure of the selected clip, as soon as it is read."""
        clip = self.clip
        found = bodies.get(clip) if clip is not None else None
        return found if isinstance(found, figures.Body) else None

    def marks(self) -> Marks | None:
        """Return the marks of the clip that is open."""
        clip, body = self.clip, self.body()
        if clip is None or body is None:
            return None
        none = Marks(body.first_frame, body.first_frame + body.frames - 1)
        return session.state.marks.get(clip.id, none)

    def mark(self, marks: Marks) -> None:
        """Set the marks of the clip that is open."""
        if self.clip is not None:
            session.state.marks[self.clip.id] = marks

    def frame(self, body: figures.Body, now: float) -> float:
        """Return the frame of a clip that is shown, counted from 0."""
        return clock.frame_at(self.clock.position(now), body.frames, body.rate_hz)

    def _set_clock(self, shown: list[figures.Body], now: float) -> None:
        """Let playback take as long as the longest clip, or from mark to mark of a single one."""
        self.clock.duration_s = max((clock.seconds(body.frames, body.rate_hz) for body in shown), default=0.0)
        self.clock.start_s = 0.0
        marks = self.marks() if self.is_single else None
        if marks is not None and shown:
            begin, end = marks.range
            rate = shown[0].rate_hz
            self.clock.start_s = (begin - marks.first) / rate
            self.clock.duration_s = max(self.clock.start_s, (end - marks.first) / rate)
        if shown and not self.began:
            self.began = True
            self.clock.play(now)

    # -- Drawing ------------------------------------------------------------------------------------------------------

    def draw(self, canvas: Canvas, window: Window) -> None:
        """Draw the stages and the controls below them."""
        self.free = window.free
        self.pages = Pages(len(session.state.ids), self.pages.size, min(self.pages.first, len(session.state.ids)))
        if session.state.active not in self.pages.shown:
            session.state.active = self.pages.first if self.pages.shown else -1
        height = self.transport.height(canvas.scale)
        self.area = window.free._replace(y=window.free.y + height, height=window.free.height - height)
        self.places = cells(self.area.inset(3 * canvas.scale), self.pages.size, 4 * canvas.scale)
        canvas.box(window.region, look.CELL)
        clips = [rows.get(int(session.state.ids[index])) for index in self.pages.shown]
        shown = [bodies.get(clip) if clip is not None else None for clip in clips]
        self._set_clock([body for body in shown if isinstance(body, figures.Body)], window.now)
        cast = list(zip(self.places, self.pages.shown, clips, shown, strict=False))
        for place, index, *_ in cast if not self.is_single else ():
            border = look.ACCENT_HOVERED if index == session.state.active else look.LINE
            canvas.frame(place, border, 1.5 * canvas.scale, 4 * canvas.scale, look.CELL)
        self.performance.draw(
            canvas,
            window,
            [
                (_picture(place, canvas.scale), body, self.frame(body, window.now))
                for place, _, _, body in cast
                if isinstance(body, figures.Body)
            ],
            cap=CAPS[self.pages.size],
            follows=self.follows,
        )
        for place, _, clip, body in cast:
            self._draw_caption(canvas, window, place, clip, body)
        if not clips:
            x, y = self.area.middle
            canvas.text(x, y, text("No clips are shown"), look.TEXT_DIM, 12, align="CENTER")
        self.transport.draw(canvas, window)

    def _draw_caption(
        self,
        canvas: Canvas,
        window: Window,
        place: Rect,
        clip: motion_theater.LibraryClip | None,
        body: figures.Body | str | None,
    ) -> None:
        """Write the name and what is known below a figure, or what there is instead of one."""
        scale = canvas.scale
        if not isinstance(body, figures.Body):
            message = body if body is not None else text("Reading…")
            _draw_words(canvas, _picture(place, scale), message, is_error=body is not None)
        if clip is None:
            return
        shown = line(clip)
        if isinstance(body, figures.Body):
            number = body.first_frame + round(self.frame(body, window.now))
            shown = text("{facts}   frame {frame}", facts=shown, frame=number)
        x, wide = place.middle[0], place.width - 12 * scale
        canvas.text(x, place.y + 23 * scale, clip.name, look.TEXT, 12.5, width=wide, align="CENTER")
        canvas.text(x, place.y + 8 * scale, shown, look.TEXT_DIM, 10, width=wide, align="CENTER")

    # -- Events -------------------------------------------------------------------------------------------------------

    def take(self, event: Input) -> bool:
        """Take what belongs to the stage; looking around goes to the view."""
        if self.transport.take(event):
            return True
        if not event.is_over:
            return False
        if event.kind in {"LEFTMOUSE", "RIGHTMOUSE"}:
            return self._click(event)
        if event.is_press and not (event.ctrl or event.alt) and self._key(event):
            return True
        return not (event.ctrl or event.alt or event.kind.startswith(LOOKING))

    def _click(self, event: Input) -> bool:
        index = next((k for k, place in enumerate(self.places) if place.contains(event.x, event.y)), None)
        if event.is_press and index is not None and index < len(self.pages.shown):
            session.choose(self.pages.shown[index])
            if event.kind == "RIGHTMOUSE":
                self.host.menu("MOTION_THEATER_MT_library_clip")
            elif event.value == "DOUBLE_CLICK" and not self.is_single:
                self.resize(1)
        return True

    def _key(self, event: Input) -> bool:
        keys = {
            "SPACE": "PLAY",
            "LEFT_ARROW": "STEP_BACK",
            "RIGHT_ARROW": "STEP_ON",
            "UP_ARROW": "FASTER",
            "DOWN_ARROW": "SLOWER",
            "HOME": "STOP",
            "PAGE_UP": "PAGE_BACK",
            "PAGE_DOWN": "PAGE_ON",
            "I": "BEGIN",
            "O": "END",
            "U": "USABLE",
            "ONE": "ONE",
            "FOUR": "FOUR",
            "NINE": "NINE",
            "P": "FOLLOW",
            "RET": "ADD",
            "NUMPAD_ENTER": "ADD",
            "N": "IMPORT" if event.shift else "",
            "ESC": "LEAVE",
        }
        name = keys.get(event.kind)
        if not name:
            return False
        self.transport.do(name, event.now)
        return True

    def resize(self, size: int) -> None:
        """Show one, four or nine clips, the selected one first."""
        self.pages = Pages(len(session.state.ids), size, max(0, session.state.active))
        self.began = False

    def turn(self, by: int) -> None:
        """Go on or back by a page."""
        turned = self.pages.turned(by)
        if turned != self.pages:
            self.pages, self.began = turned, False
            self.clock.stop()
            session.choose(turned.first)

    def is_moving(self, now: float) -> bool:
        """Return whether something plays."""
        return self.clock.is_playing

    def help(self) -> list[tuple[str, str]]:
        """Return keys and what they do."""
        keys = [(text("Space"), text("Play / Pause")), (text("Arrows"), text("Step, Speed"))]
        if self.is_single:
            keys += [("I / O", text("Mark In / Out")), ("U", text("Mark Usable"))]
        else:
            keys += [(text("Double-Click"), text("Open"))]
        return [
            *keys,
            (text("Page Up / Down"), text("Other Clips")),
            ("1 / 4 / 9", text("At a Time")),
            (text("Enter"), text("Add as Track")),
            (text("Middle Mouse, Wheel"), text("Look Around")),
            (text("Esc"), text("Back")),
        ]


def _picture(place: Rect, scale: float) -> Rect:
    """Return the part of a stage above the name."""
    inner = place.inset(2 * scale)
    return Rect(inner.x, inner.y + NAME_HEIGHT * scale, inner.width, inner.height - NAME_HEIGHT * scale)


def _draw_words(canvas: Canvas, area: Rect, message: str, *, is_error: bool) -> None:
    """Write a message in the middle of a stage."""
    scale = canvas.scale
    x, y = area.middle
    lines = textwrap.wrap(message, max(20, int(area.width / (7.5 * scale))))[:8]
    for number, words in enumerate(lines):
        ink = look.ALERT if is_error else look.TEXT_DIM
        place = y + (len(lines) / 2 - number) * 16 * scale
        canvas.text(x, place, words, ink, 11, width=area.width - 16 * scale, align="CENTER")
