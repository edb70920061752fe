"""The committed files: what the generator writes, whole, within limits, with noise and spikes of known size."""

from __future__ import annotations

import json

import numpy as np
import pytest

from testdata.generate import CLIPS
from testdata.generate.noise import POSITION_NOISE_M, noise_deg
from testdata.generate.skeleton import BONES, BY_NAME, UNIT_M, dofs_of
from testdata.generate.write import FRAME_ORDER, SKELETON_FILE, files

from . import acclaim
from .motions import CLIPS as FRAMES
from .motions import clean

MOVING_DEG = 0.5
"""A living joint never keeps still: the least range of any degree of freedom over a clip."""


def _recorded(name: str) -> dict[str, np.ndarray]:
    return acclaim.values((acclaim.FOLDER / f"{name}.amc").read_text())


def _added(name: str) -> dict[str, np.ndarray]:
    """What the recording adds to the clean motion: degrees, and metres for the root's place."""
    added = {}
    for bone, numbers in _recorded(name).items():
        columns = []
        for column, dof in enumerate(dofs_of(bone)):
            meant = clean(name)[bone][:, column]
            if dof.startswith("t"):
                columns.append(numbers[:, column] * UNIT_M - meant)
            else:
                columns.append((numbers[:, column] - np.degrees(meant) + 180) % 360 - 180)
        added[bone] = np.stack(columns, axis=-1)
    return added


def test_the_generator_writes_the_committed_files_byte_for_byte() -> None:
    written = files()
    assert sorted(written) == sorted([SKELETON_FILE, "spikes.json", *(f"{name}.amc" for name in FRAMES)])
    for name, text in written.items():
        assert (acclaim.FOLDER / name).read_bytes() == text.encode("ascii"), name


@pytest.mark.parametrize(("name", "frames"), FRAMES.items())
def test_a_clip_is_complete(name: str, frames: int) -> None:
    text = (acclaim.FOLDER / f"{name}.amc").read_text()
    assert ":FULLY-SPECIFIED\n:DEGREES\n:SAMPLES-PER-SECOND 60\n" in text
    assert [int(line) for line in text.splitlines() if line.isdigit()] == list(range(1, frames + 1))
    recorded = acclaim.values(text)
    assert tuple(recorded) == FRAME_ORDER
    assert {bone: numbers.shape for bone, numbers in recorded.items()} == {
        bone: (frames, len(dofs_of(bone))) for bone in FRAME_ORDER
    }


def test_the_walk_lasts_ten_seconds() -> None:
    assert FRAMES["walk"] / 60 >= 10


def test_the_skeleton_is_the_usual_human() -> None:
    text = (acclaim.FOLDER / "human.asf").read_text()
    parents = {row[0]: bone for bone, *children in _hierarchy(text) for row in [[child] for child in children]}
    assert len(parents) == 30
    assert parents["lhipjoint"] == parents["lowerback"] == "root"
    assert parents["ltoes"] == "lfoot"
    assert parents["rclavicle"] == parents["lowerneck"] == "thorax"
    assert parents["rhand"] == parents["rthumb"] == "rwrist"
    names = [row[0] for row in acclaim.words(text, "name")]
    lengths = dict(zip(names, (float(row[0]) for row in acclaim.words(text, "length")[1:]), strict=True))
    usual = {"femur": 7.5, "tibia": 7.7, "foot": 2.2, "toes": 1.1, "hipjoint": 2.5, "clavicle": 3.5, "humerus": 5.6}
    usual |= {"radius": 3.6, "wrist": 1.8, "hand": 0.6, "fingers": 0.5, "thumb": 0.7}
    assert {name: lengths[side + name] for side in "lr" for name in usual} == usual
    assert [lengths[name] for name in ("lowerback", "thorax", "upperneck", "head")] == [2.0, 2.0, 1.75, 1.8]
    for direction in acclaim.words(text, "direction"):
        assert np.linalg.norm([float(word) for word in direction]) == pytest.approx(1, abs=2e-6)


def _hierarchy(text: str) -> list[list[str]]:
    lines = text.split(":hierarchy")[1].splitlines()
    return [line.split() for line in lines if line.split() and line.split()[0] not in ("begin", "end")]


@pytest.mark.parametrize("name", FRAMES)
def test_every_value_is_within_its_limits(name: str) -> None:
    recorded = _recorded(name)
    for bone in BONES:
        for column, (low, high) in enumerate(bone.limits_deg):
            assert low <= recorded[bone.name][:, column].min()
            assert recorded[bone.name][:, column].max() <= high


@pytest.mark.parametrize("name", FRAMES)
def test_no_degree_of_freedom_is_constant(name: str) -> None:
    for bone, numbers in clean(name).items():
        if bone in BY_NAME:
            assert np.degrees(np.ptp(numbers, axis=0)).min() > MOVING_DEG, bone
        else:
            assert np.ptp(numbers, axis=0).min() > 0.002


@pytest.mark.parametrize("name", FRAMES)
def test_the_noise_is_as_large_as_stated(name: str) -> None:
    spikes = {(spike.bone, spike.frame - 1) for spike in CLIPS[name].spikes}
    for bone, added in _added(name).items():
        calm = np.array([frame for frame in range(len(added)) if (bone, frame) not in spikes])
        for column, dof in enumerate(dofs_of(bone)):
            stated = POSITION_NOISE_M if dof.startswith("t") else noise_deg(bone)
            # The deviation of n samples is itself uncertain by 1/sqrt(2n) of its size; five times that is allowed.
            assert added[calm, column].std() == pytest.approx(stated, rel=5 / np.sqrt(2 * len(calm)))
            assert abs(added[calm, column]).max() < 6 * stated


@pytest.mark.parametrize("name", FRAMES)
def test_spikes_are_where_the_table_says_and_a_median_removes_them(name: str) -> None:
    table = json.loads((acclaim.FOLDER / "spikes.json").read_text())[name]
    assert len(table) >= 4
    recorded, added = _recorded(name), _added(name)
    for spike in table:
        frame, column = spike["frame"] - 1, dofs_of(spike["bone"]).index(spike["dof"])
        assert 8 <= abs(spike["degrees"]) <= 25
        assert added[spike["bone"]][frame, column] == pytest.approx(spike["degrees"], abs=6 * noise_deg(spike["bone"]))
        window = recorded[spike["bone"]][frame - 2 : frame + 3, column]
        meant = np.degrees(clean(name)[spike["bone"]][frame, column])
        # What is left is noise, and how far the joint itself moves within the window.
        assert abs(np.median(window) - meant) < 0.3 * abs(spike["degrees"])
