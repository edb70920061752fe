"""A friendly wave of the right hand, by someone who otherwise stands still."""

from __future__ import annotations

import numpy as np

from . import feet
from .body import Arm, Plan, carry, hanging_arm
from .curves import ease, spline, wander
from .kinematics import Dofs
from .rotations import Floats

WAVES_HZ = 2.4
BREATHS_HZ = 0.35


def wave(times: Floats) -> Dofs:
    """The clip, facing +Z: the arm is up after 0.45 s and comes down after 1.5 s."""
    paths = {
        "l": feet.path(times, [feet.standing(0.1, 0.0, 8.0)], "wave l"),
        "r": feet.path(times, [feet.standing(-0.1, -0.02, -9.0)], "wave r"),
    }
    # The weight goes over the left foot while the right arm is out.
    up = _raised(times)
    breath = np.sin(2 * np.pi * BREATHS_HZ * times - 0.6)
    sway = 0.028 * up - 0.006 * np.sin(2 * np.pi * 0.45 * times)
    middle = (paths["l"].ankle + paths["r"].ankle) / 2
    centre = np.stack(
        [sway, np.zeros_like(times), middle[:, 2] + 0.045 + wander(times, "wave centre", 0.006, 1.9)], axis=-1
    )
    beat = up * np.sin(2 * np.pi * WAVES_HZ * (times - 0.45))
    plan = Plan(
        seed="wave",
        times=times,
        root=np.stack([sway, 1.026 - 0.006 * up + 0.003 * breath, middle[:, 2]], axis=-1),
        heading=2.0 * up + wander(times, "wave heading", 1.2, 2.2),
        tilt=3.0 + wander(times, "wave tilt", 0.7, 1.7),
        list=1.8 * up + wander(times, "wave list", 0.6, 2.0),
        bend=1.0 - 1.3 * breath - 1.5 * up,
        twist=-4.0 * up + 0.8 * beat,
        lean=-4.5 * up + 1.0 * beat,
        gaze_side=-5.0 * up + wander(times, "wave gaze", 2.5, 1.5),
        gaze_down=3.0 - 3.0 * up + wander(times, "wave nod", 2.0, 1.1),
        arms={"l": _resting_arm(times, breath, beat), "r": _waving_arm(times, up)},
        feet=paths,
    )
    return carry(plan, centre, axes=(0, 2))


def _raised(times: Floats) -> Floats:
    """0 while the arm hangs, 1 while it is up."""
    return ease(times, 0.02, 0.5) - ease(times, 1.42, 1.98)


def _waving_arm(times: Floats, up: Floats) -> Arm:
    arm = hanging_arm(times)
    swing = 2 * np.pi * WAVES_HZ * (times - 0.45)
    envelope = ease(times, 0.25, 0.55) * (1 - ease(times, 1.35, 1.6))
    lifted = ease(times, 0.05, 0.48) - ease(times, 1.45, 1.98)
    early = ease(times, 0.0, 0.4) - ease(times, 1.55, 2.0)
    arm.flexion = 3.0 + 22.0 * up + 1.5 * envelope * np.sin(swing + 0.5)
    arm.abduction = 9.0 + 69.0 * lifted + 4.0 * envelope * np.sin(swing)
    arm.inward = 20.0 - 98.0 * lifted + 6.0 * envelope * np.sin(swing - 0.2)
    arm.elbow = 16.0 + 77.0 * early + 21.0 * envelope * np.sin(swing - 0.35)
    arm.twist = 10.0 - 42.0 * lifted + 5.0 * envelope * np.sin(swing - 0.6)
    arm.hand_bend = 6.0 - 10.0 * up + 4.0 * envelope * np.sin(swing - 1.2)
    arm.hand_side = 17.0 * envelope * np.sin(swing - 0.9)
    arm.fingers = 24.0 - 18.0 * up + 4.0 * envelope * np.sin(swing - 1.3)
    arm.shrug = 17.0 * lifted + 1.5 * envelope * np.sin(swing)
    arm.reach = 3.0 * up
    return arm


def _resting_arm(times: Floats, breath: Floats, beat: Floats) -> Arm:
    arm = hanging_arm(times)
    arm.flexion = arm.flexion + spline(times, [(0.0, 0.0), (0.5, -4.0), (1.4, 2.0), (2.0, 0.0)])
    arm.abduction = arm.abduction + 3.0 * _raised(times) - 0.8 * beat
    arm.elbow = arm.elbow + 2.5 * breath
    arm.shrug = arm.shrug + 1.0 * breath
    arm.hand_bend = arm.hand_bend + 1.5 * beat
    return arm
