"""Makes a folder of thousands of clips, and writes down what is in every file.

python -m tests.library.maker FOLDER [--clips 3000] [--broken 60] [--share 0.02 0.1] [--table FILE]
"""

from __future__ import annotations

import argparse
import csv
import itertools
import random
from collections.abc import Iterator
from dataclasses import asdict, dataclass, fields
from pathlib import Path

from tests.library.cutting import FEWEST_FRAMES, Take, takes
from tests.library.damage import damaged_within, some_broken_files

WEIGHTS = {"amc": 6, "bvh": 8, "c3d": 4, "csm": 1, "trc": 1}
WORDS = ("walk", "run", "jump", "turn", "dance", "fight", "sit", "stand", "climb", "fall", "throw", "wave")
SKELETONS_PER_FOLDER = 2
FILES_PER_FOLDER = 60
WITHIN = "damaged within"
"""The kind of damage that only reading every number finds."""


@dataclass(frozen=True)
class Truth:
    """What the maker knows of a file."""

    path: str
    """Below the folder, with "/" between."""
    format: str
    frames: int | None = None
    first_frame: int | None = None
    rate_hz: float | None = None
    joints: int | None = None
    markers: int | None = None
    subject: str | None = None
    skeleton: str | None = None
    """The skeleton of a motion, below the folder."""
    broken: str | None = None
    """In which way."""
    reason: str | None = None
    """A piece of what a library must say of it."""


class Cutter:
    """Cuts clips that are all different."""

    def __init__(self, seed: int, share: tuple[float, float]) -> None:
        self.chance = random.Random(seed)
        self.share = share
        self.by_format: dict[str, list[Take]] = {}
        for take in takes():
            self.by_format.setdefault(take.format, []).append(take)
        self.seen: set[tuple[int, int, int]] = set()

    def cut(self, kind: str) -> tuple[Take, int, int, bytes]:
        """Return a take of a format, from where to where it was cut, and the file."""
        while True:
            take = self.chance.choice(self.by_format[kind])
            count = len(take.starts) - 1
            length = min(count, max(FEWEST_FRAMES, round(count * self.chance.uniform(*self.share))))
            start = self.chance.randint(0, count - length)
            if (key := (id(take), start, length)) not in self.seen:
                self.seen.add(key)
                return take, start, start + length, take.cut(start, start + length)

    def subject(self, take: Take) -> int:
        """Return the number of who was recorded: one for each skeleton."""
        return list(dict.fromkeys(other.asf for other in self.by_format["amc"])).index(take.asf) + 1

    def data(self, kind: str) -> bytes:
        """Return the file alone."""
        return self.cut(kind)[3]


def make(
    folder: Path, *, clips: int = 3000, broken: int = 60, share: tuple[float, float] = (0.02, 0.1), seed: int = 4
) -> list[Truth]:
    """Fill a folder with so many files, skeletons and `broken` ones among them, and return what is in each."""
    cutter = Cutter(seed, share)
    # One in ten of the broken ones looks like a whole file to everybody who does not read every number.
    within = broken // 10
    damaged = some_broken_files(cutter.data, broken - within, cutter.chance)
    known: list[Truth] = []
    performers: dict[str, list[Take]] = {}
    places = _places(cutter.chance)
    kinds = [kind for kind, weight in WEIGHTS.items() for _ in range(weight)]
    while len(known) + len(damaged) < clips:
        place, number = next(places)
        take, start, end, data = cutter.cut(cutter.chance.choice(kinds))
        skeleton = None
        if take.asf is not None:
            # The first take in a folder says who was recorded there; more would need more skeletons.
            seen = performers.setdefault(place, [])
            if take.asf not in [other.asf for other in seen] and len(seen) >= SKELETONS_PER_FOLDER:
                continue
            subject = cutter.subject(take)
            skeleton = f"{place}/{subject:02}.asf"
            if take.asf not in [other.asf for other in seen]:
                seen.append(take)
                _write(folder, skeleton, take.asf)
                known.append(Truth(skeleton, "asf", frames=0))
            name = f"{subject:02}_{number % 1000:03}"
        else:
            name = f"{cutter.chance.choice(WORDS)}_{number:04}"
        path = f"{place}/{name}.{take.format}"
        kind = reason = None
        if within > 0 and take.format in ("amc", "bvh") and take.joints and number % 3 == 0:
            within, kind, reason = within - 1, WITHIN, "found `1e2e3`"
            data = damaged_within(data)
        _write(folder, path, data)
        known.append(_truth(path, take, start, end, skeleton, kind, reason))
    for (place, number), bad in zip(itertools.islice(places, len(damaged)), damaged, strict=True):
        path = f"{place}/broken_{number:04}.{bad.extension}"
        _write(folder, path, bad.data)
        known.append(Truth(path, bad.format, broken=bad.kind, reason=bad.reason))
    return known


def _truth(
    path: str, take: Take, start: int, end: int, skeleton: str | None, broken: str | None, reason: str | None
) -> Truth:
    subject = take.subject or (Path(path).name.split("_")[0] if take.asf is not None else None)
    first = take.first_frame + start if take.format != "bvh" else 1
    count = end - start
    return Truth(
        path, take.format, count, first, take.rate_hz, take.joints, take.markers, subject, skeleton, broken, reason
    )


def _places(chance: random.Random) -> Iterator[tuple[str, int]]:
    """Yield folders, nested up to three deep, and numbers."""
    for number in itertools.count():
        if number % FILES_PER_FOLDER == 0:
            parts = [f"session {number // FILES_PER_FOLDER:02}", "dance", "día 2"][: chance.randint(1, 3)]
        yield "/".join(parts), number


def _write(folder: Path, path: str, data: bytes) -> None:
    target = folder / path
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(data)


def write_table(known: list[Truth], path: Path) -> None:
    """Write what is known of every file, a row each."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, [field.name for field in fields(Truth)])
        writer.writeheader()
        writer.writerows(asdict(truth) for truth in known)


def main() -> None:
    """Make a folder from the command line."""
    parser = argparse.ArgumentParser(description="Make a folder of clips, and a table of what is in them.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--clips", type=int, default=3000)
    parser.add_argument("--broken", type=int, default=60)
    parser.add_argument("--share", type=float, nargs=2, default=(0.02, 0.1), help="how much of a take a clip is")
    parser.add_argument("--table", type=Path, help="where to write what is in the files")
    asked = parser.parse_args()
    known = make(asked.folder, clips=asked.clips, broken=asked.broken, share=tuple(asked.share))
    if asked.table:
        write_table(known, asked.table)
    print(f"{len(known)} files in {asked.folder}")


if __name__ == "__main__":
    main()
