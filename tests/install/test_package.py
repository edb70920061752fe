"""What is in the zip."""

from __future__ import annotations

import tomllib
import zipfile
from pathlib import Path

from tests.install.child import ROOT


def test_the_zip_holds_one_wheel_of_its_own_version_and_the_licences(package: Path) -> None:
    with zipfile.ZipFile(package) as archive:
        names = set(archive.namelist())
        manifest = tomllib.loads(archive.read("blender_manifest.toml").decode())
        notices = archive.read("THIRD-PARTY.txt").decode()
        licence = archive.read("LICENSE").decode()
    wheels = {name for name in names if name.endswith(".whl")}
    assert wheels == {wheel.removeprefix("./") for wheel in manifest["wheels"]}
    assert [wheel.split("-")[1] for wheel in wheels] == [manifest["version"]]
    assert manifest["license"] == ["SPDX:GPL-3.0-or-later"]
    assert licence == (ROOT / "LICENSE").read_text(encoding="utf-8")
    assert "pyo3 " in notices
    assert "Permission is hereby granted, free of charge" in notices


def test_the_zip_holds_nothing_but_the_add_on(package: Path) -> None:
    with zipfile.ZipFile(package) as archive:
        names = [name for name in archive.namelist() if not name.endswith("/")]
    added = {"LICENSE", "THIRD-PARTY.txt"}
    unexpected = [
        name
        for name in names
        if name not in added and not name.startswith("wheels/") and not (ROOT / "addon" / name).is_file()
    ]
    assert unexpected == []
    assert "__init__.py" in names


def test_manifest_workspace_and_wheel_say_the_same_version(package: Path) -> None:
    workspace = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    manifest = tomllib.loads((ROOT / "addon/blender_manifest.toml").read_text(encoding="utf-8"))["version"]
    assert manifest == workspace
    assert f"-{workspace}-" in package.name
