"""What is typed of a clip in the sidebar goes into the library, and into the sidecar where that is wished."""

from __future__ import annotations

import os
import resource
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import bpy
import pytest

from tests import harness
from tests.scene import library_stage as library

closing = harness.module("library.closing")
session = library.session
ops = bpy.ops.motion_theater
NOBODY = 65534
BY_HAND = b"Akteur: J\xf6rg\r\nweather rain\r\nUsable segments: 3-9\r\n"


@pytest.fixture(autouse=True)
def _library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("MOTION_THEATER_LIBRARY", str(tmp_path / "library.sqlite"))
    library.scanned(tmp_path / "clips")
    yield
    closing.close()


@pytest.fixture
def sidecar(tmp_path: Path) -> Path:
    """Where the sidecar of the selected clip is, with the box ticked."""
    library.choose("walk.amc")
    fields().also_sidecar = True
    return tmp_path / "clips" / "walk.i3d"


def fields() -> Any:
    return bpy.context.window_manager.motion_theater_library


def lines(sidecar: Path) -> dict[str, str]:
    pairs = (line.partition(":") for line in sidecar.read_text("utf-8").splitlines())
    return {label: value.strip() for label, _, value in pairs}


def test_every_field_that_has_a_line_goes_to_the_sidecar_too(sidecar: Path) -> None:
    form = fields()
    form.subject, form.recorded_on, form.session_group = "Ann", "2004-05-31", "steps"
    form.description, form.cleaned = "straight on", "YES"
    ops.library_mark_usable(first=5, last=30)
    library.settle()
    said = lines(sidecar)
    assert len(said) == 11
    assert [said[name] for name in ("Subject", "Date", "Group", "Comment", "Cleaned", "Usable segments")] == [
        "Ann",
        "2004-05-31",
        "steps",
        "straight on",
        "Yes",
        "5-30",
    ]
    assert not session.state.is_alarming


def test_stars_tags_and_favorites_make_no_sidecar_for_it_has_no_lines_for_them(sidecar: Path) -> None:
    form = fields()
    form.rating, form.is_favourite, form.tags = 3, True, "good"
    library.settle()
    assert not sidecar.exists()
    assert library.choose("walk.amc").tags == ["good"]


def test_without_the_box_nothing_is_written_beside_the_clip(sidecar: Path) -> None:
    form = fields()
    form.also_sidecar = False
    form.subject = "Ann"
    library.settle()
    assert not sidecar.exists()


def test_what_was_typed_right_before_the_end_is_kept(sidecar: Path) -> None:
    form = fields()
    for number in range(20):
        form.subject, form.rating = f"Ann {number}", number % 6
    closing.close()
    clip = next(clip for clip in session.library().clips(range(1, 10)) if clip.name == "walk.amc")
    assert (clip.subject, clip.rating) == ("Ann 19", 1)
    assert lines(sidecar)["Subject"] == "Ann 19"


def test_a_field_that_is_emptied_empties_its_line_and_stays_empty(sidecar: Path) -> None:
    form = fields()
    form.description = "straight on"
    ops.library_mark_usable(first=5, last=30)
    library.settle()
    library.choose("walk.amc")
    form.description = ""
    ops.library_mark_usable(clear=True)
    library.settle()
    assert (lines(sidecar)["Comment"], lines(sidecar)["Usable segments"]) == ("", "")
    ops.library_scan()
    clip = library.choose("walk.amc")
    assert (clip.description, clip.segments) == (None, [])


def test_a_sidecar_by_hand_keeps_all_that_was_not_edited(sidecar: Path) -> None:
    sidecar.write_bytes(BY_HAND)
    ops.library_scan()
    assert library.choose("walk.amc").subject == "J\xf6rg"
    fields().cleaned = "NO"
    library.settle()
    written = sidecar.read_bytes()
    assert written.startswith(b"Akteur: J\xf6rg\r\nCleaned: No\r\n")
    assert b"\r\nweather rain\r\nUsable segments: 3-9\r\n" in written


