"""The extension is installed, disabled and enabled in an empty Blender."""

from __future__ import annotations

from pathlib import Path

from tests.install.child import ROOT, run_in_blender

SKELETON = ROOT / "testdata/human.asf"


def test_the_extension_installs_and_comes_and_goes_without_a_trace(package: Path, tmp_path: Path) -> None:
    facts = run_in_blender("life.py", package, SKELETON, user_folder=tmp_path / "user")
    bones = SKELETON.read_text(encoding="utf-8").count("begin") - 1  # the hierarchy has a `begin` too

    assert facts["before"] == {**facts["before"], "loaded": False, "operator": False, "stack": False, "panels": []}
    assert facts["installed"] == {**facts["installed"], "loaded": True, "operator": True, "stack": True}
    assert facts["installed"]["panels"] != []
    assert facts["bones"] >= bones
    assert facts["disabled"] == facts["before"]
    assert facts["enabled again"] == facts["installed"]
    assert facts["bones again"] == facts["bones"]
    assert Path(facts["module"]).is_relative_to(tmp_path), "the bundled wheel is not the one in use"
    assert f"-{facts['version']}-" in package.name
