"""Writing what is to be said of a clip into the file beside it."""

from __future__ import annotations

import datetime
import getpass
import shutil
from pathlib import Path
from types import SimpleNamespace

import bpy
import pytest

from tests import harness
from tests.harness import module, refusal
from tests.panels.recorder import Recorder

sidecars = module("sidecars")
edit = bpy.ops.motion_theater.sidecar_edit


@pytest.fixture
def clip(tmp_path: Path) -> Path:
    for name in ("human.asf", "wave.amc"):
        shutil.copy(harness.TESTDATA / name, tmp_path)
    return tmp_path / "wave.amc"


def test_a_new_one_has_what_the_clip_tells_and_who_wrote_it(clip: Path) -> None:
    assert edit(filepath=str(clip), comment="waves") == {"FINISHED"}
    lines = clip.with_suffix(".i3d").read_text("utf-8").splitlines()
    assert len(lines) == 11
    assert "Framerate: 60" in lines
    assert "ASF file: human.asf" in lines
    assert "Comment: waves" in lines
    assert f"Last changed on: {datetime.date.today().isoformat()}" in lines
    assert f"Modified by: {getpass.getuser()}" in lines


def test_an_edit_writes_the_named_fields_and_keeps_all_else(clip: Path) -> None:
    sidecar = clip.with_suffix(".i3d")
    sidecar.write_bytes(b"Akteur: J\xf6rg\r\nweather rain\r\n")
    edit(filepath=str(clip), cleaned="Ja", last_change="yesterday", modified_by="me")
    assert sidecar.read_bytes() == (
        b"Akteur: J\xf6rg\r\nCleaned: Ja\r\nLast changed on: yesterday\r\nModified by: me\r\nweather rain\r\n"
    )
    before = sidecar.stat()
    assert edit(filepath=str(clip), cleaned="Ja") == {"FINISHED"}
    assert sidecar.stat() == before


def test_what_cannot_be_written_is_said_and_changes_nothing(clip: Path, tmp_path: Path) -> None:
    sidecar = clip.with_suffix(".i3d")
    message = refusal(lambda: edit(filepath=str(clip), cleaned="maybe"))
    assert "Cleaned is empty or one of J, Ja, Y, Yes, N, Nein, No, not “maybe”" in message
    assert not sidecar.exists()
    assert "nowhere.amc" in refusal(lambda: edit(filepath=str(tmp_path / "nowhere.amc")))
    sidecar.write_text("Comment: mine\n")
    sidecar.chmod(0o444)
    assert "read-only" in refusal(lambda: edit(filepath=str(clip), comment="yours"))
    assert sidecar.read_text() == "Comment: mine\n"


def test_without_a_path_it_is_the_file_of_the_active_track(clip: Path) -> None:
    assert "Choose a clip" in refusal(lambda: edit(comment="x"))
    bpy.ops.motion_theater.add_track(filepath=str(clip))
    edit(comment="of the track")
    assert "Comment: of the track" in clip.with_suffix(".i3d").read_text("utf-8")


def shown(clip: Path, **typed: str) -> Recorder:
    """Return what the dialog shows for a clip, with values typed into it."""
    sidecar, layout = sidecars.beside(str(clip)), Recorder()
    values = dict.fromkeys(sidecar.fields, "") | typed
    dialog = SimpleNamespace(layout=layout, _sidecar=sidecar, bl_rna=edit.get_rna_type(), **values)
    module("operators.sidecar").MOTION_THEATER_OT_sidecar_edit.draw(dialog, bpy.context)
    return layout


def test_the_dialog_has_the_eleven_fields_and_says_that_a_sidecar_is_new(clip: Path) -> None:
    layout = shown(clip)
    assert layout.names("prop") == list(sidecars.beside(str(clip)).fields)
    assert "wave.i3d is new: saving makes it" in layout.texts()
    assert not layout.find("cleaned").alert


def test_the_dialog_marks_a_wrong_word_and_shows_the_lines_that_stay(clip: Path) -> None:
    clip.with_suffix(".i3d").write_text("weather rain\na\nb\nc\nd\n")
    layout = shown(clip, cleaned="maybe")
    assert layout.find("cleaned").alert
    texts = layout.texts().splitlines()
    assert texts[0] == "wave.i3d"
    assert [text for text in texts if text][-5:] == ["Also in the File", "weather rain", "a", "b", "and 2 more lines"]
