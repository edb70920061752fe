"""The library in Blender: scanning, searching, editing, and from the library into the scene."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import bpy
import pytest

from tests import harness
from tests.scene import library_stage as library

closing = harness.module("library.closing")
ops = bpy.ops.motion_theater


@pytest.fixture(autouse=True)
def _library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("MOTION_THEATER_LIBRARY", str(tmp_path / "library.sqlite"))
    library.scanned(tmp_path / "clips")
    yield
    closing.close()


def fields() -> bpy.types.PropertyGroup:
    return bpy.context.window_manager.motion_theater_library


def test_a_folder_that_is_added_is_scanned(tmp_path: Path) -> None:
    assert library.shown() == library.NAMES
    assert library.session.state.total == len(library.NAMES)
    assert [folder.path for folder in library.session.state.folders] == [str(tmp_path / "clips")]
    assert "6 new" in library.session.state.message
    assert "1 not readable" in library.session.state.message


def test_what_is_no_folder_is_refused(tmp_path: Path) -> None:
    said = harness.refusal(lambda: ops.library_folder_add(directory=str(tmp_path / "nowhere")))
    assert "nowhere is no folder" in said


def test_a_rescan_finds_what_is_new(tmp_path: Path) -> None:
    (tmp_path / "clips" / "again.bvh").write_text((tmp_path / "clips" / "own.bvh").read_text() + "\n")
    ops.library_scan()
    assert "again.bvh" in library.shown()
    assert "1 new" in library.session.state.message


def test_a_folder_that_is_removed_takes_its_clips_along(tmp_path: Path) -> None:
    ops.library_folder_remove(folder=str(tmp_path / "clips"))
    library.settle()
    assert library.shown() == []
    assert (tmp_path / "clips" / "walk.amc").exists()


def test_the_search_box_and_the_filters_find_clips() -> None:
    fields().search = "wa"
    library.settle()
    assert library.shown() == ["walk.amc", "wave.amc"]
    fields().search = ""
    fields().filter_broken = "yes"
    library.settle()
    assert library.shown() == ["broken.bvh"]
    fields().filter_broken = "ANY"
    fields().filter_format = "bvh"
    library.settle()
    assert library.shown() == ["broken.bvh", "own.bvh"]
    fields().filter_format = "ANY"
    fields().descending = True
    library.settle()
    assert library.shown() == library.NAMES[::-1]


def test_the_views_show_favorites_recently_used_damaged_and_missing_clips(tmp_path: Path) -> None:
    library.choose("wave.amc")
    fields().is_favourite = True
    for name in ("own.bvh", "turn.amc"):
        library.session.library().mark_used(library.choose(name).id)
        time.sleep(1.1)  # the library counts in seconds
    (tmp_path / "clips" / "walk.amc").unlink()
    ops.library_scan()
    fields().sort = "size"
    for view, found in (
        ("FAVOURITES", ["wave.amc"]),
        ("RECENT", ["turn.amc", "own.bvh"]),
        ("BROKEN", ["broken.bvh"]),
        ("MISSING", ["walk.amc"]),
    ):
        fields().show = view
        library.settle()
        assert (fields().show, library.shown()) == (view, found)
    fields().show = "ALL"
    library.settle()
    assert len(library.shown()) == len(library.NAMES)
    assert (fields().sort, fields().descending) == ("size", False), "the order is what it was"
    fields().filter_used = "no"
    library.settle()
    assert "own.bvh" not in library.shown()


def test_a_search_that_makes_no_sense_says_so_and_keeps_what_was_shown() -> None:
    fields().search = "colour:red"
    library.settle()
    assert "colour" in library.session.state.misunderstood
    assert library.shown() == library.NAMES
    fields().search = ""
    library.settle()
    assert not library.session.state.misunderstood


def test_the_list_in_the_sidebar_has_a_row_for_each_clip_and_saves_none(tmp_path: Path) -> None:
    assert len(fields().rows) == len(library.NAMES)
    during: list[int] = []
    handlers = bpy.app.handlers.save_pre

    def look(*_: object) -> None:
        during.append(len(fields().rows))

    handlers.append(look)
    try:
        bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    finally:
        handlers.remove(look)
    assert during == [0]
    assert len(fields().rows) == len(library.NAMES)


def test_what_is_typed_of_a_clip_is_kept_and_can_be_searched() -> None:
    library.choose("walk.amc")
    form = fields()
    form.subject, form.description, form.tags = "Ann", "straight on", "good, slow"
    form.rating, form.is_favourite, form.cleaned = 4, True, "YES"
    library.settle()
    clip = library.choose("walk.amc")
    assert (clip.subject, clip.description, sorted(clip.tags)) == ("Ann", "straight on", ["good", "slow"])
    assert (clip.rating, clip.is_favourite, clip.cleaned) == (4, True, True)
    form.search = "subject:ann tag:good rating>=4 favourite:yes cleaned:yes"
    library.settle()
    assert library.shown() == ["walk.amc"]
    form.tags, form.subject = "slow", ""
    library.settle()
    clip = library.choose("walk.amc") if library.shown() else None
    assert clip is None, "the search is made anew after an edit"
    form.search = ""
    library.settle()
    assert library.choose("walk.amc").tags == ["slow"]


def test_a_clip_becomes_a_track_cut_at_its_marks() -> None:
    harness.import_human()
    library.choose("walk.amc")
    ops.library_add_track(cut_start=20, cut_end=60)
    (entry,) = harness.armature().motion_theater.entries
    assert (entry.cut_start, entry.cut_end) == (20, 60)
    library.settle()
    assert library.choose("walk.amc").used_at


def test_a_clip_comes_in_as_new_with_the_skeleton_that_the_library_chose() -> None:
    harness.import_human()
    clip = library.choose("wave.amc")
    ops.library_import(clip=clip.id)
    made = harness.armature()
    assert made.name != "human"
    assert Path(made.motion_theater.skeleton_source).name == "human.asf"
    clip = library.choose("own.bvh")
    ops.library_import(clip=clip.id)
    assert len(harness.armature().data.bones) == 3


def test_what_cannot_be_brought_in_says_why(tmp_path: Path) -> None:
    (tmp_path / "clips" / "points.csm").write_text(library.MARKERS)
    ops.library_scan()
    harness.import_human()
    library.choose("points.csm")
    assert "import it as new" in harness.refusal(ops.library_add_track)
    library.choose("broken.bvh")
    assert "cannot be read" in harness.refusal(ops.library_import)
    library.choose("walk.amc")
    bpy.context.view_layer.objects.active = None
    assert "Select the armature" in harness.refusal(ops.library_add_track)


def test_usable_pieces_are_noted_and_forgotten() -> None:
    clip = library.choose("turn.amc")
    ops.library_mark_usable(first=5, last=30)
    library.settle()
    assert library.choose("turn.amc").segments == [(5, 30)]
    assert "last frame" in harness.refusal(lambda: ops.library_mark_usable(first=9, last=3))
    ops.library_mark_usable(clip=clip.id, clear=True)
    library.settle()
    assert library.choose("turn.amc").segments == []


def test_without_a_window_the_browser_is_not_opened() -> None:
    assert not ops.library_browse.poll()
    assert not ops.library_play.poll()


def test_a_library_that_cannot_be_opened_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "other.sqlite").write_text("this is no database, and what is in it must stay")
    monkeypatch.setenv("MOTION_THEATER_LIBRARY", str(tmp_path / "other.sqlite"))
    closing.close()
    library.session.ensure_open()
    library.settle()
    assert library.session.state.trouble
    assert (tmp_path / "other.sqlite").read_text().startswith("this is no database")
