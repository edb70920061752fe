"""Takes that are cut into clips by plain Python, which so knows what is in each without asking the core."""

from __future__ import annotations

import re
import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import motion_theater as mt
from tests.native.files import SHARED, TESTDATA

FEWEST_FRAMES = 12
C3D_BLOCK = 512


@dataclass(frozen=True)
class Take:
    """A file that can be cut between any two frames."""

    format: str
    head: bytes
    frames: bytes
    starts: tuple[int, ...]
    """Where each frame begins in `frames`, and where the last one ends."""
    first_frame: int
    rate_hz: float
    joints: int | None = None
    markers: int | None = None
    subject: str | None = None
    asf: bytes | None = None
    """The skeleton of a motion without one of its own."""

    def cut(self, start: int, end: int) -> bytes:
        """Return a file of the frames from `start` up to `end`, both counted from 0."""
        body = self.frames[self.starts[start] : self.starts[end]]
        first, count = self.first_frame + start, end - start
        head = self.head
        if self.format == "bvh":
            head = re.sub(rb"(?i)(frames:?\s*)\d+", rb"\g<1>%d" % count, head, count=1)
        elif self.format == "csm":
            head = re.sub(rb"(?i)(\$firstframe\s+)\d+", rb"\g<1>%d" % first, head)
            head = re.sub(rb"(?i)(\$lastframe\s+)\d+", rb"\g<1>%d" % (first + count - 1), head)
        elif self.format == "trc":
            head = re.sub(rb"(?s)^(.*?\n.*?\n(?:[^\t\n]*\t){2})\d+", rb"\g<1>%d" % count, head, count=1)
        elif self.format == "c3d":
            head = _c3d_head(head, first, count)
        return head + body


def takes() -> list[Take]:
    """Return what there is to cut: real files where they are at hand, else clips of our own in every format."""
    found = [take for path in sorted(SHARED.rglob("*")) if path.is_file() and (take := _take(path))]
    return found or _own_takes()


def _take(path: Path) -> Take | None:
    read = {".amc": _amc, ".bvh": _bvh, ".c3d": _c3d, ".csm": _csm, ".trc": _trc}.get(path.suffix.lower())
    take = read(path.read_bytes(), path) if read else None
    return take if take is not None and len(take.starts) > 2 * FEWEST_FRAMES else None


def _amc(data: bytes, path: Path) -> Take | None:
    starts = [match.start() for match in re.finditer(rb"(?m)^\d+\s*$", data)]
    skeletons = sorted(path.parent.glob("*.asf"))
    if len(skeletons) != 1 or not starts:
        return None
    first = data[starts[0] : starts[1]].split(b"\n", 1)
    ends = (*(start - starts[0] for start in starts), len(data) - starts[0])
    rate = re.search(rb":SAMPLES-PER-SECOND\s+([\d.]+)", data[: starts[0]])
    return Take(
        "amc",
        data[: starts[0]],
        data[starts[0] :],
        ends,
        int(first[0]),
        float(rate[1]) if rate else 120.0,
        joints=len(first[1].strip().splitlines()),
        asf=skeletons[0].read_bytes(),
    )


def _bvh(data: bytes, _: Path) -> Take | None:
    time = re.search(rb"(?i)frame\s*time:?\s*([\d.eE-]+)[ \t]*\r?\n", data)
    count = re.search(rb"(?i)frames:?\s*(\d+)", data)
    if time is None or count is None:
        return None
    rows, starts = _lines(data, time.end())
    joints = len(re.findall(rb"(?im)^\s*(?:ROOT|JOINT)\b", data[: time.start()]))
    if len(starts) - 1 != int(count[1]):
        return None
    return Take("bvh", data[: time.end()], rows, starts, 1, 1 / float(time[1]), joints=joints)


def _csm(data: bytes, _: Path) -> Take | None:
    points = re.search(rb"(?im)^\$points\s*$", data)
    order = re.search(rb"(?is)\$order\s+([^$]*)", data)
    rate = re.search(rb"(?i)\$rate\s+([\d.]+)", data)
    if points is None or order is None or rate is None:
        return None
    rows, starts = _lines(data, points.end())
    actor = re.search(rb"(?i)\$actor[ \t]+(\S+)", data)
    return Take(
        "csm",
        data[: points.end()] + b"\n",
        rows,
        starts,
        int(rows.split(maxsplit=1)[0]),
        float(rate[1]),
        markers=len(order[1].split()),
        subject=actor[1].decode() if actor else None,
    )


