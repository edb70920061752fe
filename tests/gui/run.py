"""Runs all sessions in the windowed Blender: `python tests/gui/run.py [SESSION...]`, from the project's root.

The windowed Blender is no part of the project. Where its folder is absent or it cannot be set up, that is said and
nothing fails; a session that fails does. The last line counts, in the words of pytest.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
GUI = Path(os.environ.get("GUI", ROOT.parent / "shared/gui")).resolve()
SESSIONS = (
    "installing",
    "dragging",
    "panels",
    "sidecar",
    "tutorial",
    "dropping",
    "marker_set",
    "library",
    "library_notes",
)
SETUP_SECONDS, SESSION_SECONDS = 900, 600


def set_up() -> str:
    """Prepare the windowed Blender; return why that is not possible, or nothing."""
    if not (GUI / "run.sh").exists():
        return f"there is no {GUI}"
    try:
        done = subprocess.run(["bash", GUI / "setup.sh"], timeout=SETUP_SECONDS, capture_output=True, text=True)
    except subprocess.TimeoutExpired:
        return f"its set-up took more than {SETUP_SECONDS} s"
    return "" if done.returncode == 0 else (done.stderr or done.stdout).strip().splitlines()[-1]


def run(session: str) -> bool:
    """Run one session; return whether it succeeded."""
    begin = time.monotonic()
    done = subprocess.run(
        ["bash", GUI / "run.sh", f"tests/gui/{session}.py"],
        cwd=ROOT,
        env={**os.environ, "MT_GUI_SECONDS": str(SESSION_SECONDS)},
    )
    passed = done.returncode == 0
    print(f"{session}: {'passed' if passed else 'FAILED'} after {time.monotonic() - begin:.0f} s", flush=True)
    return passed


def main(sessions: list[str]) -> int:
    """Run what was asked for, all by default."""
    reason = set_up()
    if reason:
        print(f"== windowed tests: not set up: {reason}")
        return 0
    if not list((ROOT / "dist").glob("motion_theater-*-linux-x64.zip")):
        print("== windowed tests: dist/ holds no extension; run `make package` first")
        return 1
    begin = time.monotonic()
    results = [run(session) for session in sessions or SESSIONS]
    passed, failed = results.count(True), results.count(False)
    counts = f"{passed} passed" + (f", {failed} failed" if failed else "")
    print(f"=== {counts} in {time.monotonic() - begin:.2f}s ===")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
