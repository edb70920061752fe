"""Every test of the scene begins with an empty file."""

from __future__ import annotations

import pytest

from tests import harness


@pytest.fixture(autouse=True)
def _empty_file() -> None:
    harness.empty_file()
