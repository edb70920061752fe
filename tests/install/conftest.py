"""The zip that `make package` left, for the platform at hand."""

from __future__ import annotations

import platform
import sys
import tomllib
from pathlib import Path

import pytest

from tests.install.child import ROOT


@pytest.fixture(scope="session")
def package() -> Path:
    """Return the path of the zip."""
    system = {"linux": "linux", "darwin": "macos", "win32": "windows"}[sys.platform]
    machine = {"x86_64": "x64", "AMD64": "x64", "arm64": "arm64"}[platform.machine()]
    version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    path = ROOT / f"dist/motion_theater-{version}-{system}-{machine}.zip"
    assert path.is_file(), f"{path} is missing: make package"
    return path
