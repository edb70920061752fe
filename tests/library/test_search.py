"""Searches through the module give what a filter in plain Python gives, in the order that was asked for."""

from __future__ import annotations

import re
import time
import unicodedata
from collections.abc import Callable
from pathlib import Path

import pytest

import motion_theater as mt
from tests.library.rows import make

ROWS = 3000
Filter = Callable[[mt.LibraryClip], bool]


def words(text: str | None) -> list[str]:
    """Return the words of a text of Latin letters, small and without accents."""
    letters = unicodedata.normalize("NFKD", text or "").lower()
    return re.findall(r"[a-z0-9]+", "".join(letter for letter in letters if not unicodedata.combining(letter)))


def holds(text: str | None, phrase: str, *, is_begun: bool = True) -> bool:
    """Return whether words stand next to each other in a text, the last of them perhaps only begun."""
    asked, said = words(phrase), words(text)
    windows = (said[i : i + len(asked)] for i in range(len(said) - len(asked) + 1))
    return any(
        w[:-1] == asked[:-1] and (w[-1] == asked[-1] or (is_begun and w[-1].startswith(asked[-1]))) for w in windows
    )


def has(clip: mt.LibraryClip, word: str, *, is_begun: bool = True) -> bool:
    """Return whether some text of a clip holds words."""
    texts = [clip.name, clip.folder, clip.subject, clip.description, clip.session_group, *clip.tags]
    return any(holds(text, word, is_begun=is_begun) for text in texts)


def is_seven(clip: mt.LibraryClip) -> bool:
    """Return whether the subject is the number 7."""
    return clip.subject in ("7", "07")


def is_near(value: float | None, rate: float) -> bool:
    """Return whether a rate is another but for the rounding of a frame time."""
    return value is not None and abs(value - rate) <= rate * 0.0005


FILTERS: dict[str, Filter] = {
    "": lambda c: True,
    "walk": lambda c: has(c, "walk"),
    "walk run": lambda c: has(c, "walk") and has(c, "run"),
    '"left hand"': lambda c: has(c, "left hand", is_begun=False),
    "-walk": lambda c: not has(c, "walk"),
    "walk -run -jump": lambda c: has(c, "walk") and not has(c, "run") and not has(c, "jump"),
    "w": lambda c: has(c, "w"),
    "cmu walk": lambda c: has(c, "cmu") and has(c, "walk"),
    "02_01": lambda c: has(c, "02 01"),
    "name:walk": lambda c: holds(c.name, "walk"),
    "folder:cmu -folder:02": lambda c: holds(c.folder, "cmu") and not holds(c.folder, "02"),
    'description:"fast walk"': lambda c: holds(c.description, "fast walk", is_begun=False),
    "description:none": lambda c: not c.description,
    "subject:07": is_seven,
    "subject:7 walk rate>=100 duration<10": lambda c: (
        is_seven(c) and has(c, "walk") and (c.rate_hz or 0) >= 99.95 and (c.duration_s or 99) < 10
    ),
    "-subject:7": lambda c: not is_seven(c),
    "subject:s1*": lambda c: (c.subject or "").lower().startswith("s1"),
    "subject:none": lambda c: not c.subject,
    "tag:walk": lambda c: "walk" in c.tags,
    "tag:walk -tag:fast": lambda c: "walk" in c.tags and "fast" not in c.tags,
    "tag:none": lambda c: not c.tags,
    "format:c3d": lambda c: c.format == "c3d",
    "format:bvh rate:120 duration:2..10": lambda c: (
        c.format == "bvh" and is_near(c.rate_hz, 120) and c.duration_s is not None and 2 <= c.duration_s <= 10
    ),
    "rate>=100": lambda c: c.rate_hz is not None and c.rate_hz >= 99.95,
    "rate:none": lambda c: c.rate_hz is None,
    "duration<1:30 frames>500": lambda c: (
        c.duration_s is not None and c.duration_s < 90 and c.frames is not None and c.frames > 500
    ),
    "height>1.5 height<190cm": lambda c: c.height_m is not None and 1.5 < c.height_m < 1.9,
    "rating>=3 favourite:yes": lambda c: c.rating >= 3 and c.is_favourite,
    "size<1mb size>=20kb": lambda c: 20_000 <= c.size < 1_000_000,
    "date:2004": lambda c: (c.recorded_on or "").startswith("2004"),
    "date>=2004-05 date<2007-11-20": lambda c: c.recorded_on is not None and "2004-05" <= c.recorded_on < "2007-11-20",
    "date:none -cleaned:yes": lambda c: c.recorded_on is None and c.cleaned is not True,
    "cleaned:yes": lambda c: c.cleaned is True,
    "cleaned:unknown missing:no": lambda c: c.cleaned is None and not c.is_missing,
    "missing:yes": lambda c: c.is_missing,
    "broken:yes": lambda c: c.error is not None,
    "-broken:yes -missing:yes skeleton:none": lambda c: (
        c.error is None and not c.is_missing and not c.skeleton_path and not c.skeleton_fingerprint
    ),
    "skeleton:02.asf": lambda c: (c.skeleton_path or "").endswith("/02.asf"),
    "group:a": lambda c: (c.session_group or "").lower() == "a",
    "markers>=20 -joints>1": lambda c: c.markers is not None and c.markers >= 20 and not (c.joints or 0) > 1,
    "used:yes rating>=4": lambda c: c.used_at is not None and c.rating >= 4,
    "used:no favourite:yes": lambda c: c.used_at is None and c.is_favourite,
    "used:2000w": lambda c: c.used_at is not None and c.used_at >= time.time() - 2000 * 7 * 86_400,
}


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> mt.Library:
    return make(tmp_path_factory.mktemp("library") / "clips.sqlite", ROWS)


