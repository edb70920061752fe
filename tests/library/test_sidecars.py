"""Sidecars: eleven lines of what people say of a clip, of which nothing is ever lost."""

from __future__ import annotations

import os
import resource
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest

import motion_theater as mt
from tests.native.files import SHARED, TESTDATA

BY_HAND = (
    b"Note: old list, p. 7\r\n"
    b"Akteur: J\xf6rg\r\n"
    b"\r\n"
    b"Date of last change: 1.6.2004\r\n"
    b"Frame-Rate: 120\r\n"
    b"weather rain\r\n"
    b"Kommentar: ab 10:30 gut: sehr sogar\r\n"
)
NOBODY = 65534


@pytest.fixture
def clip(tmp_path: Path) -> Path:
    shutil.copy(TESTDATA / "human.asf", tmp_path / "02.asf")
    shutil.copy(TESTDATA / "wave.amc", tmp_path / "02_03.amc")
    return tmp_path / "02_03.amc"


def by_hand(folder: Path) -> Path:
    path = folder / "02_03.i3d"
    path.write_bytes(BY_HAND)
    return path


def test_a_new_one_has_eleven_lines_with_what_the_clip_tells(clip: Path) -> None:
    sidecar = mt.sidecar_for(clip)
    assert not sidecar.is_on_disk
    assert list(sidecar.fields) == list(mt.SIDECAR_LABELS)
    sidecar.set("date", "2004-05-31")
    sidecar.set("cleaned", "ja")
    sidecar.set("usable_segments", "20-80, 90-110 (waves)")
    sidecar.stamp(today="2004-06-01", who="jo")
    assert not clip.with_suffix(".i3d").exists()
    sidecar.save()
    assert clip.with_suffix(".i3d").read_text("utf-8").splitlines() == [
        "Date: 2004-05-31",
        "Group:",
        "Subject: 02",
        "Duration: 2",
        "Framerate: 60",
        "Cleaned: ja",
        "Last changed on: 2004-06-01",
        "Modified by: jo",
        "Usable segments: 20-80, 90-110 (waves)",
        "ASF file: 02.asf",
        "Comment:",
    ]


def test_other_labels_missing_lines_crlf_and_latin_1_are_read_and_kept(tmp_path: Path) -> None:
    path = by_hand(tmp_path)
    sidecar = mt.read_sidecar(path)
    told = {name: value for name, value in sidecar.fields.items() if value}
    assert told == {
        "subject": "Jörg",
        "frame_rate": "120",
        "last_change": "1.6.2004",
        "comment": "ab 10:30 gut: sehr sogar",
    }
    assert sidecar.unknown == ["Note: old list, p. 7", "weather rain"]
    assert sidecar.to_bytes() == BY_HAND
    sidecar.save()
    assert path.read_bytes() == BY_HAND
    sidecar.set("subject", "Käthe")
    sidecar.set("group", "Tänze")
    sidecar.save()
    wanted = BY_HAND.replace(b"J\xf6rg", b"K\xe4the").replace(b"Akteur", b"Group: T\xe4nze\r\nAkteur")
    assert path.read_bytes() == wanted


@pytest.mark.parametrize("word", ["", "J", "ja", "Y", "YES", "n", "Nein", "No"])
def test_cleaned_is_empty_or_one_of_seven_words(clip: Path, word: str) -> None:
    sidecar = mt.sidecar_for(clip)
    sidecar.set("cleaned", word)
    assert sidecar.fields["cleaned"] == word


def test_what_a_field_cannot_hold_is_refused(clip: Path) -> None:
    sidecar = mt.sidecar_for(clip)
    with pytest.raises(mt.ParameterError, match="Cleaned is empty or one of J, Ja, Y, Yes, N, Nein, No, not “maybe”"):
        sidecar.set("cleaned", "maybe")
    with pytest.raises(mt.ParameterError, match="Comment is one line of text"):
        sidecar.set("comment", "one\ntwo")
    with pytest.raises(mt.ParameterError, match="has no field `weather`: they are date, group"):
        sidecar.set("weather", "rain")


