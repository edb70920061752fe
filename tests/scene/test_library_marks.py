"""In and out marks of clips whose frames begin at zero or below: the track has what is shown between them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np
import pytest

from tests import harness
from tests.scene import library_stage as library

closing, stage_view = harness.module("library.closing"), harness.module("stage.stage_view")
ops = bpy.ops.motion_theater
BONE = ("lhumerus", "rotation_quaternion")


@pytest.fixture(autouse=True)
def _library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("MOTION_THEATER_LIBRARY", str(tmp_path / "library.sqlite"))
    library.scanned(tmp_path / "clips")
    yield
    closing.close()


def renumbered(folder: Path, first: int) -> None:
    """Give the frames of a clip, 1 to 120, other numbers."""
    text = (folder / "wave.amc").read_text()
    (folder / "wave.amc").write_text(re.sub(r"^(\d+)$", lambda line: str(int(line[1]) + first - 1), text, flags=re.M))
    ops.library_scan()
    library.settle()


def marked(begin: int, end: int) -> dict[str, object]:
    """Open the clip, mark a piece with the keys, and return what *Add as Track* is asked for."""
    library.choose("wave.amc")
    screen = library.Screen(lambda host: stage_view.StageView(host, 1))
    screen.draw()
    screen.press("SPACE")
    body = screen.view.body()
    for key, frame in (("I", begin), ("O", end)):
        screen.view.clock.scrub((frame - body.first_frame) / body.rate_hz, screen.now)
        screen.press(key)
    screen.draw()
    screen.button("ADD")
    return screen.host.calls[-1][1]


def added(options: dict[str, object]) -> np.ndarray:
    """Add a track at the rate of the file, and return its frames with the turns of a bone."""
    ob = harness.import_human()
    ops.library_add_track(rate="SCENE", **options)
    return harness.key_rows(ob, *BONE)


@pytest.mark.parametrize(
    ("first", "begin", "end", "shown"),
    [
        (0, 0, 119, (0, 119)),
        (0, 0, 40, (0, 40)),
        (0, 20, 119, (20, 119)),
        (0, 0, 0, (0, 1)),
        (-10, -5, 30, (-5, 30)),
        (-10, 0, 30, (1, 30)),
        (-10, -10, 0, (-10, -1)),
        (-119, -50, 0, (-50, 0)),
        (-200, -150, -100, (-150, -100)),
    ],
)
def test_a_track_has_the_frames_between_the_marks(
    tmp_path: Path, first: int, begin: int, end: int, shown: tuple[int, int]
) -> None:
    whole = added({"clip": library.choose("wave.amc").id})
    renumbered(tmp_path / "clips", first)
    rows = added(marked(begin, end))
    assert (rows[0, 0], rows[-1, 0]) == shown
    before = whole[:, 0] + first - 1
    expected = whole[(before >= shown[0]) & (before <= shown[1]), 1:]
    assert np.allclose(rows[:, 1:], expected, atol=1e-6)


def test_usable_pieces_about_zero_are_noted_shown_and_kept_in_the_sidecar(tmp_path: Path) -> None:
    renumbered(tmp_path / "clips", -10)
    library.choose("wave.amc")
    bpy.context.window_manager.motion_theater_library.also_sidecar = True
    for piece in ((-10, -2), (0, 0), (0, 30)):
        ops.library_mark_usable(first=piece[0], last=piece[1])
    library.settle()
    clip = library.choose("wave.amc")
    assert clip.segments == [(-10, -2), (0, 0), (0, 30)]
    known = dict(harness.module("panels.library_clip").known(clip))
    assert (known["Frames"], known["Usable"]) == ("120 (-10 to 109)", "-10 to -2, 0-0, 0-30")
    sidecar = (tmp_path / "clips" / "wave.i3d").read_text()
    assert "Usable segments: -10 to -2, 0-0, 0-30\n" in sidecar
