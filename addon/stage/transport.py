"""The controls below the stage: a timeline with marks, playing and paging, and what can be made of the clip."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..logic.library.rect import Rect
from ..logic.library.timeline import Grip, Timeline
from . import buttons, look, timeline_bar
from . import transport_buttons as rows

if TYPE_CHECKING:
    from ..logic.library.marks import Marks
    from .buttons import Placed
    from .canvas import Canvas
    from .stage_view import StageView
    from .view import Input, Window

TIMELINE_HEIGHT = 30.0
REACH = 6.0
SIZES = {"ONE": 1, "FOUR": 4, "NINE": 9}


class Transport:
    """Buttons and timeline of a stage."""

    def __init__(self, stage: StageView) -> None:
        self.stage = stage
        self.placed: list[Placed] = []
        self.timeline = Timeline(Rect(0, 0, 0, 0), 0, 0)
        self.area = Rect(0, 0, 0, 0)
        self.held: Grip | None = None
        self.was_playing = False

    def height(self, scale: float) -> float:
        """Return how high the controls are."""
        return (TIMELINE_HEIGHT + 2 * look.BAR_HEIGHT + 10) * scale

    # -- Drawing ------------------------------------------------------------------------------------------------------

    def draw(self, canvas: Canvas, window: Window) -> None:
        """Draw timeline and buttons."""
        scale, free = canvas.scale, window.free
        self.area = Rect(free.x, free.y, free.width, self.height(scale))
        canvas.box(self.area, look.BAR)
        canvas.box(Rect(free.x, self.area.top - 1, free.width, 1), look.LINE)
        inner = self.area.inset(12 * scale)
        bar = Rect(inner.x, self.area.top - (TIMELINE_HEIGHT - 2) * scale, inner.width, 16 * scale)
        upper = self.area.y + 1.5 * look.BAR_HEIGHT * scale
        lower = self.area.y + 0.5 * look.BAR_HEIGHT * scale + 2 * scale
        marks, head = self._lay_timeline(bar, window.now)
        timeline_bar.draw(canvas, self.timeline, marks, self.stage.clip.segments if self.stage.clip is not None else ())
        measure = canvas.width
        self.placed = [
            *buttons.row(rows.playing(self.stage, window.now), inner.x, upper, scale, measure),
            *buttons.row(rows.paging(self.stage), inner.x, lower, scale, measure),
            *buttons.row_to(rows.marking(self.stage), inner.right, upper, scale, measure),
            *buttons.row_to(rows.using(self.stage), inner.right, lower, scale, measure),
        ]
        under = buttons.at(self.placed, *window.mouse) if window.is_over and self.held is None else None
        buttons.draw(canvas, self.placed, under.button.name if under else "")
        timeline_bar.draw_head(canvas, self.timeline, head)
        if under is not None:
            buttons.draw_tip(canvas, under, free)

    def _lay_timeline(self, bar: Rect, now: float) -> tuple[Marks | None, float]:
        """Lay frames, or seconds, over the bar. Return the marks, where frames are shown, and where the playhead is."""
        stage = self.stage
        body, marks = stage.body(), stage.marks() if stage.is_single else None
        if body is not None and marks is not None:
            self.timeline = Timeline(bar, marks.first, marks.last)
            return marks, marks.first + stage.frame(body, now)
        self.timeline = Timeline(bar, 0.0, stage.clock.duration_s)
        return None, stage.clock.position(now)

    # -- Events -------------------------------------------------------------------------------------------------------

    def take(self, event: Input) -> bool:
        """Take presses on the controls, and the mouse as long as it holds the timeline."""
        if self.held is not None:
            if event.kind == "LEFTMOUSE" and event.value == "RELEASE":
                self.held = None
                if self.was_playing:
                    self.stage.clock.play(event.now)
            elif event.kind == "MOUSEMOVE":
                self._pull(event)
            return not event.kind.startswith("TIMER")
        if not event.is_over or not self.area.contains(event.x, event.y):
            return False
        if event.kind != "LEFTMOUSE":
            return event.kind in {"RIGHTMOUSE", "MIDDLEMOUSE"} or event.kind.startswith("WHEEL")
        if not event.is_press:
            return True
        under = buttons.at(self.placed, event.x, event.y)
        if under is not None:
            if not under.button.reason:
                self.do(under.button.name, event.now)
            return True
        marks = self.stage.marks() if self.stage.is_single else None
        self.held = self.timeline.grip(event.x, event.y, marks, REACH)
        if self.held is not None:
            self.was_playing = self.stage.clock.is_playing
            self.stage.clock.pause(event.now)
            self._pull(event)
        return True

    def _pull(self, event: Input) -> None:
        """Move what is held, and show the frame where it is."""
        stage = self.stage
        place = self.timeline.frame(event.x)
        marks, body = stage.marks() if stage.is_single else None, stage.body()
        if marks is None or body is None:
            stage.clock.scrub(place, event.now)
            return
        if self.held == "BEGIN":
            stage.mark(marks.with_begin(place))
        elif self.held == "END":
            stage.mark(marks.with_end(place))
        stage.clock.scrub((place - marks.first) / body.rate_hz, event.now)

    def do(self, name: str, now: float) -> None:
        """Carry out what a button or a key stands for."""
        stage = self.stage
        if name == "PLAY":
            stage.clock.toggle(now)
        elif name == "STOP":
            stage.clock.stop()
        elif name in {"STEP_BACK", "STEP_ON"}:
            body = stage.body()
            step = 1 / body.rate_hz if body is not None else 0.0
            stage.clock.step(step if name == "STEP_ON" else -step, now)
        elif name in {"FASTER", "SLOWER"}:
            stage.clock.faster(1 if name == "FASTER" else -1, now)
        elif name in {"PAGE_BACK", "PAGE_ON"}:
            stage.turn(1 if name == "PAGE_ON" else -1)
        elif name in SIZES:
            stage.resize(SIZES[name])
        elif name == "FOLLOW":
            stage.follows = not stage.follows
        elif name == "LEAVE":
            stage.host.leave()
        else:
            self._use(name, now)

    def _use(self, name: str, now: float) -> None:
        """Set marks, and carry out what is made of the clip."""
        stage = self.stage
        clip, marks, body = stage.clip, stage.marks(), stage.body()
        if clip is None:
            return
        if marks is not None and body is not None and stage.is_single:
            here = marks.first + stage.frame(body, now)
            if name == "BEGIN":
                stage.mark(marks.with_begin(here))
            elif name == "END":
                stage.mark(marks.with_end(here))
            elif name == "CLEAR":
                stage.mark(marks.cleared())
            elif name == "USABLE" and marks.are_set:
                first, last = marks.range
                stage.host.run("library_mark_usable", clip=clip.id, first=first, last=last)
        begin, end = marks.cut() if marks is not None and stage.is_single else (0, 0)
        if name == "ADD":
            stage.host.run("library_add_track", clip=clip.id, cut_start=begin, cut_end=end)
        elif name == "IMPORT":
            stage.host.run("library_import", clip=clip.id)