def _trc(data: bytes, _: Path) -> Take | None:
    first = re.search(rb"(?m)^\d+[\t ]+[\d.]+[\t ]", data[data.index(b"Frame#") :])
    lines = data.split(b"\n")
    keys, values = (line.strip().split(b"\t") for line in lines[1:3])
    if first is None:
        return None
    start = data.index(b"Frame#") + first.start()
    rows, starts = _lines(data, start)
    head = dict(zip(keys, values, strict=False))
    number = int(rows.split(maxsplit=1)[0])
    rate, markers = float(head[b"DataRate"]), int(head[b"NumMarkers"])
    # A row that ends with a gap says less of how many markers there are than others.
    if any(len(row.rstrip().split(b"\t")) != 2 + 3 * markers for row in rows.splitlines()):
        return None
    return Take("trc", data[:start], rows, starts, number, rate, markers=markers)


def _lines(data: bytes, start: int) -> tuple[bytes, tuple[int, ...]]:
    """Return the lines from `start` on that hold something, each with its end, and where they begin."""
    lines = [line + b"\n" for line in data[start:].split(b"\n") if line.strip()]
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line))
    return b"".join(lines), tuple(starts)


def _c3d(data: bytes, _: Path) -> Take | None:
    """Take files of Intel processors whose header, parameters and size agree."""
    if len(data) < 2 * C3D_BLOCK or data[(data[0] - 1) * C3D_BLOCK + 3 :][:1] != b"\x54":
        return None
    points, analog, first, last, _, scale, block, _, rate = struct.unpack_from("<HHHHHfHHf", data, 2)
    start, width = (block - 1) * C3D_BLOCK, 4 if scale < 0 else 2
    length = (4 * points + analog) * width
    count = last - first + 1
    place = _value(data[:start], b"FRAMES")
    if points == 0 or count < 2 or place is None or start + count * length > len(data) or last > 32000:
        return None
    if struct.unpack_from("<H", data, place) != (count,):
        return None
    starts = tuple(frame * length for frame in range(count + 1))
    return Take("c3d", data[:start], data[start:], starts, first, rate, markers=points)


def _c3d_head(head: bytes, first: int, count: int) -> bytes:
    """Say how many frames there are: words 4 and 5 of the header, and the parameters that say it again."""
    new = bytearray(head)
    struct.pack_into("<HH", new, 6, first, first + count - 1)
    said = ((b"FRAMES", count), (b"ACTUAL_START_FIELD", first), (b"ACTUAL_END_FIELD", first + count - 1))
    for name, number in said:
        if (place := _value(head, name)) is not None:
            struct.pack_into("<H", new, place, number)
    return bytes(new)


def _value(head: bytes, name: bytes) -> int | None:
    """Return where the first number of a parameter is. Before its name are the length of that (negative: locked) and
    the group; behind it the way to the next parameter, the type, the number of dimensions and these."""
    for match in re.finditer(re.escape(name), head[C3D_BLOCK:]):
        at = C3D_BLOCK + match.start()
        if head[at - 2] in (len(name), 256 - len(name)):
            return at + len(name) + 4 + head[at + len(name) + 3]
    return None


def _own_takes() -> list[Take]:
    """Return the repository's own clips, as they are and converted into every other format by the core."""
    skeleton = mt.read(TESTDATA / "human.asf").skeleton
    assert skeleton is not None
    found: list[Take | None] = []
    for path in sorted(TESTDATA.glob("*.amc")):
        found.append(_amc(path.read_bytes(), path))
        motion = mt.read(path, skeleton=skeleton).motion
        assert motion is not None
        found.append(_bvh(mt.to_bvh(skeleton, motion), path))
        frames = range(motion.first_frame, motion.first_frame + motion.frames)
        places = [motion.pose(skeleton, float(frame))[1] for frame in frames]
        names = list(skeleton.names)
        markers = mt.Markers(names, _by_marker(places), rate_hz=motion.rate_hz, unit_m=skeleton.unit_m, up=(0, 1, 0))
        found += [_c3d(markers.to_bytes("c3d"), path), _csm(markers.to_bytes("csm"), path)]
        found.append(_trc(markers.to_bytes("trc"), path))
    return [take for take in found if take is not None]


def _by_marker(places: list[mt.Floats]) -> mt.Floats:
    return np.ascontiguousarray(np.stack(places, axis=1))
