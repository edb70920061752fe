"""Two Blenders use one library while it is scanned again and again: nobody gets an error, and nobody waits for long."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import motion_theater
from tests.harness import ROOT
from tests.scene.test_bvh import OWN

CLIPS = 300
CHANGED = 20
SCAN = "import sys, motion_theater; sys.argv[0] = 'motion-theater'; sys.exit(motion_theater.main())"
NAMES = ("ann", "ben")


def clip(number: int, edition: int = 0) -> str:
    """Return the text of a BVH that no other has."""
    return OWN.replace("OFFSET 10", f"OFFSET {10 + number}.{edition}")


def start(file: Path, *command: str) -> subprocess.Popen[str]:
    """Start a Python that knows the library."""
    return subprocess.Popen(
        [sys.executable, *command],
        cwd=ROOT,
        env={**os.environ, "MOTION_THEATER_LIBRARY": str(file)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def scan(file: Path, *folders: Path) -> None:
    """Scan with the program of the command line."""
    scanning = start(file, "-c", SCAN, "library", "scan", *map(str, folders))
    _, error = scanning.communicate(timeout=120)
    assert (scanning.returncode, error) == (0, "")


def put(path: Path, text: str) -> None:
    """Replace a file as a whole: who reads it meanwhile finds the old text or the new one, and never an empty file."""
    whole = path.parent.parent / "being written"
    whole.write_text(text)
    whole.replace(path)


def change(folder: Path, edition: int) -> None:
    """Change clips, move some, let some come and go."""
    for number in range(CHANGED):
        put(folder / f"rest_{number:03}.bvh", clip(number, edition))
        put(folder / f"{NAMES[number % 2]}_{number:03}.bvh", clip(1000 + number, edition))
    here, there = folder / "moved_a.bvh", folder / "below" / "moved_b.bvh"
    if edition % 2:
        here.rename(there)
        put(folder / "fleeting.bvh", clip(3000))
    else:
        there.rename(here)
        (folder / "fleeting.bvh").unlink()


def test_two_blenders_and_scans_at_once_end_without_an_error_and_every_edit_is_there(tmp_path: Path) -> None:
    folder, file = tmp_path / "clips", tmp_path / "library.sqlite"
    (folder / "below").mkdir(parents=True)
    for number in range(CLIPS // 2):
        (folder / f"rest_{number:03}.bvh").write_text(clip(number))
        (folder / f"{NAMES[number % 2]}_{number:03}.bvh").write_text(clip(1000 + number))
    (folder / "moved_a.bvh").write_text(clip(2000))
    blenders = [start(file, "-m", "tests.scene.library_child", name) for name in NAMES]
    for blender in blenders:
        assert blender.stdout is not None
        while blender.stdout.readline().strip() not in ("begun", ""):
            pass
    scan(file, folder)
    edition = 0
    while any(blender.poll() is None for blender in blenders):
        edition += 1
        change(folder, edition)
        scan(file)
    library = motion_theater.Library(file)
    for blender in blenders:
        out, error = blender.communicate(timeout=60)
        assert (blender.returncode, error) == (0, "")
        (wrote,) = [json.loads(line.partition(" ")[2]) for line in out.splitlines() if line.startswith("wrote ")]
        assert len(wrote) > 3
        rows = library.clips([int(number) for number in wrote])
        assert {
            str(row.id): [row.rating, row.is_favourite, row.tags, row.subject] for row in rows if row.used_at
        } == wrote
        assert all([first for first, _ in row.segments] == [1, 2] for row in rows)
    assert edition > 1
    assert library.check() == []
    scan(file)
    assert library.count() == len({row.path for row in library.clips(library.search())}) == CLIPS + 2