@pytest.fixture(scope="module")
def clips(library: mt.Library) -> list[mt.LibraryClip]:
    return library.clips(range(1, ROWS + 1))


def test_every_written_query_has_a_filter_and_is_measured() -> None:
    assert Path(__file__).with_name("queries.txt").read_text().split("\n")[:-1] == list(FILTERS)


@pytest.mark.parametrize("query", FILTERS)
def test_a_search_gives_what_a_plain_filter_gives(library: mt.Library, clips: list[mt.LibraryClip], query: str) -> None:
    expected = sorted((clip for clip in clips if FILTERS[query](clip)), key=lambda clip: (clip.name.lower(), clip.id))
    assert expected, "a query that gives nothing shows nothing"
    assert library.search(query).tolist() == [clip.id for clip in expected]


KEYS: list[tuple[str, Callable[[mt.LibraryClip], object]]] = [
    ("path", lambda clip: clip.path),
    ("date", lambda clip: clip.recorded_on),
    ("modified", lambda clip: clip.modified_ns),
    ("duration", lambda clip: clip.duration_s),
    ("rate", lambda clip: clip.rate_hz),
    ("frames", lambda clip: clip.frames),
    ("size", lambda clip: clip.size),
    ("rating", lambda clip: clip.rating),
    ("used", lambda clip: clip.used_at),
]


@pytest.mark.parametrize(("sort", "key"), KEYS)
@pytest.mark.parametrize("descending", [False, True])
def test_clips_are_sorted_then_by_name_and_what_is_unknown_is_last(
    library: mt.Library,
    clips: list[mt.LibraryClip],
    sort: str,
    key: Callable[[mt.LibraryClip], object],
    descending: bool,
) -> None:
    by_name = sorted(clips, key=lambda clip: (clip.name.lower(), clip.id))
    known = sorted((clip for clip in by_name if key(clip) is not None), key=key, reverse=descending)  # type: ignore[arg-type]
    unknown = [clip for clip in by_name if key(clip) is None]
    assert library.search("", sort=sort, descending=descending).tolist() == [clip.id for clip in known + unknown]


def test_wrong_terms_and_orders_are_refused_in_words(library: mt.Library) -> None:
    with pytest.raises(
        mt.ParameterError, match="`rate>=fast`: expected a number of frames per second, such as rate>=100"
    ):
        library.search("walk rate>=fast")
    with pytest.raises(mt.ParameterError, match="`beauty`: expected one of name, path"):
        library.search(sort="beauty")


def test_the_ids_are_an_array(library: mt.Library) -> None:
    found = library.search()
    assert (found.dtype.name, found.shape) == ("int64", (ROWS,))
    assert library.search("nothingofthiskind").tolist() == []


def test_a_list_with_columns_of_its_own_describes_clips(tmp_path: Path) -> None:
    library = make(tmp_path / "clips.sqlite", 5)
    name = library.clips([1])[0].name
    table = tmp_path / "clips.csv"
    table.write_text(f"Was;Datei\nspringt;{name}\n")
    with pytest.raises(mt.ParameterError, match="expected a header"):
        library.import_index(table)
    assert library.import_index(table, {"file": "Datei", "description": "Was"}) == 1
    clip = library.clips([1])[0]
    assert (clip.description, clip.sources["description"]) == ("springt", "INDEX")
    assert library.search("springt").tolist() == [1]
