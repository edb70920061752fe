"""A contact sheet: how the clips of a folder look in the library, on the grounds of a dark and of a light theme.

    python -m tests.demo.contact_sheet FOLDER sheet.png [--only NAME ...] [--moving NAME ...]

First the stills, then for each clip that is to move a row of pictures from its strip. The picture of docs/library.md
was made of some of the files of `../shared/data`.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import motion_theater as mt

Picture = NDArray[np.uint8]

DARK, LIGHT = (48, 48, 48), (200, 200, 200)
COLUMNS = 8


def sheet(stills: Sequence[Picture], strips: Sequence[Picture], columns: int = COLUMNS) -> Image.Image:
    """Return stills in rows, and a row of pictures for each strip; the right quarter has a light ground."""
    rows = [list(stills[start : start + columns]) for start in range(0, len(stills), columns)]
    for strip in strips:
        spread = np.linspace(0, len(strip) - 1, min(columns, len(strip))).round().astype(int)
        rows.append([strip[frame] for frame in spread])
    size = next((picture.shape[0] for row in rows for picture in row), 1)
    whole = Image.new("RGB", (columns * size, len(rows) * size), DARK)
    whole.paste(LIGHT, (columns * 3 // 4 * size, 0, columns * size, len(rows) * size))
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            image = Image.fromarray(picture, "RGBA")
            whole.paste(image, (x * size, y * size), image)
    return whole


def previews(folder: Path, library: mt.Library) -> dict[str, int]:
    """Scan a folder; return the number of each clip that has a preview, by its name."""
    library.add_folder(folder)
    library.scan().wait()
    clips = sorted(library.clips(range(1, library.count() + 1)), key=lambda clip: clip.path)
    return {clip.name: clip.id for clip in clips if library.still(clip.id) is not None}


def main() -> None:
    """Make a sheet of a folder."""
    parser = argparse.ArgumentParser(description="A contact sheet of the clips of a folder")
    parser.add_argument("folder", type=Path)
    parser.add_argument("picture", type=Path)
    parser.add_argument("--only", nargs="*", help="names of files whose stills are shown; all without it")
    parser.add_argument("--moving", nargs="*", default=[], help="names of files of which a row shows how they move")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        library = mt.Library(Path(folder) / "library.sqlite")
        drawn = previews(arguments.folder, library)
        stills = [library.still(drawn[name]) for name in arguments.only or drawn]
        strips = [library.strip(drawn[name]) for name in arguments.moving]
        shown = sheet([s for s in stills if s is not None], [s.frames for s in strips if s is not None])
    shown.save(arguments.picture, optimize=True)


if __name__ == "__main__":
    main()
