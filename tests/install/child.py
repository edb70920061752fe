"""Runs a script in a Blender of its own, with a user folder that only this test knows."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = Path(__file__).parent / "in_blender"
LONGEST_S = 300


def run_in_blender(script: str, *arguments: str | Path, user_folder: Path) -> dict[str, Any]:
    """Run `in_blender/SCRIPT` and return the facts that it wrote."""
    user_folder.mkdir(parents=True, exist_ok=True)
    facts = user_folder / "facts.json"
    facts.unlink(missing_ok=True)
    environment = {
        **os.environ,
        "BLENDER_USER_RESOURCES": str(user_folder),
        "MT_FACTS": str(facts),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    done = subprocess.run(
        [sys.executable, SCRIPTS / script, *arguments],
        env=environment,
        capture_output=True,
        text=True,
        timeout=LONGEST_S,
        check=False,
    )
    assert done.returncode == 0, f"{script} ended with {done.returncode}\n{done.stdout}\n{done.stderr}"
    found: dict[str, Any] = json.loads(facts.read_text(encoding="utf-8"))
    return found
