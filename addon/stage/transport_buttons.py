"""The buttons below the stage: playing and paging, marks, and what can be made of the clip."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..translations import text
from .buttons import Button

if TYPE_CHECKING:
    from ..logic.library.marks import Marks
    from .stage_view import StageView


def playing(stage: StageView, now: float) -> list[Button]:
    """Return what starts, stops and steps, and what time it is."""
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
        Button(label=_time(stage, now), width=150),
    ]


def _time(stage: StageView, now: float) -> str:
    body = stage.body()
    if stage.is_single and body is not None:
        frame = body.first_frame + round(stage.frame(body, now))
        last = body.first_frame + body.frames - 1
        seconds = stage.clock.position(now)
        return text("Frame {frame} of {last}   {seconds} s", frame=frame, last=last, seconds=f"{seconds:.2f}")
    position, duration = stage.clock.position(now), stage.clock.duration_s
    return text("{now} of {all} s", now=f"{position:.2f}", all=f"{duration:.2f}")


def paging(stage: StageView) -> list[Button]:
    """Return what goes to other clips and sets how many are shown."""
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
        Button("PAGE_ON", icon="PAGE_ON", tip=text("The next clips. Page Down"), reason="" if pages.has_next else last),
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


def marking(stage: StageView) -> list[Button]:
    """Return what marks a piece of the clip that is open."""
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


def using(stage: StageView) -> list[Button]:
    """Return what is made of the clip."""
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


def _cut_words(marks: Marks | None) -> str:
    if marks is None or not marks.are_set:
        return ""
    first, last = marks.range
    return text("Cut {first}-{last}", first=first, last=last)
