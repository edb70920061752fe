"""What people say of the clips that the maker made: an index beside them, sidecars, and edits in the library."""

from __future__ import annotations

import csv
import random
from pathlib import Path

import motion_theater as mt
from tests.library.rows import TAGS, WORDS

SIDECARS = 60


def write_beside(folder: Path, paths: list[str], seed: int = 9) -> None:
    """Write an index of clips, given by their paths below the folder, and sidecars of some."""
    chance = random.Random(seed)
    with (folder / "index.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["file", "description", "date", "group", "cleaned"])
        for path in paths:
            words = " ".join(chance.sample(WORDS, chance.randrange(2, 7))) if chance.random() < 0.6 else ""
            date = f"20{chance.randrange(1, 10):02d}-{chance.randrange(1, 13):02d}-{chance.randrange(1, 29):02d}"
            cleaned = chance.choice(("", "yes", "no"))
            table.writerow([path, words, date if chance.random() < 0.5 else "", chance.choice(("", "A", "B")), cleaned])
    for path in chance.sample(paths, SIDECARS):
        text = f"Subject: S{chance.randrange(10, 30)}\nCleaned: Yes\nComment: müde, fast walk, left hand\n"
        (folder / path).with_suffix(".i3d").write_text(text, encoding="utf-8")


def edit(library: mt.Library, ids: list[int], seed: int = 10) -> None:
    """Give clips stars, tags, and a place among the favourites."""
    chance = random.Random(seed)
    for clip in ids:
        if chance.random() < 0.3:
            library.edit([clip], {"rating": chance.randrange(1, 6), "is_favourite": chance.random() < 0.4})
        if chance.random() < 0.4:
            library.tag([clip], add=chance.sample(TAGS, chance.randrange(1, 3)))
