"""Pictures of the tutorial: a still one with every state in rows, and a moving one with the states side by side.

    draw.picture(states, path)
    draw.preview(states, path, fps)

Only numpy and Pillow; the same states give the same files.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image

from .camera import Camera
from .chart import INK, MUTED, ROW_HEIGHT, Area, Sheet, curves, paths, timeline
from .panel import BEFORE, figure, stage_for, stages_along
from .stage import Stage
from .states import HANDS, State, hand_accelerations

RATE_HZ = 60.0
MARGIN = 14

PREVIEW_HZ = 20.0
PREVIEW_WIDTH, PREVIEW_HEIGHT = 276, 350
PREVIEW_HEAD, PREVIEW_CHART = 76, 96

PICTURE_COLUMNS = 8
PICTURE_WIDTH, PICTURE_HEIGHT = 176, 250
PICTURE_SIDE, PICTURE_CHART = 250, 150

CLOSEUP_FRAMES = 7


def preview(states: Sequence[State], path: Path | str, fps: float = RATE_HZ) -> None:
    """A moving picture: the states play side by side; `fps` is the rate of their frames."""
    frames = [int(f) for f in np.arange(0, states[0].frames, fps / PREVIEW_HZ)]
    stage = stage_for(states, PREVIEW_WIDTH, PREVIEW_HEIGHT)
    images = [_preview_frame(states, stage, frame, fps) for frame in frames]
    palette = _palette(images)
    flat = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    durations = [round(1000 / PREVIEW_HZ)] * (len(flat) - 1) + [900]
    flat[0].save(path, save_all=True, append_images=flat[1:], duration=durations, loop=0, optimize=False)


def _palette(images: Sequence[Image.Image]) -> Image.Image:
    """One palette for all frames, which keeps the still parts still; mostly from where the figures are."""
    moments = [images[round(share * (len(images) - 1))] for share in (0.0, 0.3, 0.6, 1.0)]
    third = PREVIEW_WIDTH // 3
    crops = [images[-1]] + [
        image.crop(
            (
                left + third // 2,
                PREVIEW_HEAD + 40,
                left + PREVIEW_WIDTH - third // 2,
                PREVIEW_HEAD + PREVIEW_HEIGHT - 60,
            )
        )
        for image in moments
        for left in range(MARGIN, image.width - MARGIN, PREVIEW_WIDTH + MARGIN)
    ]
    sample = Image.new("RGB", (max(crop.width for crop in crops), sum(crop.height for crop in crops)))
    top = 0
    for crop in crops:
        sample.paste(crop, (0, top))
        top += crop.height
    return sample.quantize(255, method=Image.Quantize.MEDIANCUT)


def _preview_frame(states: Sequence[State], stage: Stage, frame: int, fps: float) -> Image.Image:
    lines = PREVIEW_HEAD + PREVIEW_HEIGHT + 8
    chart = lines + max(len(state.rows) for state in states) * ROW_HEIGHT + MARGIN
    width = MARGIN + len(states) * (PREVIEW_WIDTH + MARGIN)
    sheet = Sheet(width, chart + PREVIEW_CHART + MARGIN)
    for index, state in enumerate(states):
        left = MARGIN + index * (PREVIEW_WIDTH + MARGIN)
        sheet.box(left, 12, left + 4, 66, state.tint)
        sheet.text(left + 12, 10, state.title, 16)
        sheet.paragraph(left + 12, 33, state.caption, 12, PREVIEW_WIDTH - 12, MUTED)
        timeline(sheet, Area(left, lines, PREVIEW_WIDTH), state.rows, state.frames, state.tint, frame)
    _hand_chart(sheet, Area(MARGIN, chart, width - 2 * MARGIN, PREVIEW_CHART), states, fps, frame)
    image = sheet.image()
    for index, state in enumerate(states):
        view = figure(stage, state, frame, states[index - 1] if state.shows_before else None)
        image.paste(view, (MARGIN + index * (PREVIEW_WIDTH + MARGIN), PREVIEW_HEAD))
    return image


def _hand_chart(sheet: Sheet, area: Area, states: Sequence[State], fps: float, frame: int | None) -> None:
    """How rough the hands are before and after the last state's step."""
    series = [
        (states[-2].title, hand_accelerations(states[-2], fps).max(axis=0), BEFORE),
        (states[-1].title, hand_accelerations(states[-1], fps).max(axis=0), states[-1].tint),
    ]
    curves(sheet, area, "Acceleration of the hands: spikes and noise stand out", "g", series, frame)


def _closeup(sheet: Sheet, area: Area, states: Sequence[State], camera: Camera, fps: float) -> None:
    """The path of a hand around its worst spike, before and after the last state's step."""
    accelerations = hand_accelerations(states[-2], fps)
    hand, worst = np.unravel_index(int(accelerations.argmax()), accelerations.shape)
    start, end = max(int(worst) - CLOSEUP_FRAMES, 0), min(int(worst) + CLOSEUP_FRAMES + 1, states[-1].frames)
    lines = [
        (state.trail(HANDS[int(hand)])[start:end] @ camera.axes[:2].T, colour)
        for state, colour in ((states[-2], BEFORE), (states[-1], states[-1].tint))
    ]
    paths(sheet, area, f"{('Left', 'Right')[int(hand)]} hand, frames {start + 1} to {end}", lines)


def picture(states: Sequence[State], path: Path | str, fps: float = RATE_HZ) -> None:
    """A still picture: one row per state, the same moments in every row."""
    moments = [int(m) for m in np.linspace(0, states[0].frames - 1, PICTURE_COLUMNS).round()]
    stages = stages_along(states, moments, PICTURE_WIDTH, PICTURE_HEIGHT)
    width = PICTURE_SIDE + PICTURE_COLUMNS * PICTURE_WIDTH + MARGIN
    body, step = MARGIN + 20, PICTURE_HEIGHT + MARGIN
    chart = body + len(states) * step + MARGIN
    sheet = Sheet(width, chart + PICTURE_CHART + MARGIN)
    for column, moment in enumerate(moments):
        sheet.text(PICTURE_SIDE + (column + 0.5) * PICTURE_WIDTH, MARGIN - 2, f"frame {moment + 1}", 12, MUTED, "ma")
    for index, state in enumerate(states):
        top = body + index * step
        sheet.box(MARGIN, top + 20, MARGIN + 5, top + 92, state.tint)
        sheet.text(MARGIN + 16, top + 18, state.title, 19, INK)
        sheet.paragraph(MARGIN + 16, top + 47, state.caption, 13, PICTURE_SIDE - 50, MUTED)
        timeline(sheet, Area(MARGIN, top + 120, PICTURE_SIDE - 34), state.rows, state.frames, state.tint, None)
    area = Area(PICTURE_SIDE, chart, width - PICTURE_SIDE - MARGIN, PICTURE_CHART)
    _hand_chart(sheet, area, states, fps, None)
    _closeup(sheet, Area(MARGIN, chart, PICTURE_SIDE - 34, PICTURE_CHART), states, stages[0].camera, fps)
    image = sheet.image()
    for index, state in enumerate(states):
        before = states[index - 1] if state.shows_before else None
        for column, (moment, stage) in enumerate(zip(moments, stages, strict=True)):
            view = figure(stage, state, moment, before)
            image.paste(view, (PICTURE_SIDE + column * PICTURE_WIDTH, body + index * step))
    image.save(path)