def test_what_is_not_there_is_an_error_of_the_system(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        mt.read_sidecar(tmp_path / "no.i3d")
    with pytest.raises(FileNotFoundError):
        mt.sidecar_for(tmp_path / "no.amc")


def in_a_child(task: Callable[[], None]) -> str:
    """Return what an error says that a task ends in, run in a process of its own."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            task()
            said = "no error"
        except Exception as error:
            said = f"{type(error).__name__}: {error}"
        os.write(writing, said.encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        said = pipe.read()
    os.waitpid(child, 0)
    return said


def edited(path: Path) -> mt.Sidecar:
    sidecar = mt.read_sidecar(path)
    sidecar.set("comment", "new " * 100)
    return sidecar


def test_a_read_only_folder_gives_a_message_and_leaves_the_old_file() -> None:
    with tempfile.TemporaryDirectory() as name:  # anybody may get there, other than into a folder of pytest's
        folder = Path(name)
        path = by_hand(folder)
        sidecar = edited(path)
        path.chmod(0o644)
        folder.chmod(0o555)

        def save_as_nobody() -> None:
            if os.geteuid() == 0:  # who may do everything is not kept out by permissions
                os.setuid(NOBODY)
            sidecar.save()

        said = in_a_child(save_as_nobody)
        assert said == f"PermissionError: [Errno 13] not saved, and left as it was: Permission denied: {path!r}"
        assert path.read_bytes() == BY_HAND
        assert list(folder.iterdir()) == [path]
        folder.chmod(0o755)


def test_a_disk_without_room_gives_a_message_and_leaves_the_old_file(tmp_path: Path) -> None:
    path = by_hand(tmp_path)
    sidecar = edited(path)

    def save_without_room() -> None:
        # The system refuses what is written beyond this, as it does on a full disk.
        resource.setrlimit(resource.RLIMIT_FSIZE, (10, 10))
        sidecar.save()

    said = in_a_child(save_without_room)
    assert said == f"OSError: [Errno 27] not saved, and left as it was: File too large: {path!r}"
    assert path.read_bytes() == BY_HAND
    assert list(tmp_path.iterdir()) == [path]


def test_what_someone_else_wrote_meanwhile_is_not_overwritten(tmp_path: Path) -> None:
    path = by_hand(tmp_path)
    sidecar = edited(path)
    path.write_bytes(b"Comment: theirs\n")
    with pytest.raises(mt.LibraryError, match="someone else has changed the file meanwhile: open it again"):
        sidecar.save()
    assert path.read_bytes() == b"Comment: theirs\n"


def test_the_skeleton_that_a_sidecar_names_goes_before_all_others(clip: Path) -> None:
    shutil.copy(TESTDATA / "human.asf", clip.with_name("02_03.asf"))
    (clip.parent / "skeletons").mkdir()
    shutil.copy(TESTDATA / "human.asf", clip.parent / "skeletons" / "Jo.asf")
    clip.with_suffix(".i3d").write_text("ASF file: skeletons\\Jo.asf\n")
    best = mt.skeletons_for(clip)[0]
    assert (Path(best.path), best.reason) == (clip.parent / "skeletons" / "Jo.asf", "named in the sidecar")


@pytest.mark.skipif(not SHARED.is_dir(), reason="the collection of real files is not at hand")
def test_every_real_clip_gets_a_sidecar_that_agrees_with_it(tmp_path: Path) -> None:
    formats = {"amc", "bvh", "c3d", "csm", "trc"}
    made = 0
    for path in sorted(SHARED.rglob("*")):
        if not path.is_file() or path.suffix.lower()[1:] not in formats:
            continue
        try:
            clip = mt.read(path)
        except (mt.MotionTheaterError, OSError):
            continue
        fields = mt.sidecar_for(path).fields
        if clip.frames and clip.rate_hz:
            assert float(fields["frame_rate"]) == pytest.approx(clip.rate_hz, abs=5e-4)
            assert float(fields["duration"]) == pytest.approx(clip.frames / clip.rate_hz, abs=5e-4)
        if clip.format == "amc":
            assert fields["asf_file"] == Path(mt.skeletons_for(path)[0].path).name
        assert not path.with_suffix(".i3d").exists()
        made += 1
    assert made > 90


def test_the_library_writes_what_it_knows_and_keeps_what_means_the_same(clip: Path, tmp_path: Path) -> None:
    library = mt.Library(tmp_path / "library.sqlite")
    library.add_folder(tmp_path)
    assert library.scan(with_previews=False).wait()
    (row,) = (row for row in library.clips(range(1, library.count() + 1)) if row.path == str(clip))
    sidecar = clip.with_suffix(".i3d")
    sidecar.write_bytes(b"Datum: 31.5.2004\r\nweather rain\r\nCleaned: JA\r\nUsable segments: 1-5 (slow)\r\n")
    library.edit(
        [row.id],
        {"subject": "Jo", "recorded_on": "2004-05-31", "cleaned": True, "description": "a\nb", "session_group": "g"},
    )
    library.set_segments(row.id, [(1, 5), (7, 9)])
    assert library.write_sidecar(row.id, today="2004-06-01", who="ann") == str(sidecar)
    assert sidecar.read_bytes().decode().split("\r\n") == [
        "Datum: 31.5.2004",
        "Group: g",
        "Subject: Jo",
        "weather rain",
        "Cleaned: JA",
        "Last changed on: 2004-06-01",
        "Modified by: ann",
        "Usable segments: 1-5 (slow), 7-9",
        "Comment: a b",
        "",
    ]
    with pytest.raises(mt.ParameterError, match="the library has no clip 99"):
        library.write_sidecar(99)
