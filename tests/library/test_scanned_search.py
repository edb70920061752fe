"""Searches over 3,000 clips that were really scanned give what a filter in plain Python gives."""

from __future__ import annotations

from pathlib import Path

import pytest

import motion_theater as mt
from tests.library import told
from tests.library.maker import make
from tests.library.test_scanning import BROKEN, CLIPS, scanned
from tests.library.test_search import FILTERS, Filter, has, holds, is_near

GONE = 10

SCANNED: dict[str, Filter] = {
    "format:asf": lambda c: c.format == "asf",
    "walk format:bvh": lambda c: has(c, "walk") and c.format == "bvh",
    "name:climb -format:c3d": lambda c: holds(c.name, "climb") and c.format != "c3d",
    "folder:dia": lambda c: holds(c.folder, "dia"),
    "folder:dance -folder:DÍA": lambda c: holds(c.folder, "dance") and not holds(c.folder, "dia"),
    'folder:"session 07"': lambda c: holds(c.folder, "session 07", is_begun=False),
    "muder": lambda c: has(c, "muder"),
    "mude": lambda c: has(c, "mude"),
    "subject:2": lambda c: c.subject in ("2", "02"),
    "subject:s1* cleaned:yes": lambda c: (c.subject or "").lower().startswith("s1") and c.cleaned is True,
    'subject:"THOMAS_neu"': lambda c: (c.subject or "").lower() == "thomas_neu",
    "-subject:none -subject:2": lambda c: bool(c.subject) and c.subject not in ("2", "02"),
    "skeleton:01": lambda c: (c.skeleton_path or "").endswith("/01.asf"),
    "format:amc skeleton:none": lambda c: c.format == "amc" and not c.skeleton_path and not c.skeleton_fingerprint,
    "joints:31 rate:120": lambda c: c.joints == 31 and is_near(c.rate_hz, 120),
    "joints:18..24": lambda c: c.joints is not None and 18 <= c.joints <= 24,
    "markers:41": lambda c: c.markers == 41,
    "frames:12": lambda c: c.frames == 12,
    "frames:10..20 -format:bvh": lambda c: c.frames is not None and 10 <= c.frames <= 20 and c.format != "bvh",
    "duration<0.5s": lambda c: c.duration_s is not None and c.duration_s < 0.5,
    "duration>=1 -duration>2": lambda c: c.duration_s is not None and 1 <= c.duration_s <= 2,
    "rate:..30 rate>0": lambda c: c.rate_hz is not None and 0 < c.rate_hz <= 30.015,
    "-rate:120": lambda c: not is_near(c.rate_hz, 120),
    "height>=1.6 height<1.7": lambda c: c.height_m is not None and 1.6 <= c.height_m < 1.7,
    "height:none": lambda c: c.height_m is None,
    "size>=10kb size<50kb": lambda c: 10_000 <= c.size < 50_000,
    "date:2008-07": lambda c: (c.recorded_on or "").startswith("2008-07"),
    "date<2005 group:b": lambda c: (c.recorded_on or "9") < "2005" and (c.session_group or "").lower() == "b",
    "broken:yes format:bvh": lambda c: c.error is not None and c.format == "bvh",
    "broken:no missing:yes": lambda c: c.error is None and c.is_missing,
    "tag:loop rating>=4": lambda c: "loop" in c.tags and c.rating >= 4,
    "cleaned:no -tag:none": lambda c: c.cleaned is False and bool(c.tags),
}
"""Queries that are fit for what was scanned."""

QUERIES = {**FILTERS, **SCANNED}
WRITTEN = 30


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> mt.Library:
    """A library of files that were scanned, of which people have said something, and some of which are gone since."""
    folder = tmp_path_factory.mktemp("scanned")
    known = make(folder / "clips", clips=CLIPS, broken=BROKEN, share=(0.01, 0.04))
    whole = [truth.path for truth in known if truth.broken is None and truth.format != "asf"]
    told.write_beside(folder / "clips", whole)
    library = mt.Library(folder / "library.sqlite")
    library.add_folder(folder / "clips")
    assert scanned(library).new == CLIPS
    told.edit(library, list(range(1, CLIPS + 1)))
    for path in whole[:: len(whole) // GONE][:GONE]:
        (folder / "clips" / path).unlink()
    assert scanned(library).missing == GONE
    return library


@pytest.fixture(scope="module")
def clips(library: mt.Library) -> list[mt.LibraryClip]:
    """Every row."""
    return library.clips(range(1, library.count() + 1))


def found(clips: list[mt.LibraryClip], query: str) -> list[int]:
    """Return the clips that the plain filter of a query lets through, in the order of their names."""
    passed = sorted((clip for clip in clips if QUERIES[query](clip)), key=lambda clip: (clip.name.lower(), clip.id))
    return [clip.id for clip in passed]


def test_the_library_is_that_of_the_scan(clips: list[mt.LibraryClip]) -> None:
    assert len(clips) == CLIPS
    assert all(Path(clip.path).is_absolute() and clip.content_hash for clip in clips)
    sources = {source for clip in clips for source in clip.sources.values()}
    assert sources == {"FILE", "INDEX", "SIDECAR"}


def test_most_queries_give_some_clips_and_not_all(clips: list[mt.LibraryClip]) -> None:
    telling = [query for query in QUERIES if 0 < len(found(clips, query)) < CLIPS]
    assert len(telling) > 0.8 * len(QUERIES), sorted(set(QUERIES) - set(telling))
    assert len([query for query in telling if query in SCANNED]) >= WRITTEN


@pytest.mark.parametrize("query", QUERIES)
def test_a_search_of_scanned_clips_gives_what_a_plain_filter_gives(
    library: mt.Library, clips: list[mt.LibraryClip], query: str
) -> None:
    assert library.search(query).tolist() == found(clips, query)
