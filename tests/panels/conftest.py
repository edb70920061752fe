"""Every test of the panels begins with an empty file and an empty form."""

from __future__ import annotations

import bpy
import pytest

from tests import harness


@pytest.fixture(autouse=True)
def _empty_file() -> None:
    harness.empty_file()
    form = bpy.context.window_manager.motion_theater
    for name in form.bl_rna.properties.keys():  # noqa: SIM118
        form.property_unset(name)
