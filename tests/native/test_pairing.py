"""Which skeleton belongs to which motion, and the default one where there is none."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import SHARED, TESTDATA

ACCLAIM = SHARED / "asf_amc"
REASONS = {
    "01_01.amc": ("01.asf", "it is of the same subject, 01"),
    "02_03.amc": ("02.asf", "it is of the same subject, 02"),
    "02_04.amc": ("02.asf", "it is of the same subject, 02"),
    "09_06-run.amc": ("09-run.asf", "it is of the same subject, 09"),
    "135_06-martialArts.amc": ("135-martialArts.asf", "it is of the same subject, 135"),
    "135_06-martialArts-le-N40.amc": ("135-martialArts.asf", "it is of the same subject, 135"),
    "walking.amc": ("skeleton.asf", "it is the only skeleton in the folder"),
}
USUAL_HUMANS = sorted(set(REASONS) - {"walking.amc"})


def names_and_reasons(candidates: list[mt.SkeletonCandidate]) -> list[tuple[str, str]]:
    return [(Path(found.path).name, found.reason) for found in candidates]


def real(name: str) -> Path:
    found = list(ACCLAIM.rglob(name))
    if not found:
        pytest.skip("the collection of real files is not at hand")
    return found[0]


@pytest.mark.parametrize("name", REASONS)
def test_every_real_motion_finds_its_skeleton_with_a_reason_and_fits_it(name: str) -> None:
    candidates = mt.skeletons_for(real(name))
    assert names_and_reasons(candidates) == [REASONS[name]]
    skeleton = mt.read(candidates[0].path).skeleton
    assert skeleton is not None
    assert mt.read(real(name)).bind(skeleton).frames > 0


def test_among_all_skeletons_known_that_of_the_subject_goes_first(tmp_path: Path) -> None:
    motion = tmp_path / "02_03.amc"
    motion.write_bytes(real("02_03.amc").read_bytes())
    candidates = mt.skeletons_for(motion, others=sorted(ACCLAIM.rglob("*.asf")))
    assert names_and_reasons(candidates)[0] == ("02.asf", "it is of the same subject, 02")
    assert {found.reason for found in candidates[1:]} == {"its bones fit"}
    assert len(candidates) == 5


def test_what_was_chosen_together_goes_before_what_lies_beside(tmp_path: Path) -> None:
    other = tmp_path / "other.asf"
    other.write_bytes((TESTDATA / "human.asf").read_bytes())
    found = names_and_reasons(mt.skeletons_for(TESTDATA / "walk.amc", chosen=[other]))
    assert found == [
        ("other.asf", "it came with the motion"),
        ("human.asf", "named in the motion file"),
    ]


def test_a_motion_that_is_not_there_is_an_error_of_the_system() -> None:
    with pytest.raises(FileNotFoundError):
        mt.skeletons_for("nowhere.amc")


@pytest.mark.parametrize("name", USUAL_HUMANS)
def test_the_default_skeleton_fits_every_usual_human(name: str) -> None:
    """Legs and back carry it through the real take at a human's size."""
    default = mt.default_skeleton()
    motion = mt.read(real(name)).bind(default)
    heads, tails, _ = motion.pose(default, frame=motion.first_frame)
    points = np.concatenate([heads, tails]) * default.unit_m
    assert 1.0 < np.ptp(points[:, 1]) < 2.0


def test_the_default_skeleton_does_not_pretend_to_fit_other_bones() -> None:
    with pytest.raises(mt.MisfitError):
        mt.read(real("walking.amc")).bind(mt.default_skeleton())


def test_the_default_skeleton_has_the_axes_and_degrees_of_freedom_of_the_usual_files() -> None:
    usual = mt.read(real("01.asf")).skeleton
    default = mt.default_skeleton()
    assert usual is not None
    assert default.names == usual.names
    assert default.dofs == usual.dofs
    # Quaternions q and -q are one rotation; the file's own axes are off by rounding alone.
    assert np.all(np.abs(np.sum(default.axes * usual.axes, axis=1)) > 1.0 - 1e-6)


def test_the_text_of_the_default_skeleton_is_the_default_skeleton() -> None:
    read = mt.read_bytes(mt.DEFAULT_SKELETON_ASF.encode(), name="default.asf").skeleton
    assert read is not None
    assert (read.names, read.dofs) == (mt.default_skeleton().names, mt.default_skeleton().dofs)
