"""Builds the extension: `python .ci/package.py WHEEL...`, with a Python that has bpy, leaves a zip per wheel in dist/.

The zip is made and checked by Blender's own packaging program, which the bpy package brings along.
"""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

from notices import ROOT, third_party_notices

STAGE = ROOT / "build/package/motion_theater"
DIST = ROOT / "dist"

# Ending of a wheel's name -> platform in Blender's words, target in Rust's.
PLATFORMS = {
    r"manylinux_\d+_\d+_x86_64": ("linux-x64", "x86_64-unknown-linux-gnu"),
    r"win_amd64": ("windows-x64", "x86_64-pc-windows-msvc"),
    r"macosx_\d+_\d+_arm64": ("macos-arm64", "aarch64-apple-darwin"),
    r"macosx_\d+_\d+_x86_64": ("macos-x64", "x86_64-apple-darwin"),
}


def platform_of(wheel: Path) -> tuple[str, str]:
    """Return Blender's and Rust's name of the platform that a wheel is for."""
    for pattern, names in PLATFORMS.items():
        if re.fullmatch(pattern, wheel.stem.rsplit("-", 1)[-1].split(".")[0]):
            return names
    raise SystemExit(f"{wheel.name}: a wheel for a platform that Blender's extensions do not name")


def filled_manifest(source: str, wheel: Path, platform: str) -> str:
    """Return the manifest for one platform: its wheel added, the other platforms left out."""
    head, bracket, tables = source.partition("\n[")
    head = re.sub(r"(?m)^platforms = .*\n", "", head)
    head += f'\nplatforms = ["{platform}"]\nwheels = ["./wheels/{wheel.name}"]\n'
    return head + bracket + tables


def check_versions(manifest: str, wheel: Path) -> str:
    """Return the one version of workspace, manifest and wheel. Blender unpacks a wheel only when its version is new."""
    workspace = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    found = {"addon/blender_manifest.toml": tomllib.loads(manifest)["version"], wheel.name: wheel.name.split("-")[1]}
    for where, version in found.items():
        if version != workspace:
            raise SystemExit(f"{where} says version {version}, Cargo.toml {workspace}: they must be the same")
    return str(workspace)


def blender_packaging(*arguments: str | Path) -> None:
    """Run Blender's program behind `blender --command extension`, which works without a window."""
    found = importlib.util.find_spec("bpy")
    if found is None or found.origin is None:
        raise SystemExit("The packaging program is part of the bpy package: run this with a Python that has it")
    (program,) = Path(found.origin).parent.glob("*/scripts/addons_core/bl_pkg/cli/blender_ext.py")
    subprocess.run([sys.executable, program, *arguments], check=True)


def stage(wheel: Path, platform: str, target: str) -> str:
    """Lay out what goes into the zip; return its version."""
    manifest = (ROOT / "addon/blender_manifest.toml").read_text(encoding="utf-8")
    version = check_versions(manifest, wheel)
    shutil.rmtree(STAGE, ignore_errors=True)
    shutil.copytree(ROOT / "addon", STAGE, ignore=shutil.ignore_patterns("__pycache__", ".*"))
    (STAGE / "wheels").mkdir()
    shutil.copy(wheel, STAGE / "wheels")
    shutil.copy(ROOT / "LICENSE", STAGE)
    (STAGE / "THIRD-PARTY.txt").write_text(third_party_notices(target), encoding="utf-8")
    manifest = filled_manifest(manifest, wheel, platform)
    (STAGE / "blender_manifest.toml").write_text(manifest, encoding="utf-8")
    return version


def main(wheels: list[Path]) -> None:
    """Build and check one zip for each wheel."""
    if not wheels:
        raise SystemExit(f"usage: {sys.argv[0]} WHEEL...")
    DIST.mkdir(exist_ok=True)
    for wheel in wheels:
        platform, target = platform_of(wheel)
        version = stage(wheel, platform, target)
        package = DIST / f"motion_theater-{version}-{platform}.zip"
        blender_packaging("validate", STAGE)
        blender_packaging("build", "--source-dir", STAGE, "--output-filepath", package)
        blender_packaging("validate", package)


if __name__ == "__main__":
    main([Path(argument) for argument in sys.argv[1:]])
