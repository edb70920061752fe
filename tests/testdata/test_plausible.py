"""The clips move as people do."""

from __future__ import annotations

import numpy as np
import pytest

from testdata.generate.kinematics import centre_of_mass

from .motions import RATE_HZ, clean_pose, correlation, heading


def _peaks(curve: np.ndarray) -> np.ndarray:
    """Frames at which a curve has a maximum."""
    return np.flatnonzero((curve[1:-1] > curve[:-2]) & (curve[1:-1] >= curve[2:])) + 1


def test_the_walk_has_its_speed_and_cadence() -> None:
    root = clean_pose("walk").heads["root"]
    seconds = (len(root) - 1) / RATE_HZ
    assert (root[-1, 2] - root[0, 2]) / seconds == pytest.approx(1.3, abs=0.03)
    steps = np.diff(_peaks(root[:, 1])) / RATE_HZ
    assert 60 / steps.mean() == pytest.approx(110, abs=2)
    assert 0.002 < steps.std() < 0.03  # no two steps are quite alike


def test_the_hips_rise_and_fall_with_each_step_and_sway_with_each_stride() -> None:
    root = clean_pose("walk").heads["root"]
    bounces, sways = len(_peaks(root[:, 1])), len(_peaks(root[:, 0]))
    assert bounces == pytest.approx(2 * sways, abs=1)
    assert 0.02 < np.ptp(root[:, 1]) < 0.06
    assert 0.02 < np.ptp(root[:, 0]) < 0.08


def test_the_hips_shift_over_the_standing_leg() -> None:
    pose = clean_pose("walk")
    height = {side: pose.heads[side + "foot"][:, 1] for side in "lr"}
    standing_left = height["r"] - height["l"]
    assert correlation(standing_left, pose.heads["root"][:, 0]) > 0.5


def test_thorax_and_pelvis_turn_against_each_other() -> None:
    pose = clean_pose("walk")
    assert correlation(heading(pose.rotations["root"]), heading(pose.rotations["thorax"])) < -0.8


def test_arms_swing_against_the_legs() -> None:
    pose = clean_pose("walk")
    for side in "lr":
        hand = pose.tails[side + "wrist"][:, 2] - pose.heads["root"][:, 2]
        foot = pose.heads[side + "foot"][:, 2] - pose.heads["root"][:, 2]
        assert correlation(hand, foot) < -0.8
        assert np.ptp(hand) > 0.3


def test_knees_bend_in_the_swing_and_never_lock() -> None:
    pose = clean_pose("walk")
    for side in "lr":
        thigh = pose.tails[side + "femur"] - pose.heads[side + "femur"]
        shin = pose.tails[side + "tibia"] - pose.heads[side + "tibia"]
        cosine = np.sum(thigh * shin, axis=-1) / np.linalg.norm(thigh, axis=-1) / np.linalg.norm(shin, axis=-1)
        knee = np.degrees(np.arccos(cosine))
        assert 5 < knee.min() < 25
        assert 55 < knee.max() < 75


def test_the_jump_flies_on_a_parabola() -> None:
    centre = centre_of_mass(clean_pose("step_and_jump"))[65:87]
    acceleration = np.diff(centre, 2, axis=0) * RATE_HZ**2
    # Six digits in the file are 1e-6 m here, 4e-3 m/s^2 in the second difference of one value; many add up.
    assert acceleration[:, 1] == pytest.approx(np.full(20, -9.81), abs=0.1)
    assert abs(acceleration[:, [0, 2]]).max() < 0.1


def test_the_jump_crouches_flies_lands_and_recovers() -> None:
    height = centre_of_mass(clean_pose("step_and_jump"))[:, 1]
    stand, crouch, top, landing, end = (
        height[0],
        height[40:55].min(),
        height[60:90].max(),
        height[88:105].min(),
        height[-1],
    )
    assert crouch < stand - 0.2
    assert top > stand + 0.15
    assert landing < stand - 0.15
    assert abs(end - stand) < 0.06


def test_the_jump_begins_with_a_step() -> None:
    pose = clean_pose("step_and_jump")
    right, left = (pose.heads[side + "foot"][:, 2] for side in "rl")
    assert right[30] - left[30] > 0.25
    assert abs(right[50] - left[50]) < 0.05
    assert left[-1] - left[50] > 0.4


def test_the_right_hand_waves_beside_the_head() -> None:
    pose = clean_pose("wave")
    hand, head = pose.tails["rhand"], pose.tails["head"]
    up = slice(32, 80)
    assert (hand[up, 1] > pose.heads["head"][up, 1]).all()
    sideways = (hand - head)[up, 0]
    assert (sideways < -0.1).all()
    turns = np.flatnonzero(np.diff(np.sign(np.diff(sideways))))
    assert len(turns) >= 3
    assert np.ptp(sideways) > 0.15
    assert hand[0, 1] < pose.heads["root"][0, 1]
    assert hand[-1, 1] < pose.heads["root"][-1, 1]


def test_who_waves_shifts_weight_to_the_other_leg() -> None:
    sway = clean_pose("wave").heads["root"][:, 0]
    assert sway[40:80].mean() - sway[0] > 0.015


def test_the_turn_is_half_a_circle_on_the_spot_through_180_degrees() -> None:
    pose = clean_pose("turn")
    faces = heading(pose.rotations["root"])
    assert faces[-1] - faces[0] == pytest.approx(180, abs=3)
    assert faces[0] < 180 < faces[-1]
    assert (np.diff(faces) > -0.3).all()
    assert np.linalg.norm(pose.heads["root"][:, [0, 2]] - pose.heads["root"][0, [0, 2]], axis=-1).max() < 0.25


@pytest.mark.parametrize(("name", "largest"), [("wave", 0.15), ("turn", 0.15)])
def test_a_slow_body_is_balanced_over_its_feet(name: str, largest: float) -> None:
    pose = clean_pose(name)
    ankles = (pose.heads["lfoot"] + pose.heads["rfoot"]) / 2
    off = (centre_of_mass(pose) - ankles)[:, [0, 2]]
    assert np.linalg.norm(off, axis=-1).max() < largest
