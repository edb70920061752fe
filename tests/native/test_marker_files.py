"""Every real marker file against what independent readers (ezc3d, py-c3d, assimp) say of it.

Where the readers err, the file's own bytes decide; each such case is named below, with the reason.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import SHARED

EZC3D_MISREADS = {
    "c3d/c3dorg_11/evart.c3d": "strides by 16.67 samples per frame; the header and the size of the file say 17",
    "c3d/c3dorg_28/type1.C3D": "sees no analog channel (the file gives no analog rate): strides too short",
    "c3d/c3dorg_28/standing.C3D": "sees no analog channel (the file gives no analog rate): strides too short",
    "c3d/btk_561xxa01_anonym.C3D": "sees no analog channel (the file gives no analog rate): strides too short",
}
"""Files of which ezc3d reads only the first frame where it is."""

UNSIGNED_GAPS = {
    "c3d/c3dorg_07/16bitanalog.c3d": 6399,
    "c3d/c3dorg_26/Capture0002.c3d": 818,
    "c3d/anybody_GaitFast_1.c3d": 15,
}
"""Samples with a word of 65535, which is -1 in 16 bits, at the origin: gaps, which neither reader knows."""

PYC3D_HIDES = {"c3d/c3dorg_30/admarche2.c3d", "c3d/c3dorg_30/marche281.c3d"}
"""A word of 1.7e38 is no negative number: the marker was seen, as its smooth path shows. py-c3d takes it as a gap."""


def _facts(prefix: str) -> dict[str, dict[str, Any]]:
    table = SHARED / "facts.json"
    if not table.is_file():
        return {}
    files: dict[str, dict[str, Any]] = json.loads(table.read_text(encoding="utf-8"))["files"]
    return {name: entry for name, entry in files.items() if name.startswith(prefix)}


C3D = {name: entry for name, entry in _facts("c3d/").items() if entry["bytes"] > 0}
CSM = _facts("csm/")
EVERY_FILE = sorted([*C3D, *CSM, *(str(path.relative_to(SHARED)) for path in SHARED.glob("other/trc/*.trc"))])

c3d_files = pytest.mark.parametrize("name", list(C3D))


def reader(name: str, tool: str) -> dict[str, Any]:
    """Return what a tool says of a file; nothing where it failed."""
    found: dict[str, Any] = next((value for key, value in C3D[name].items() if key.startswith(tool)), {})
    return {} if "failed" in found else found


def read(name: str) -> tuple[mt.Clip, mt.Markers]:
    """Read a file of the collection."""
    clip = mt.read(SHARED / name)
    assert clip.markers is not None
    return clip, clip.markers


@c3d_files
def test_counts_rates_and_names_are_those_of_the_facts(name: str) -> None:
    clip, markers = read(name)
    for facts in (reader(name, "ezc3d"), reader(name, "c3d (py-c3d)")):
        if not facts:
            continue
        assert len(markers.names) == facts["points"]
        assert markers.frames == facts.get("frames", facts.get("frames_read"))
        assert markers.rate_hz == pytest.approx(facts["rate"], abs=1e-6)
        labels = [label.rstrip(" \0") for label in facts["labels"]][: len(markers.names)]
        assert markers.names[: len(labels)] == labels
        if "first_frame" in facts:
            assert markers.first_frame == facts["first_frame"]
        if name not in EZC3D_MISREADS and facts["analog_channels"]:
            assert len(markers.analog) == facts["analog_channels"]
            assert markers.analog[0].rate_hz == pytest.approx(facts["analog_rate"], abs=1e-6)
        if "analog_labels" in facts:
            own = [channel.name for channel in markers.analog]
            labels = [label.rstrip(" \0") for label in facts["analog_labels"]][: len(own)]
            assert own[: len(labels)] == labels
        if "groups" in facts:
            groups = {key.split(":")[0].upper() for key in clip.parameters}
            # Parameters of a group that is nowhere named go by its number.
            assert {group for group in groups if not group.isdigit()} <= {group.upper() for group in facts["groups"]}


def close(found: np.ndarray, expected: list[float | None]) -> bool:
    """Compare to the last bit of float32, for numbers that are rounded to six decimals in the table."""
    wanted = np.array([np.nan if x is None else x for x in expected])
    tolerance = 0.6e-6 + np.spacing(np.abs(np.nan_to_num(wanted)).astype(np.float32))
    return bool(np.all(np.abs(found.astype(np.float64) - wanted) <= tolerance))


@c3d_files
def test_positions_are_those_of_the_facts(name: str) -> None:
    _, markers = read(name)
    positions, valid = markers.positions, markers.valid
    assert positions.dtype == np.float32
    np.testing.assert_array_equal(valid, ~np.isnan(positions).any(axis=2))
    for sample in reader(name, "ezc3d").get("samples", []):
        point, frame = sample["point"], sample["frame"]
        if name in EZC3D_MISREADS and frame > 0:
            continue
        if not valid[point, frame]:
            assert sample["xyz"] == [None] * 3 or (name in UNSIGNED_GAPS and not any(sample["xyz"])), sample
        else:
            assert close(positions[point, frame], sample["xyz"]), (sample, positions[point, frame])
    for sample in reader(name, "c3d (py-c3d)").get("samples", []):
        point, frame = sample["point"], sample["frame_index"]
        if valid[point, frame]:
            if name not in PYC3D_HIDES:
                assert sample["residual"] >= 0
                assert close(positions[point, frame], sample["xyz"]), (sample, positions[point, frame])
        else:
            assert sample["residual"] == -1 or name in UNSIGNED_GAPS, sample


@pytest.mark.parametrize("name", [name for name in C3D if reader(name, "ezc3d") and name not in EZC3D_MISREADS])
def test_as_many_samples_are_gaps_as_the_facts_say(name: str) -> None:
    _, markers = read(name)
    missing = reader(name, "ezc3d")["missing_points_total"]
    assert int((~markers.valid).sum()) == missing + UNSIGNED_GAPS.get(name, 0)


@c3d_files
def test_residuals_and_cameras_are_those_of_the_facts(name: str) -> None:
    _, markers = read(name)
    residuals, cameras, valid = markers.residuals, markers.cameras, markers.valid
    for sample in reader(name, "c3d (py-c3d)").get("samples", []):
        point, frame = sample["point"], sample["frame_index"]
        if valid[point, frame] and name not in PYC3D_HIDES:
            assert residuals[point, frame] == pytest.approx(sample["residual"], abs=1e-6)
            assert cameras[point, frame] == int(sample["cameras"])


@c3d_files
def test_analog_samples_are_those_of_the_facts(name: str) -> None:
    _, markers = read(name)
    facts = reader(name, "ezc3d")
    if not facts.get("analog_channels") or name in EZC3D_MISREADS:
        return
    assert len(markers.analog[0].samples) == facts["analog_samples"]
    for sample in facts["analog_value_samples"]:
        found = markers.analog[sample["channel"]].samples[sample["sample"]]
        assert found == pytest.approx(sample["value"], abs=1e-6, rel=1e-9), sample


@c3d_files
def test_events_are_those_of_the_facts(name: str) -> None:
    _, markers = read(name)
    facts = reader(name, "ezc3d").get("events")
    if facts is None:
        return
    used = int(facts["used"][0])
    minutes, seconds = facts["times_rows"] if used else ([], [])
    times = [60 * minute + second for minute, second in zip(minutes, seconds, strict=True)]
    assert [event.time_s for event in markers.events] == pytest.approx(times[:used], abs=1e-6)
    assert [event.label for event in markers.events] == [label.rstrip() for label in facts["labels"]][:used]


@c3d_files
def test_force_plates_are_kept(name: str) -> None:
    clip, _ = read(name)
    facts = reader(name, "ezc3d")
    if "force_plates" in facts and "FORCE_PLATFORM:TYPE" in clip.parameters:
        types = clip.parameters["FORCE_PLATFORM:TYPE"]
        assert types[: facts["force_plates"]] == facts["force_plate_types"]


@pytest.mark.parametrize("name", list(CSM))
def test_a_csm_has_the_markers_of_the_facts(name: str) -> None:
    _, markers = read(name)
    (facts,) = (value for key, value in CSM[name].items() if key.startswith("assimp"))
    assert markers.names == facts["markers"]
    assert (markers.rate_hz or 0.0) == facts["ticks_per_second"]
    for sample in facts["samples"]:
        trajectory = markers.positions[markers.names.index(sample["marker"])]
        assert int(markers.valid[markers.names.index(sample["marker"])].sum()) == sample["keys"]
        for at in sample["at"]:
            np.testing.assert_array_equal(trajectory[at["key"]].astype(np.float32), np.float32(at["xyz"]))


def test_a_trc_and_a_c3d_of_one_trial_agree() -> None:
    if not SHARED.is_dir():
        pytest.skip("the collection of real files is not here")
    _, table = read("other/trc/btk_Gait.trc")
    _, binary = read("c3d/btk_Gait.c3d")
    # The names differ ("R.Shoulder", "RSHO"), the order does not.
    both = table.valid[: len(binary.names)] & binary.valid
    assert both.sum() > 5000
    apart = np.abs(table.positions[: len(binary.names)][both] - binary.positions[both])
    # The table was smoothed after frame 159: most of it agrees to a fraction of a millimetre, quick feet to 8 mm.
    assert np.median(apart) < 0.5
    assert apart.max() < 10


ROUND_TRIP_FIELDS = ("names", "kinds", "frames", "first_frame", "rate_hz", "unit_m", "up", "analog_samples_per_frame")


def assert_same(found: mt.Markers | None, expected: mt.Markers) -> None:
    """Compare everything."""
    assert found is not None
    for field in ROUND_TRIP_FIELDS:
        assert getattr(found, field) == getattr(expected, field), field
    for field in ("positions", "residuals", "cameras"):
        np.testing.assert_array_equal(getattr(found, field), getattr(expected, field), err_msg=field)
    events = [(event.label, event.context, event.subject, event.time_s) for event in expected.events]
    assert [(event.label, event.context, event.subject, event.time_s) for event in found.events] == events
    for own, other in zip(found.analog, expected.analog, strict=True):
        assert (own.name, own.description, own.unit) == (other.name, other.description, other.unit)
        np.testing.assert_array_equal(own.samples, other.samples)


@pytest.mark.parametrize("name", EVERY_FILE)
def test_a_file_written_and_read_is_the_same(name: str) -> None:
    clip, markers = read(name)
    data = clip.to_bytes()
    again = mt.read_bytes(data, name=Path(name).name)
    assert_same(again.markers, markers)
    assert again.to_bytes() == data
    if clip.format == "c3d":
        assert data == (SHARED / name).read_bytes()


@c3d_files
def test_markers_written_as_a_new_c3d_are_the_same(name: str) -> None:
    _, markers = read(name)
    assert_same(mt.read_bytes(markers.to_bytes("c3d"), name="new.c3d").markers, markers)


@pytest.mark.parametrize("name", EVERY_FILE)
@pytest.mark.parametrize("extension", ["csm", "trc"])
def test_markers_written_as_text_are_where_they_were(name: str, extension: Literal["csm", "trc"]) -> None:
    _, markers = read(name)
    found = mt.read_bytes(markers.to_bytes(extension), name=f"new.{extension}").markers
    assert found is not None
    chosen = [index for index, kind in enumerate(markers.kinds) if kind == "POSITION"]
    own = markers.positions[chosen].astype(np.float64) * markers.unit_m
    if not own.size:
        return
    others = found.positions * found.unit_m
    if extension == "csm":
        up = np.array(markers.up)
        # The heights, whatever was turned about the vertical.
        own, others = own @ up, others[..., 2]
    np.testing.assert_allclose(others, own, atol=1e-9)


def test_an_empty_file_is_met_with_words() -> None:
    with pytest.raises(mt.ParseError, match="an empty file"):
        mt.read_bytes(b"", name="empty.c3d")


@pytest.mark.parametrize("name", EVERY_FILE)
def test_which_way_markers_face_comes_with_a_reason(name: str) -> None:
    clip, markers = read(name)
    facing = markers.facing()
    assert f"Facing: {facing.reason}" in clip.notices
    assert np.dot(facing.value, markers.up) == 0
    assert np.linalg.norm(facing.value) == 1


def test_a_walk_to_the_positive_end_of_x_faces_there() -> None:
    if not SHARED.is_dir():
        return
    _, markers = read("c3d/cmu_02_01.c3d")
    pelvis = np.nanmean(markers.positions[[name.endswith("FWT") for name in markers.names]], axis=0)
    assert pelvis[-1, 0] - pelvis[0, 0] > 2000  # millimetres
    facing = markers.facing()
    assert (facing.value, facing.is_certain) == ((1, 0, 0), True)
    assert "names of left and right" in facing.reason
