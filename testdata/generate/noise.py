"""What a recording adds to a motion: noise on every value, and single frames that are far off.

Random numbers come from a small generator of our own, so that the clips stay the same with every numpy.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import skeleton
from .kinematics import Dofs
from .rotations import Floats

POSITION_NOISE_M = 0.001
ARM_NOISE_DEG = 0.4
BODY_NOISE_DEG = 0.2
"""Root, legs and spine carry long limbs: at this noise a foot trembles by about half a centimetre."""

ARM_BONES = ("clavicle", "humerus", "radius", "wrist", "hand", "fingers", "thumb")


@dataclass(frozen=True)
class Spike:
    """One value of one frame that the recording got wrong by `degrees`. Frames count from 1, as in the file."""

    frame: int
    bone: str
    dof: str
    degrees: float


def uniform(seed: str, count: int) -> Floats:
    """`count` numbers in 0..1 (ends excluded) that depend on nothing but `seed` (SplitMix64)."""
    state = 0
    for byte in seed.encode():
        state = (state ^ byte) * 0x100000001B3 % 2**64
    with np.errstate(over="ignore"):
        z = np.uint64(state) + np.arange(1, count + 1, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
        z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        z = z ^ (z >> np.uint64(31))
    return ((z >> np.uint64(11)).astype(float) + 0.5) / 2.0**53


def gaussian(seed: str, count: int) -> Floats:
    """`count` normally distributed numbers of mean 0 and deviation 1 (Box and Muller)."""
    pair = uniform(seed, 2 * count)
    numbers: Floats = np.sqrt(-2 * np.log(pair[:count])) * np.cos(2 * np.pi * pair[count:])
    return numbers


def noise_deg(name: str) -> float:
    """The deviation of the noise on a bone's angles, in degrees."""
    return ARM_NOISE_DEG if name[1:] in ARM_BONES else BODY_NOISE_DEG


def recorded(clip: str, dofs: Dofs, spikes: tuple[Spike, ...]) -> Dofs:
    """The clean motion of `clip` as a recording would hold it."""
    noisy: Dofs = {}
    for name, values in dofs.items():
        sizes = [
            POSITION_NOISE_M if dof.startswith("t") else np.radians(noise_deg(name)) for dof in skeleton.dofs_of(name)
        ]
        columns = [size * gaussian(f"{clip} {name} {column}", len(values)) for column, size in enumerate(sizes)]
        noisy[name] = values + np.stack(columns, axis=-1)
    for spike in spikes:
        column = skeleton.dofs_of(spike.bone).index(spike.dof)
        noisy[spike.bone][spike.frame - 1, column] += np.radians(spike.degrees)
    return noisy
