"""Every real file and whether it is read as independent readers read it: `python -m tests.native.facts_table`.

The checks are those of the tests; here their results stand by file, with the reason where readers disagree.
"""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path

import pytest

import motion_theater as mt
from tests.native.files import SHARED
from tests.native.test_marker_files import EZC3D_MISREADS, PYC3D_HIDES, UNSIGNED_GAPS

TESTS = ("test_real_bvh.py", "test_real_files.py", "test_marker_files.py")


class Results:
    """What pytest found, by the parameter of each test."""

    def __init__(self) -> None:
        self.passed: dict[str, int] = defaultdict(int)
        self.failed: dict[str, list[str]] = defaultdict(list)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note one result."""
        if report.when != "call" or "[" not in report.nodeid:
            return
        test, _, parameter = report.nodeid.split("::")[-1].partition("[")
        name = parameter.rstrip("]").removeprefix("csm-").removeprefix("trc-")
        if report.passed:
            self.passed[name] += 1
        else:
            self.failed[name].append(test)


def main() -> None:
    """Print the table."""
    results = Results()
    folder = Path(__file__).parent
    pytest.main(["-q", "--no-header", "-p", "no:cacheprovider", *(str(folder / name) for name in TESTS)], [results])
    files = json.loads((SHARED / "facts.json").read_text(encoding="utf-8"))["files"]
    print(f"\n{'file':52} {'checks':>6}  verdict")
    for name, facts in sorted(files.items()):
        path = Path(name)
        keys = {name, path.stem if name.startswith("bvh/") else "", f"{path.parent.name}-{path.stem}"}
        passed = sum(results.passed[key] for key in keys)
        failed = [test for key in keys for test in results.failed[key]]
        verdict = _verdict(name, failed, is_checked=passed > 0)
        print(f"{name:52} {passed:6}  {', '.join([verdict, *_disputes(name, facts)])}")


def _verdict(name: str, failed: list[str], *, is_checked: bool) -> str:
    if failed:
        return f"DIFFERS: {', '.join(failed)}"
    try:
        clip = mt.read(SHARED / name)
    except mt.ParseError as error:
        return f"refused: expected {error.expected}, found {error.found}"
    what = f"{len(clip.names)} {'markers' if clip.markers else 'bones'}, {clip.frames} frames"
    return f"{'agrees' if is_checked else 'read'}: {what}"


def _disputes(name: str, facts: dict[str, object]) -> list[str]:
    words = []
    if name in EZC3D_MISREADS:
        words.append(f"ezc3d {EZC3D_MISREADS[name]}")
    if name in UNSIGNED_GAPS:
        words.append(f"{UNSIGNED_GAPS[name]} words of 65535 at the origin are gaps, which neither reader knows")
    if name in PYC3D_HIDES:
        words.append("py-c3d takes a word of 1.7e38 as a gap; its path shows that the marker was seen")
    unable = [tool for tool, said in facts.items() if isinstance(said, dict) and "failed" in said]
    if unable:
        words.append(f"not readable for {' and '.join(unable)}")
    return words


if __name__ == "__main__":
    main()
