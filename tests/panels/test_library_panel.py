"""What the sidebar shows of the library, from the first step on, and the words for what is missing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import bpy
import pytest

from tests import harness
from tests.panels.recorder import Recorder, draw
from tests.scene import library_stage as library

panels, clip_panels = harness.module("panels.library"), harness.module("panels.library_clip")
closing, session = harness.module("library.closing"), library.session


@pytest.fixture(autouse=True)
def _empty_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("MOTION_THEATER_LIBRARY", str(tmp_path / "library.sqlite"))
    yield
    closing.close()


@pytest.fixture
def clips(tmp_path: Path) -> Path:
    """A library of a few clips."""
    library.scanned(tmp_path / "clips")
    return tmp_path / "clips"


def fields() -> Any:
    return bpy.context.window_manager.motion_theater_library


def shown(panel: Any = panels.MOTION_THEATER_PT_library) -> Recorder:
    """Draw a panel once everything that it asks for is there."""
    for _ in range(3):
        layout = draw(panel, bpy.context)
        library.settle()
    return layout


def words(layout: Recorder) -> str:
    """Return all that is written, without the ends of lines."""
    return " ".join(layout.texts().split())


def test_a_newcomer_is_told_to_begin_with_a_folder() -> None:
    layout = shown()
    assert "Begin with a folder" in words(layout)
    assert layout.names("operator") == ["motion_theater.library_folder_add"]


def test_a_folder_without_clips_is_told_from_a_search_without_hits(tmp_path: Path) -> None:
    bpy.ops.motion_theater.library_folder_add(directory=str(tmp_path))
    library.settle()
    assert "There are no clips in these folders" in words(shown())


def test_it_offers_to_search_show_look_and_bring_in(clips: Path) -> None:
    layout = shown()
    assert [name for name in layout.names("prop") if name] == ["search", "show"]
    assert layout.find("motion_theater.library_browse").text == "Browse"
    assert "6 clips" in words(layout)
    fields().show = "BROKEN"
    assert "1 of 6 " in words(shown())


@pytest.mark.parametrize(
    ("view", "search", "said"),
    [
        ("ALL", "turnip", "No clip is like that: change the search"),
        ("FAVOURITES", "", "There are no favorites yet: the star beside Open makes a clip one"),
        ("RECENT", "", "Nothing was brought into a scene in the last 30 days"),
        ("MISSING", "", "No file is missing"),
        ("MISSING", "walk", "No clip is like that: change the search"),
    ],
)
def test_where_nothing_is_found_it_says_why(clips: Path, view: str, search: str, said: str) -> None:
    fields().show, fields().search = view, search
    library.settle()
    assert said in words(shown())


def test_a_wrong_term_is_named_with_what_would_be_right_and_the_box_is_red(clips: Path) -> None:
    fields().search = "walk rate>=fast"
    library.settle()
    layout = shown()
    assert "`rate>=fast`: expected a number of frames per second, such as rate>=100" in words(layout)
    assert layout.find("search").alert
    assert "No clip is like that" not in words(layout)


def test_the_clip_shows_its_facts_its_notes_and_a_way_to_its_sidecar(clips: Path) -> None:
    number = library.choose("walk.amc").id
    layout = shown(clip_panels.MOTION_THEATER_PT_library_clip)
    assert "612 (1-612)" in words(layout)
    notes = ["subject", "recorded_on", "session_group", "description", "cleaned", "also_sidecar", "tags", "rating"]
    assert layout.names("prop") == ["is_favourite", *notes]
    assert layout.find("motion_theater.sidecar_edit").properties == {"clip": number}
    menu = shown(clip_panels.MOTION_THEATER_MT_library_clip)
    assert menu.find("motion_theater.sidecar_edit").properties == {"clip": number}


def test_the_filter_has_the_views_and_every_field(clips: Path) -> None:
    layout = shown(panels.MOTION_THEATER_PT_library_filter)
    assert layout.names("prop")[0] == "show"
    assert {f"filter_{name}" for name in ("format", "tag", "used", "favourite", "broken", "missing")} <= set(
        layout.names("prop")
    )


def test_what_could_not_be_done_stands_out_until_the_next_edit(clips: Path) -> None:
    library.choose("walk.amc")
    fields().recorded_on = "yesterday"
    library.settle()
    layout = shown(clip_panels.MOTION_THEATER_PT_library_clip)
    assert "the day of the recording is a year, a month or a day such as 2004" in words(layout)
    assert any(one.alert and one.icon == "ERROR" for one in layout.shown)
    assert not any(one.alert for one in shown().shown), "it is said once, where it was typed"
    session.choose(0)
    session.say("too late", is_alarming=True, about=session.state.active_id + 1)
    assert "too late" in words(shown())
    library.choose("walk.amc")
    fields().recorded_on = "2004-05"
    library.settle()
    for panel in (panels.MOTION_THEATER_PT_library, clip_panels.MOTION_THEATER_PT_library_clip):
        assert not any(one.alert for one in shown(panel).shown)


def test_a_missing_file_can_be_described_but_its_sidecar_cannot_be_edited(clips: Path) -> None:
    (clips / "walk.amc").unlink()
    bpy.ops.motion_theater.library_scan()
    library.choose("walk.amc")
    layout = shown(clip_panels.MOTION_THEATER_PT_library_clip)
    assert "The file is not where it was" in words(layout)
    assert not layout.find("motion_theater.sidecar_edit").enabled
