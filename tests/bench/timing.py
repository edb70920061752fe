"""Measuring: two ways of doing one thing, by turns, and the medians of both."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from statistics import median

LEAST_RUNS = 7
SECONDS_PER_CASE = 0.5
SECONDS_PER_TURN = 0.05
Task = Callable[[], object]


@dataclass(frozen=True)
class Row:
    """One line of the table: a ratio, and what it is to be at least (or at most)."""

    what: str
    ratio: float
    target: float
    at_most: bool = False
    detail: str = ""

    @property
    def is_met(self) -> bool:
        """Return whether the target is reached."""
        return self.ratio <= self.target if self.at_most else self.ratio >= self.target


def nothing() -> None:
    """Prepare nothing."""


def medians_s(ours: Task, theirs: Task, *, prepare: Task = nothing, runs: int = LEAST_RUNS) -> tuple[float, float]:
    """Return the median durations of both, run by turns so that other load on the machine meets both alike.

    `prepare` runs before each, unmeasured. Quick tasks that need none run several times in each turn: a turn of one run
    measures what the other task left behind (cold caches, memory given back to the system) more than the task.
    """
    durations: tuple[list[float], list[float]] = ([], [])
    turn_s = SECONDS_PER_TURN if prepare is nothing else 0.0
    deadline = time.perf_counter() + SECONDS_PER_CASE
    while len(durations[0]) < runs or time.perf_counter() < deadline:
        for task, seconds in zip((ours, theirs), durations, strict=True):
            turn = time.perf_counter() + turn_s
            while True:
                prepare()
                start = time.perf_counter()
                task()
                seconds.append(time.perf_counter() - start)
                if time.perf_counter() >= turn:
                    break
    return median(durations[0]), median(durations[1])


def ms(seconds: float) -> str:
    """Return a duration for the table."""
    return f"{seconds * 1e3:.3g} ms"
