"""Runs everything that is measured and prints one table; needs a Python that has bpy."""

from __future__ import annotations

import os
import platform
import sys
from typing import TextIO

from tests.bench import (
    editing,
    filters_vs_scipy,
    importing,
    importing_bvh,
    importing_markers,
    reading,
    reading_bvh,
    reading_c3d,
    scanning,
    searching,
)

PARTS = (
    reading,
    reading_bvh,
    reading_c3d,
    importing,
    importing_bvh,
    importing_markers,
    editing,
    filters_vs_scipy,
    scanning,
    searching,
)


def main() -> None:
    """Print a row as soon as it is measured. Ratios say how fast, never whether something is right."""
    table = _table_alone()
    print(
        f"Medians, by turns with their reference; {os.cpu_count()} cores, {platform.machine()}\n",
        file=table,
    )
    print(f"{'what':66} {'ratio':>7} {'target':>9}", file=table)
    missed = 0
    for part in PARTS:
        for row in part.measure():
            bound = f"{'<=' if row.at_most else '>='} {row.target:g}"
            mark = "" if row.is_met else "  MISSED"
            missed += not row.is_met
            print(f"{row.what:66} {row.ratio:7.2f} {bound:>9}{mark}  ({row.detail})", file=table, flush=True)
    print(f"\n{missed} targets missed" if missed else "\nAll targets reached", file=table, flush=True)
    os._exit(0)  # bpy may hang on the way out of the interpreter


def _table_alone() -> TextIO:
    """Return the way to the terminal, and close it to everybody else: Blender comments on every import."""
    table = os.fdopen(os.dup(sys.stdout.fileno()), "w")
    elsewhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(elsewhere, sys.stdout.fileno())
    os.close(elsewhere)
    return table


if __name__ == "__main__":
    main()
