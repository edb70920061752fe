"""A scan draws every clip; a library gives the pictures."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import TESTDATA


@pytest.fixture
def library(tmp_path: Path) -> mt.Library:
    """Make a library of our own clips, scanned."""
    clips = tmp_path / "clips"
    clips.mkdir()
    for name in ("human.asf", "walk.amc", "wave.amc"):
        shutil.copy(TESTDATA / name, clips / name)
    library = mt.Library(tmp_path / "library.sqlite")
    library.add_folder(clips)
    scan = library.scan()
    assert scan.wait(120.0)
    assert scan.progress().error is None
    return library


def ids(library: mt.Library) -> dict[str, int]:
    """Return the number of each clip by its name."""
    return {clip.name: clip.id for clip in library.clips(range(1, library.count() + 1))}


def test_every_clip_has_a_still_and_a_strip_that_moves(library: mt.Library) -> None:
    for name, clip in ids(library).items():
        still, strip = library.still(clip), library.strip(clip)
        assert still is not None, name
        assert strip is not None, name
        assert (still.dtype, still.shape[2]) == (np.uint8, 4)
        assert strip.frames.shape[1:] == still.shape
        assert 0.02 < (still[..., 3] > 200).mean() < 0.5, "a figure, and clear around it"
        differences = np.abs(strip.frames.astype(int) - still).mean(axis=(1, 2, 3))
        assert differences.min() < 1.0, "the still is one of the strip, but for the shades of its palette"
        if name.endswith(".amc"):
            assert len(strip.frames) > 5
            assert (strip.frames != strip.frames[0]).any()
            assert 10.0 <= strip.rate_hz <= 24.0


def test_what_is_drawn_is_kept_and_drawn_anew_when_it_is_lost(library: mt.Library, tmp_path: Path) -> None:
    again = library.scan()
    assert again.wait(120.0)
    assert again.progress().previews_total == 0
    before = library.still(ids(library)["walk.amc"])
    for path in tmp_path.glob("library-previews.sqlite*"):
        path.unlink()
    other = mt.Library(tmp_path / "library.sqlite")
    assert other.still(ids(other)["walk.amc"]) is None
    assert other.scan().wait(120.0)
    assert np.array_equal(other.still(ids(other)["walk.amc"]), before)


def test_without_previews_nothing_is_drawn(tmp_path: Path) -> None:
    shutil.copy(TESTDATA / "human.asf", tmp_path / "human.asf")
    library = mt.Library(tmp_path / "library.sqlite")
    library.add_folder(tmp_path)
    assert library.scan(with_previews=False).wait(120.0)
    assert library.still(1) is None
    assert library.strip(1) is None


def test_a_clip_that_is_not_there_is_refused(library: mt.Library) -> None:
    with pytest.raises(mt.ParameterError, match="99"):
        library.still(99)
