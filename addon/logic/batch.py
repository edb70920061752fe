"""Which of the files that are imported together belong together, and in which order they are taken."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from .messages import base_name, counted


@dataclass(frozen=True)
class Job:
    """One file to import."""

    path: str
    format: str
    """What its content says; empty where nothing reads it."""
    skeletons: tuple[str, ...] = ()
    """For a motion without a skeleton of its own: the skeletons that came with it."""


@dataclass
class Verdicts:
    """What became of the files."""

    done: list[str]
    skipped: list[str]
    """Each with its reason."""
    not_begun: int = 0

    def summary(self) -> str:
        """Return one sentence, with all reasons where there is room."""
        if len(self.done) == 1 and not self.skipped and not self.not_begun:
            return self.done[0]
        reasons = f" ({'; '.join(self.skipped)})" if 0 < len(self.skipped) <= SHOWN_REASONS else ""
        return self.counts() + reasons

    def counts(self) -> str:
        """Return how many files came in, and how many did not."""
        parts = [f"Imported {files(len(self.done))}"]
        if self.skipped:
            parts.append(f"skipped {len(self.skipped)}")
        if self.not_begun:
            parts.append(f"stopped with {self.not_begun} left")
        return ", ".join(parts)


SHOWN_REASONS = 2
LONGEST_LINE = 110


def short(line: str) -> str:
    """Return a line that a pop-up has room for: of a track that was added only that, which is said last."""
    line = line[max(0, line.rfind("Added ")) :]
    return line if len(line) <= LONGEST_LINE else f"{line[: LONGEST_LINE - 1].rstrip()}…"


def files(count: int) -> str:
    """Return a number of files in words."""
    return counted(count, "file")


def plan(paths: Iterable[str], format_of: Callable[[str], str]) -> list[Job]:
    """Return the files in the order in which they are imported, each once.

    Motions come before the skeletons, which need no armature of their own where a motion brings them along.
    """
    formats = {path: format_of(path) for path in paths}
    skeletons = [path for path, kind in formats.items() if kind == "asf"]
    motions = [
        Job(path, kind, tuple(skeletons) if kind == "amc" else ()) for path, kind in formats.items() if kind != "asf"
    ]
    return motions + [Job(path, "asf") for path in skeletons]


def used_by(skeleton: str, motion: str) -> str:
    """Return what became of a skeleton that a motion brought along."""
    return f"{base_name(skeleton)} belongs to {base_name(motion)}"
