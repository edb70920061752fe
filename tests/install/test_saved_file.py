"""A file made with the extension plays in a Blender that does not have it."""

from __future__ import annotations

from pathlib import Path

from tests.install.child import ROOT, run_in_blender

SKELETON = ROOT / "testdata/human.asf"
CLIPS = (ROOT / "testdata/step_and_jump.amc", ROOT / "testdata/wave.amc")


def test_a_saved_file_plays_the_same_poses_without_the_extension(package: Path, tmp_path: Path) -> None:
    blend = tmp_path / "saved.blend"
    made = run_in_blender("poses.py", "save", blend, package, SKELETON, *CLIPS, user_folder=tmp_path / "with")
    opened = run_in_blender("poses.py", "open", blend, user_folder=tmp_path / "without")

    assert (made["extension"], made["module"]) == (True, True)
    assert (opened["extension"], opened["module"]) == (False, False)
    frames = list(made["poses"].values())
    assert len(frames) > 10
    moving = {name for name in frames[0] if frames[0][name] != frames[5][name]}
    assert moving >= {"lfemur", "rfemur", "lhumerus", "rhumerus", "head"}
    assert opened["poses"] == made["poses"]
