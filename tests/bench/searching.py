"""How long searches over 100,000 clips take: the queries of tests/library/queries.txt, sorted by name and otherwise."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import motion_theater as mt
from tests.bench.timing import LEAST_RUNS, Row, ms
from tests.library.rows import make

ROWS = 100_000
MOST_MS = 50
QUERIES = Path(__file__).parents[1] / "library" / "queries.txt"
SORTS = ("name", "date", "relevance")


def measure() -> Iterator[Row]:
    """Yield one row for each order: the slowest of all queries, by their medians."""
    with tempfile.TemporaryDirectory() as folder:
        library = make(Path(folder, "clips.sqlite"), ROWS)
        for sort in SORTS:
            times = {query: _median_s(library, query, sort) for query in QUERIES.read_text().split("\n")[:-1]}
            slowest = max(times, key=lambda query: times[query])
            detail = f"median of {len(times)} queries {ms(median(times.values()))}, slowest `{slowest}`"
            what = f"search of {ROWS:,} clips by {sort}, slowest query in ms"
            yield Row(what, times[slowest] * 1e3, MOST_MS, at_most=True, detail=detail)


def _median_s(library: mt.Library, query: str, sort: str) -> float:
    durations = []
    for _ in range(LEAST_RUNS):
        start = time.perf_counter()
        library.search(query, sort=sort)
        durations.append(time.perf_counter() - start)
    return median(durations)
