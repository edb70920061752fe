"""Runs everything that is measured and prints one table; needs a Python that has bpy."""

from __future__ import annotations

import os
import platform
import sys

from tests.bench import editing, filters_vs_scipy, importing, reading


def main() -> None:
    """Print a row as soon as it is measured. Ratios say how fast, never whether something is right."""
    print(f"Medians of 7 runs or more, by turns with their reference; {os.cpu_count()} cores, {platform.machine()}\n")
    print(f"{'what':60} {'ratio':>7} {'target':>9}")
    missed = 0
    for part in (reading, importing, editing, filters_vs_scipy):
        for row in part.measure():
            bound = f"{'<=' if row.at_most else '>='} {row.target:g}"
            mark = "" if row.is_met else "  MISSED"
            missed += not row.is_met
            print(f"{row.what:60} {row.ratio:7.2f} {bound:>9}{mark}  ({row.detail})", flush=True)
    print(f"\n{missed} targets missed" if missed else "\nAll targets reached")
    sys.stdout.flush()
    os._exit(0)  # bpy may hang on the way out of the interpreter


if __name__ == "__main__":
    main()
