"""How a run of pytest ends when Blender was in it, and that no test fails because the machine is busy."""

from __future__ import annotations

import os
import sys

import pytest
from hypothesis import settings

settings.register_profile("at any speed", deadline=None)
settings.load_profile("at any speed")

_status = 0


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """Remember how the tests went."""
    global _status
    _status = int(exitstatus)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Leave at once: after an undo without a window, the bpy module may crash or hang while the interpreter ends."""
    if "bpy" in sys.modules:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(_status)
