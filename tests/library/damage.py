"""Ways in which files are broken, each with what a library must say of it."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from dataclasses import dataclass

Cut = Callable[[str], bytes]
"""Returns a whole clip of a format."""


@dataclass(frozen=True)
class Broken:
    """A file that cannot be read."""

    kind: str
    format: str
    """The format that the library says."""
    extension: str
    data: bytes
    reason: str
    """A piece of what the library says."""


def _insert(data: bytes, word: bytes) -> bytes:
    """Put a word in place of a number in the last third of a text."""
    number = re.compile(rb"(?<=[ \t])-?\d+\.\d+(?:[eE][+-]?\d+)?(?=\s)").search(data, len(data) * 2 // 3)
    assert number is not None, "every clip ends with numbers"
    return data[: number.start()] + word + data[number.end() :]


def broken_files(cut: Cut) -> list[Broken]:
    """Return one of each kind; `cut` gives a new whole clip each time."""
    amc, bvh, c3d, csm, trc = ("amc", "bvh", "c3d", "csm", "trc")
    end = "found the end of the file"
    last_line = cut(amc).rstrip().rsplit(b"\n", 1)
    return [
        *(Broken(f"empty {kind}", kind, kind, b"", "found an empty file") for kind in (amc, bvh, c3d, csm, trc)),
        Broken("web page", bvh, bvh, b"<!DOCTYPE html><html>404</html>", "a web page (HTML)"),
        Broken("Git LFS pointer", amc, amc, b"version https://git-lfs.github.com/spec/v1\n", "a Git LFS pointer"),
        Broken("ZIP archive", c3d, c3d, b"PK\x03\x04" + bytes(200), "a ZIP archive"),
        Broken("gzip archive", trc, trc, b"\x1f\x8b" + bytes(200), "a gzip archive"),
        Broken("UTF-16", bvh, bvh, cut(bvh)[:2000].decode("latin-1").encode("utf-16"), "UTF-16 text"),
        Broken("binary under a text's name", csm, csm, bytes(range(256)) * 9, "binary data"),
        Broken("text under a binary's name", c3d, c3d, b"just a note\n" * 60, "in its second byte"),
        Broken("word among numbers", bvh, bvh, _insert(cut(bvh), b"oops"), "found `oops`"),
        Broken("word among numbers", amc, amc, _insert(cut(amc), b"oops"), "found `oops`"),
        Broken("word among numbers", csm, csm, _insert(cut(csm), b"oops"), "found `oops`"),
        Broken("no number", bvh, bvh, _insert(cut(bvh), b"nan"), "a finite number, found `nan`"),
        Broken("decimal comma", amc, amc, _insert(cut(amc), b"1,5"), "found `1,5`"),
        Broken("cut off within a frame", amc, amc, last_line[0] + b"\n", end),
        Broken("cut off within the hierarchy", bvh, bvh, cut(bvh).split(b"JOINT")[0], end),
        Broken("cut off within the header", c3d, c3d, cut(c3d)[:300], end),
        Broken("cut off within the parameters", c3d, c3d, cut(c3d)[:600], end),
        Broken("no markers", csm, csm, cut(csm).lower().replace(b"$order", b"$comments"), "`$order`"),
        Broken("no frames section", csm, csm, cut(csm).lower().split(b"$points")[0], "`$points`"),
        Broken("no table", trc, trc, b"\n".join(cut(trc).split(b"\n")[:2]), end),
        Broken("no head", trc, trc, b"\n".join(cut(trc).split(b"\n")[3:]), "PathFileType"),
        Broken("a brace is missing", bvh, bvh, cut(bvh).replace(b"}", b"", 1), "found"),
        Broken("a channel is misspelt", bvh, bvh, cut(bvh).replace(b"rotation", b"rotatoin", 1), "found"),
        Broken("bone twice", amc, amc, b":DEGREES\n1\nroot 1 2\nroot 1 2\n", "a second time"),
        Broken("unknown processor", c3d, c3d, b"\x02\x50" + bytes(510) + b"\x01\x50\x01\x63" + bytes(508), "processor"),
    ]


def damaged_within(data: bytes) -> bytes:
    """Put a number that is none into a clip, in a way that only reading every number finds: two exponents."""
    return _insert(data, b"1e2e3")


def some_broken_files(cut: Cut, count: int, chance: random.Random) -> list[Broken]:
    """Return so many broken files, of every kind as long as there are enough."""
    found: list[Broken] = []
    while len(found) < count:
        found += broken_files(cut)
    kinds = len(broken_files(cut))
    later = found[kinds:]
    chance.shuffle(later)
    return (found[:kinds] + later)[:count]
