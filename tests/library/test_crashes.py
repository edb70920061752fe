"""Processes that are killed while they scan, and processes that use one library at the same time."""

from __future__ import annotations

import random
import time
from pathlib import Path

import pytest

import motion_theater as mt
from tests.library import child
from tests.library.maker import make
from tests.library.test_scanning import scanned

CLIPS = 300
KILLS = 50


@pytest.fixture(scope="module")
def clips(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of some clips."""
    folder = tmp_path_factory.mktemp("crashes") / "clips"
    make(folder, clips=CLIPS, broken=20, share=(0.01, 0.04))
    return folder


def paths(library: mt.Library) -> list[str]:
    """Return where all clips are."""
    return [clip.path for clip in library.clips(range(1, 2 * CLIPS))]


def test_a_scan_killed_at_any_moment_leaves_a_good_library(clips: Path, tmp_path: Path) -> None:
    chance = random.Random(11)
    start = time.perf_counter()
    whole = child.start("scan", tmp_path / "whole.sqlite", clips)
    begun = time.perf_counter() - start
    assert child.end(whole) == (0, "")
    # From before the first file to after the last.
    longest = time.perf_counter() - start - begun
    counts = []
    for number in range(KILLS):
        file = tmp_path / f"{number}.sqlite"
        killed = child.start("scan", file, clips)
        time.sleep(chance.uniform(0, longest))
        killed.kill()
        child.end(killed)
        library = mt.Library(file)
        assert library.check() == []
        before = paths(library)
        assert len(set(before)) == len(before), "nothing is double"
        progress = scanned(library)
        assert (progress.new, progress.unchanged) == (CLIPS - len(before), len(before))
        assert len(set(paths(library))) == library.count() == CLIPS
        counts.append(len(before))
    assert len(set(counts)) > 1, "they were killed at different moments"


def test_two_scans_and_two_readers_at_once_end_without_an_error(clips: Path, tmp_path: Path) -> None:
    file = tmp_path / "library.sqlite"
    children = [child.start("scan", file, clips) for _ in range(2)]
    children += [child.start("read", file, CLIPS) for _ in range(2)]
    assert [child.end(one) for one in children] == [(0, "")] * 4
    library = mt.Library(file)
    assert len(set(paths(library))) == library.count() == CLIPS
    assert scanned(library).unchanged == CLIPS
