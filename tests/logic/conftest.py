"""The pure part of the add-on is importable without Blender, past the add-on's own `__init__`, which needs it."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType

if "addon" not in sys.modules:
    package = ModuleType("addon")
    package.__path__ = [str(Path(__file__).resolve().parents[2] / "addon")]
    sys.modules["addon"] = package
