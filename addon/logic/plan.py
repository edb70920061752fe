"""From the entries of a stack to what is to be evaluated: which entry acts on which bones, and what lies below.

An entry that keeps edits replaces the base for its bones, so the entries below it do not count for them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from .messages import UserError, listing

Kind = Literal["TRACK", "FILTER", "KEPT"]


@dataclass(frozen=True)
class Entry:
    """One entry as the user set it."""

    kind: Kind
    name: str
    enabled: bool = True
    bones: tuple[str, ...] | None = None
    """None: all bones."""
    options: Mapping[str, object] = field(default_factory=dict)
    """The settings of a track or filter, as the native module names them."""


@dataclass(frozen=True)
class Step:
    """One entry that takes part."""

    entry: int
    bones: tuple[int, ...]


@dataclass
class Plan:
    """What is to be evaluated."""

    steps: list[Step] = field(default_factory=list)
    """Tracks and filters from bottom to top."""
    kept: dict[int, int] = field(default_factory=dict)
    """By bone the entry whose kept curves are its base."""
    notices: list[tuple[int, str]] = field(default_factory=list)
    """Index of the entry, and what the user should know of it."""

    @property
    def touched(self) -> set[int]:
        """The bones on which some entry acts."""
        return set(self.kept).union(*(step.bones for step in self.steps))


def plan(entries: Sequence[Entry], bones: Sequence[str]) -> Plan:
    """Work out what takes part, for an armature with these bones."""
    result = Plan()
    index = {name: number for number, name in enumerate(bones)}
    acting: list[tuple[int, list[int]]] = []
    for number, entry in enumerate(entries):
        if not entry.enabled:
            continue
        names = bones if entry.bones is None else entry.bones
        missing = [name for name in names if name not in index]
        if missing:
            result.notices.append((number, f"The armature has no bone {listing(missing)}"))
        there = [index[name] for name in names if name in index]
        if entry.kind == "KEPT":
            result.kept.update(dict.fromkeys(there, number))
        else:
            acting.append((number, there))
    for number, there in acting:
        above = tuple(sorted(bone for bone in set(there) if result.kept.get(bone, -1) < number))
        if above:
            result.steps.append(Step(number, above))
        elif there:
            result.notices.append((number, "Kept edits above replace this entry on all its bones"))
    return result


def frame_or_none(value: int) -> int | None:
    """Return a frame of a form, where zero stands for an empty field."""
    return value or None


def check_depth(depth: int) -> None:
    """Refuse a filter depth that has no middle."""
    if depth < 3 or depth % 2 == 0:
        raise UserError(f"The depth of a filter is an odd number from 3 on, not {depth}")
