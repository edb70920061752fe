"""Every test begins with an empty file."""

from __future__ import annotations

from collections.abc import Iterator

import harness
import pytest


@pytest.fixture(autouse=True)
def empty_file() -> Iterator[None]:
    harness.empty_file()
    yield
