"""The controls below the stage: a timeline with marks, playing and paging, and what can be made of the clip."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..logic.library.rect import Rect
from ..logic.library.timeline import Grip, Timeline
from ..translations import text
from . import buttons, look
from .buttons import Button, Placed

if TYPE_CHECKING:
    from ..logic.library.marks import Marks
    from .canvas import Canvas
    from .stage_view import StageView
    from .view import Input, Window

TIMELINE_HEIGHT = 30.0
REACH = 6.0
TICK_SPACING = 70.0
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
        self._draw_timeline(canvas, window, bar)
        measure = canvas.width
        self.placed = [
            *buttons.row(self._playing(window.now), inner.x, upper, scale, measure),
            *buttons.row(self._paging(), inner.x, lower, scale, measure),
            *buttons.row_to(self._marking(), inner.right, upper, scale, measure),
            *buttons.row_to(self._using(), inner.right, lower, scale, measure),
        ]
        under = buttons.at(self.placed, *window.mouse) if window.is_over and self.held is None else None
        buttons.draw(canvas, self.placed, under.button.name if under else "")
        if under is not None:
            buttons.draw_tip(canvas, under, free)

    def _draw_timeline(self, canvas: Canvas, window: Window, bar: Rect) -> None:
        scale, stage = canvas.scale, self.stage
        body, clip = stage.body(), stage.clip
        marks = stage.marks() if stage.is_single else None
        canvas.box(bar, look.FIELD, 3 * scale)
        if marks is not None and body is not None:
            self.timeline = Timeline(bar, marks.first, marks.last)
            for first, last in clip.segments if clip is not None else ():
                x, end = (self.timeline.x(min(max(frame, marks.first), marks.last)) for frame in (first, last))
                canvas.box(Rect(x, bar.y, max(2.0, end - x), 4 * scale), look.USABLE)
            begin, end = (self.timeline.x(frame) for frame in marks.range)
            if marks.are_set:
                tint = (*look.MARK[:3], 0.28)
                canvas.box(Rect(begin, bar.y, max(1.0, end - begin), bar.height), tint)
            head = marks.first + stage.frame(body, window.now)
            self._draw_ticks(canvas, bar)
            for x, is_begin in ((begin, True), (end, False)):
                _draw_mark(canvas, bar, x, is_begin=is_begin, is_set=marks.are_set)
        else:
            self.timeline = Timeline(bar, 0.0, stage.clock.duration_s)
            head = stage.clock.position(window.now)
        x = self.timeline.x(head)
        canvas.layer()
        canvas.box(Rect(x - scale, bar.y - 3 * scale, 2 * scale, bar.height + 6 * scale), look.TEXT, scale)
        canvas.icon("HEAD", Rect(x - 6 * scale, bar.top - 2 * scale, 12 * scale, 12 * scale), look.TEXT)

    def _draw_ticks(self, canvas: Canvas, bar: Rect) -> None:
        scale = canvas.scale
        for frame in self.timeline.ticks(TICK_SPACING * scale):
            x = self.timeline.x(frame)
            canvas.box(Rect(x, bar.y, 1, bar.height), (*look.TEXT_FAINT[:3], 0.5))
            if x + 34 * scale < bar.right:
                canvas.text(x + 4 * scale, bar.y + 4.5 * scale, str(frame), look.TEXT_FAINT, 9)

    def _playing(self, now: float) -> list[Button]:
        stage = self.stage
        is_playing = stage.clock.is_playing
        return [
            Button("STOP", icon="STOP", tip=text("Stop: back to the beginning. Home")),
            Button("STEP_BACK", icon="STEP_BACK", tip=text("One frame back. Left Arrow")),
            Button(
                "PLAY",
                icon="PAUSE" if is_playing else "PLAY",
                tip=text("Pause. Space") if is_playing else text("Play. Space"),
                is_on=is_playing,
                width=40,
            ),
            Button("STEP_ON", icon="STEP_ON", tip=text("One frame on. Right Arrow")),
            Button(),
            Button("SLOWER", "-", tip=text("Slower. Down Arrow"), width=22),
            Button(label=f"{stage.clock.speed:g} x", width=40),
            Button("FASTER", "+", tip=text("Faster. Up Arrow"), width=22),
            Button(),
            Button(label=self._time(now), width=150),
        ]

    def _time(self, now: float) -> str:
        stage = self.stage
        body = stage.body()
        if stage.is_single and body is not None:
            frame = body.first_frame + round(stage.frame(body, now))
            last = body.first_frame + body.frames - 1
            seconds = stage.clock.position(now)
            return text("Frame {frame} of {last}   {seconds} s", frame=frame, last=last, seconds=f"{seconds:.2f}")
        position, duration = stage.clock.position(now), stage.clock.duration_s
        return text("{now} of {all} s", now=f"{position:.2f}", all=f"{duration:.2f}")

    def _paging(self) -> list[Button]:
        stage = self.stage
        pages = stage.pages
        first, last = text("This is the first clip"), text("This is the last clip")
        return [
            Button(
                "PAGE_BACK",
                icon="PAGE_BACK",
                tip=text("The clips before. Page Up"),
                reason="" if pages.has_previous else first,
            ),
            Button(label=pages.words(), width=110),
            Button(
                "PAGE_ON", icon="PAGE_ON", tip=text("The next clips. Page Down"), reason="" if pages.has_next else last
            ),
            Button(),
            Button("ONE", "1", tip=text("One clip, with marks. 1"), is_on=pages.size == 1),
            Button("FOUR", "4", tip=text("Four clips at a time. 4"), is_on=pages.size == 4),
            Button("NINE", "9", tip=text("Nine clips at a time. 9"), is_on=pages.size == 9),
            Button(),
            Button(
                "FOLLOW",
                text("Follow"),
                tip=text("Keep figures in the middle while the floor passes below them. P"),
                is_on=stage.follows,
            ),
        ]

    def _marking(self) -> list[Button]:
        stage = self.stage
        if not stage.is_single:
            return [Button(label=text("Double-click a clip to open it"))]
        marks = stage.marks()
        not_read = "" if marks is not None else text("The clip is not read")
        unset = not_read or ("" if marks is not None and marks.are_set else text("Set an in or out mark first"))
        words = _cut_words(marks)
        return [
            *([Button(label=words)] if words else []),
            Button("BEGIN", text("In"), "BEGIN", text("Take the clip from this frame. I"), reason=not_read),
            Button("END", text("Out"), "END", text("Take the clip up to this frame. O"), reason=not_read),
            Button("CLEAR", text("Clear"), tip=text("Take the whole clip"), reason=unset),
            Button(
                "USABLE",
                text("Mark Usable"),
                "CHECK",
                text("Note in the library that this piece is usable. U"),
                reason=unset,
            ),
        ]

    def _using(self) -> list[Button]:
        stage = self.stage
        nothing = "" if stage.clip is not None else text("No clip is selected")
        back = text("Back to where you came from. Esc")
        return [
            Button(
                "ADD",
                text("Add as Track"),
                "ADD",
                text("Add this clip, from mark to mark, to the active armature. Enter"),
                is_main=True,
                reason=nothing or stage.host.reason("library_add_track"),
            ),
            Button(
                "IMPORT",
                text("Import as New"),
                tip=text("Import this clip with an armature of its own. Shift N"),
                reason=nothing or stage.host.reason("library_import"),
            ),
            Button(),
            Button("LEAVE", text("Back"), "BACK", back),
        ]

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


def _cut_words(marks: Marks | None) -> str:
    if marks is None or not marks.are_set:
        return ""
    first, last = marks.range
    return text("Cut {first}-{last}", first=first, last=last)


def _draw_mark(canvas: Canvas, bar: Rect, x: float, *, is_begin: bool, is_set: bool) -> None:
    """Draw a bracket that can be taken hold of."""
    scale = canvas.scale
    color = look.MARK if is_set else look.TEXT_FAINT
    canvas.box(Rect(x - scale, bar.y - 2 * scale, 2 * scale, bar.height + 4 * scale), color)
    foot = 6 * scale
    for y in (bar.y - 2 * scale, bar.top):
        canvas.box(Rect(x if is_begin else x - foot, y, foot, 2 * scale), color)