def check_kept_in_the_library_only(sidecar: Path, reason: str) -> None:
    """Check that an edit stands in the library, that the panel says why the sidecar has none of it."""
    assert session.state.is_alarming
    assert reason in session.state.message, session.state.message
    assert session.state.message.endswith("The library keeps what you changed")
    assert sidecar.read_bytes() == BY_HAND
    assert [path.name for path in sidecar.parent.iterdir() if path.name.startswith(".sidecar")] == []
    assert library.choose("walk.amc").subject == "Ann"


def test_a_read_only_sidecar_gives_a_message_and_stays_and_the_library_keeps_the_edit(sidecar: Path) -> None:
    sidecar.write_bytes(BY_HAND)
    sidecar.chmod(0o444)
    fields().subject = "Ann"
    library.settle()
    check_kept_in_the_library_only(sidecar, "read-only")
    sidecar.chmod(0o644)
    fields().session_group = "steps"
    library.settle()
    assert not session.state.message, "what went wrong before is no longer said"
    assert b"Akteur: Ann\r\n" in sidecar.read_bytes()


def through(monkeypatch: pytest.MonkeyPatch, before: Any, after: Any) -> None:
    """Have something done right before and after a sidecar is written."""
    whole = session.library

    class Library:
        def __getattr__(self, name: str) -> Any:
            return getattr(whole(), name)

        def write_sidecar(self, *arguments: Any, **options: Any) -> Any:
            before()
            try:
                return whole().write_sidecar(*arguments, **options)
            finally:
                after()

    monkeypatch.setattr(session, "library", Library)


def test_a_read_only_folder_gives_a_message_and_leaves_the_old_file(
    sidecar: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sidecar.write_bytes(BY_HAND)
    folder, who = sidecar.parent, os.geteuid()
    is_root = who == 0
    for place in (*folder.parents, folder):  # also who may not do everything gets there
        if is_root and place.stat().st_uid == who and place.stat().st_mode & 0o055 != 0o055:
            place.chmod(place.stat().st_mode | 0o055)

    def before() -> None:
        folder.chmod(0o555)
        if is_root:  # who may do everything is not kept out by permissions
            os.seteuid(NOBODY)

    def after() -> None:
        os.seteuid(who)
        folder.chmod(0o755)

    through(monkeypatch, before, after)
    fields().subject = "Ann"
    library.settle()
    check_kept_in_the_library_only(sidecar, "not saved, and left as it was: Permission denied")


def test_a_full_disk_gives_a_message_and_leaves_the_old_file(sidecar: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    sidecar.write_bytes(BY_HAND)
    _, most = resource.getrlimit(resource.RLIMIT_FSIZE)
    # The system refuses what is written beyond this, as it does on a full disk.
    through(
        monkeypatch,
        lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10, most)),
        lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)),
    )
    fields().subject = "Ann"
    library.settle()
    check_kept_in_the_library_only(sidecar, "not saved, and left as it was: File too large")


def test_the_dialog_edits_all_lines_and_the_library_knows_at_once(sidecar: Path) -> None:
    clip = library.choose("walk.amc")
    form = fields()
    form.also_sidecar = False
    form.subject, form.description = "Ann", "straight on"
    library.settle()
    ops.sidecar_edit(clip=clip.id, subject="Eva", usable_segments="5-30", frame_rate="60.0")
    library.settle()
    said = lines(sidecar)
    assert (said["Subject"], said["Comment"], said["Framerate"]) == ("Eva", "straight on", "60.0")
    assert (said["ASF file"], said["Duration"]) == ("human.asf", "10.2")
    clip = library.choose("walk.amc")
    assert (clip.subject, clip.sources["subject"]) == ("Eva", "SIDECAR")
    assert (clip.description, clip.sources["description"], clip.segments) == ("straight on", "USER", [(5, 30)])


def test_a_wrong_word_in_the_dialog_is_refused_and_nothing_changes(sidecar: Path) -> None:
    clip = library.choose("walk.amc")
    said = harness.refusal(lambda: ops.sidecar_edit(clip=clip.id, cleaned="maybe"))
    assert "Cleaned is empty or one of" in said
    assert "no clip 999" in harness.refusal(lambda: ops.sidecar_edit(clip=999, comment="x"))
    library.settle()
    assert not sidecar.exists()
    assert library.choose("walk.amc").cleaned is None
