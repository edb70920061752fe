"""A library of 3,000 clips: every row is what its maker knows, and rescans read only what changed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest

import motion_theater as mt
from tests.library.maker import WITHIN, Truth, make

CLIPS = 3000
BROKEN = 60


@dataclass(frozen=True)
class Made:
    """A folder that was scanned once, and what is in it."""

    folder: Path
    library: mt.Library
    known: list[Truth]
    first: mt.ScanProgress

    def rows(self) -> dict[str, mt.LibraryClip]:
        """Return the clips by their paths below the folder."""
        clips = self.library.clips(range(1, self.library.count() + 1))
        return {Path(clip.path).relative_to(self.folder).as_posix(): clip for clip in clips}


def scanned(library: mt.Library) -> mt.ScanProgress:
    """Scan everything but previews, and return what came of it."""
    scan = library.scan(with_previews=False)
    assert scan.wait(120)
    progress = scan.progress()
    assert (progress.is_finished, progress.phase, progress.error) == (True, "DONE", None)
    return progress


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Made:
    """A library of thousands of clips."""
    folder = tmp_path_factory.mktemp("library")
    known = make(folder / "clips", clips=CLIPS, broken=BROKEN, share=(0.01, 0.04))
    library = mt.Library(folder / "library.sqlite")
    library.add_folder(folder / "clips")
    return Made(folder / "clips", library, known, scanned(library))


def test_every_file_has_one_row(made: Made) -> None:
    assert len(made.known) == CLIPS
    assert set(made.rows()) == {truth.path for truth in made.known}
    (folder,) = made.library.folders()
    assert (folder.clips, folder.missing) == (CLIPS, 0)
    assert (made.first.total, made.first.done, made.first.new) == (CLIPS, CLIPS, CLIPS)


def test_every_row_is_what_the_maker_knows(made: Made) -> None:
    rows = made.rows()
    whole = [truth for truth in made.known if truth.broken is None]
    assert len(whole) == CLIPS - BROKEN
    for truth in whole:
        row = rows[truth.path]
        assert (row.error, row.format, row.frames) == (None, truth.format, truth.frames), truth.path
        assert row.size == (made.folder / truth.path).stat().st_size
        if truth.format == "asf":
            continue
        assert (row.first_frame, row.markers) == (truth.first_frame, truth.markers), truth.path
        assert row.joints == truth.joints, truth.path
        # Rates that files round (.008333 s) are told as what they mean (120 Hz).
        assert row.rate_hz == pytest.approx(truth.rate_hz, rel=2e-3), truth.path
        assert row.duration_s == pytest.approx(row.frames / row.rate_hz)
        if truth.subject is not None:
            assert row.subject == truth.subject, truth.path
        skeleton = made.folder / truth.skeleton if truth.skeleton else None
        assert row.skeleton_path == (str(skeleton) if skeleton else None), truth.path


def test_broken_files_are_listed_with_reasons(made: Made) -> None:
    rows = made.rows()
    broken = [truth for truth in made.known if truth.broken is not None]
    assert len(broken) == BROKEN
    assert len({truth.broken for truth in broken}) >= 20
    for truth in broken:
        row = rows[truth.path]
        if truth.broken == WITHIN and row.error is None:
            continue  # only who reads every number finds it: see below
        assert row.format == truth.format, truth
        assert row.error is not None, truth
        assert truth.reason in row.error, (truth, row.error)
    assert made.first.broken == sum(row.error is not None for row in rows.values())


def test_rescans_read_only_what_changed(made: Made) -> None:
    again = scanned(made.library)
    assert (again.total, again.done, again.unchanged) == (0, 0, CLIPS)

    clips = [truth for truth in made.known if truth.format == "bvh" and truth.broken is None]
    changed, moved, deleted = clips[:10], clips[10:20], clips[20:30]
    for truth in changed:
        path = made.folder / truth.path
        path.write_bytes(path.read_bytes().replace(b"Frame Time:", b"Frame Time: "))
    progress = scanned(made.library)
    assert (progress.total, progress.changed, progress.unchanged) == (10, 10, CLIPS - 10)

    before = {truth.path: made.rows()[truth.path].id for truth in moved}
    (made.folder / "elsewhere").mkdir()
    for number, truth in enumerate(moved):
        (made.folder / truth.path).rename(made.folder / f"elsewhere/{number}.bvh")
    progress = scanned(made.library)
    assert (progress.total, progress.moved, progress.new, progress.missing) == (10, 10, 0, 0)
    rows = made.rows()
    assert [rows[f"elsewhere/{number}.bvh"].id for number in range(10)] == list(before.values())

    for truth in deleted:
        (made.folder / truth.path).unlink()
    progress = scanned(made.library)
    assert (progress.total, progress.missing, progress.unchanged) == (0, 10, CLIPS - 10)
    assert all(made.rows()[truth.path].is_missing for truth in deleted)
    assert made.library.count() == CLIPS


def test_drawing_previews_finds_what_looking_over_does_not(tmp_path: Path) -> None:
    known = make(tmp_path / "clips", clips=200, broken=40, share=(0.02, 0.05))
    within = [truth for truth in known if truth.broken == WITHIN]
    assert len(within) == 4
    library = mt.Library(tmp_path / "library.sqlite")
    library.add_folder(tmp_path / "clips")
    assert library.scan().wait(300)
    rows = {Path(row.path): row for row in library.clips(range(1, library.count() + 1))}
    for truth in known:
        error = rows[tmp_path / "clips" / truth.path].error
        assert (error is None) == (truth.broken is None), (truth, error)
        assert truth.reason is None or truth.reason in error
    again = library.scan()
    assert again.wait(300)
    assert (again.progress().total, again.progress().previews_total) == (0, 0)
