"""Makes a library of as many clips as wanted, without files: rows as a scan would write them, and a list for the rest.

python -m tests.library.rows FILE [ROWS]
"""

from __future__ import annotations

import csv
import random
import sqlite3
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import motion_theater as mt

# fmt: off
WORDS = (
    "walk", "run", "jump", "dance", "kick", "turn", "sit", "climb", "throw", "catch", "swing", "march", "sneak",
    "limp", "box", "wave", "crawl", "fall", "balance", "punch", "slow", "fast", "long", "left", "right",
    "forward", "backward", "happy", "sad", "tired", "old", "young", "angry", "proud", "strut", "uneven", "hand",
    "foot",
)
# fmt: on
TAGS = ["walk", "fast", "keep", "loop", "idle", "hero", "crowd", "check"]
FOLDERS = ["cmu", "lafan", "studio", "archive"]
RATES = (None, 24.0, 29.97, 30.0, 60.0, 100.0, 119.88, 120.0048, 120.0, 240.0)
FORMATS = ("amc", "bvh", "c3d", "csm", "trc")
# fmt: off
COLUMNS = (
    "id", "folder_id", "path", "name", "folder", "size", "modified_ns", "format", "frames", "first_frame",
    "rate_hz", "duration_s", "joints", "markers", "skeleton_fingerprint", "height_m", "skeleton_path",
    "cleaned", "rating", "is_favourite", "is_missing", "used_at", "error", "facts_at", "facts_by",
)
# fmt: on
TRIGGERS = ("clip_added", "tag_put_on")


def make(path: Path, rows: int, seed: int = 1) -> mt.Library:
    """Make a library of so many clips; the same seed gives the same library."""
    chance = random.Random(seed)
    library = mt.Library(path)
    clips = [_clip(chance, number) for number in range(1, rows + 1)]
    db = sqlite3.connect(path)
    # Python may come with an SQLite that cannot write the full-text index. With the list, the library itself does so.
    triggers = [db.execute("SELECT sql FROM sqlite_schema WHERE name = ?", [name]).fetchone()[0] for name in TRIGGERS]
    with db:
        for name in TRIGGERS:
            db.execute(f"DROP TRIGGER {name}")
        db.execute("INSERT INTO folder (id, path, added_at) VALUES (1, '/clips', 0)")
        places = ", ".join("?" * len(COLUMNS))
        db.executemany(f"INSERT INTO clip ({', '.join(COLUMNS)}) VALUES ({places})", clips)
        db.executemany("INSERT INTO tag VALUES (?, ?)", enumerate(TAGS, 1))
        tagged = ((number, tag) for number in range(1, rows + 1) for tag in _tags(chance))
        db.executemany("INSERT INTO clip_tag VALUES (?, ?)", tagged)
        subjects = ((clip[0], str(clip[3])[:2]) for clip in clips if chance.random() < 0.5)
        db.executemany("INSERT INTO told VALUES (?, 'FILE', 'subject', ?)", subjects)
        for sql in triggers:
            db.execute(sql)
    db.close()
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder, "list.csv")
        with table.open("w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(_list(chance, [str(clip[2]) for clip in clips]))
        library.import_index(table)
    return library


def _clip(chance: random.Random, number: int) -> list[object]:
    subject, kind = chance.randrange(1, 41), chance.choice(FORMATS)
    folder = f"clips/{chance.choice(FOLDERS)}/{subject:02d}"
    name = f"{subject:02d}_{chance.randrange(1, 31):02d}_{chance.choice(WORDS)}_{number}.{kind}"
    is_broken = chance.random() < 0.02
    rate, frames = (None, None) if is_broken else (chance.choice(RATES), chance.randrange(1, 2500))
    has_joints = kind in ("amc", "bvh") and not is_broken
    row: list[object] = [number, 1, f"/{folder}/{name}", name, folder, chance.randrange(1000, 5_000_000)]
    row += [chance.randrange(10**18, 2 * 10**18), kind, frames, 1, rate, frames / rate if rate and frames else None]
    row += [
        chance.choice((22, 31)) if has_joints else None,
        None if has_joints or is_broken else chance.randrange(10, 60),
    ]
    row += [f"{subject % 20:016x}" if has_joints else None, chance.uniform(1.4, 2.0) if has_joints else None]
    row += [f"/{folder}/{subject:02d}.asf" if kind == "amc" and has_joints else None, None]
    row += [chance.randrange(6), chance.random() < 0.05, chance.random() < 0.02]
    row += [chance.randrange(10**9) if chance.random() < 0.2 else None, "line 1: no clip" if is_broken else None, 0, 1]
    return row


def _tags(chance: random.Random) -> list[int]:
    return chance.sample(range(1, len(TAGS) + 1), chance.choice((0, 1, 1, 2)))


def _list(chance: random.Random, paths: list[str]) -> Iterator[list[str]]:
    """Yield what a list says of clips; of each at least its group, for with that its words are known."""
    yield ["file", "subject", "description", "date", "group", "cleaned"]
    for path in paths:
        words = " ".join(chance.sample(WORDS, chance.randrange(2, 7))) if chance.random() < 0.8 else ""
        date = f"20{chance.randrange(1, 20):02d}-{chance.randrange(1, 13):02d}-{chance.randrange(1, 29):02d}"
        number = path.rsplit("/", 1)[1].split("_")[0]
        subject = chance.choice(("", "", f"S{number}"))
        cleaned = chance.choice(("", "yes", "no"))
        yield [path, subject, words, date if chance.random() < 0.7 else "", chance.choice("AB"), cleaned]


if __name__ == "__main__":
    make(Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 100_000)
