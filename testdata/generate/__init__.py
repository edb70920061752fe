"""Makes the clips of `testdata/`: `python -m testdata.generate` writes them anew.

Planned as a motion of the whole body (feet, hips, trunk, arms), solved into the joint angles of the Acclaim human,
recorded with noise and spikes, written as ASF and AMC.
"""

from __future__ import annotations

from .clips import CLIPS, RATE_HZ, clean_clip, recorded_clip
from .kinematics import Dofs, Pose, forward
from .noise import Spike

__all__ = ["CLIPS", "RATE_HZ", "Dofs", "Pose", "Spike", "clean_clip", "forward", "recorded_clip"]
