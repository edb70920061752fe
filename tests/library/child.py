"""What other processes do with a library while a test looks on: `python -m tests.library.child scan|read FILE ...`."""

from __future__ import annotations

import subprocess
import sys

import motion_theater as mt
from tests.native.files import ROOT


def start(*arguments: object) -> subprocess.Popen[str]:
    """Start such a process, and return when it has begun its work."""
    command = [sys.executable, "-m", "tests.library.child", *map(str, arguments)]
    child = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert child.stdout is not None
    child.stdout.readline()
    return child


def end(child: subprocess.Popen[str]) -> tuple[int, str]:
    """Wait for the end, and return how it came."""
    _, error = child.communicate(timeout=120)
    return child.returncode, error


def main() -> None:
    """Scan a folder, or read until the library has as many clips as it is to have."""
    what, file, *rest = sys.argv[1:]
    library = mt.Library(file)
    if what == "scan":
        library.add_folder(rest[0])
        scan = library.scan(with_previews=False)
        print("begun", flush=True)
        scan.wait()
        progress = scan.progress()
        if progress.error is not None:
            sys.exit(progress.error)
    else:
        print("begun", flush=True)
        while library.count() < int(rest[0]):
            ids = range(1, library.count() + 1, 7)
            names = [clip.name for clip in library.clips(ids)]
            if not all(names) or not library.folders():
                sys.exit("a clip without a name, or no folder")


if __name__ == "__main__":
    main()
