"""Markers of one's own: what is given comes back, also from a file."""

from __future__ import annotations

import numpy as np
import pytest

import motion_theater as mt

FRAMES = 12


def walk() -> mt.Markers:
    """Return two markers at 60 Hz; the second drops out for three frames."""
    points = np.zeros((2, FRAMES, 3))
    points[:, :, 0] = np.arange(FRAMES) * 10.0
    points[1, 4:7] = np.nan
    events: list[tuple[str, float] | tuple[str, float, str, str]] = [
        ("Clap", 0.05),
        ("Foot Strike", 0.1, "Left", "Anna"),
    ]
    return mt.Markers(["a", "b"], points, rate_hz=60.0, unit_m=0.001, events=events)


def test_events_have_context_and_subject_where_they_are_given() -> None:
    back = mt.read_bytes(walk().to_bytes("c3d"), name="walk.c3d").markers
    assert back is not None
    told = [(event.label, event.context, event.subject) for event in back.events]
    assert told == [("Clap", "", ""), ("Foot Strike", "Left", "Anna")]
    assert [event.time_s for event in back.events] == pytest.approx([0.05, 0.1])


def test_analog_channels_come_back_from_a_file() -> None:
    ramp, wave = np.arange(24.0) * 0.5, np.sin(np.arange(24.0))
    markers = walk().with_analog([("Fz", "Plate 1", "N", ramp), ("EMG", "", "mV", wave)], 2)
    back = mt.read_bytes(markers.to_bytes("c3d"), name="walk.c3d").markers
    assert back is not None
    assert back.analog_samples_per_frame == 2
    assert [(one.name, one.description, one.unit, one.rate_hz) for one in back.analog] == [
        ("Fz", "Plate 1", "N", 120.0),
        ("EMG", "", "mV", 120.0),
    ]
    assert np.array_equal(back.analog[0].samples, ramp)
    assert np.abs(back.analog[1].samples - wave).max() < 1e-7
    assert not markers.with_analog([], 1).analog


@pytest.mark.parametrize(("samples", "per_frame"), [(11, 1), (12, 2), (0, 0), (12, 2**62)])
def test_signals_of_another_length_are_refused(samples: int, per_frame: int) -> None:
    with pytest.raises(mt.ParameterError, match=r"`Fz`: expected \d+ samples, found"):
        walk().with_analog([("Fz", "", "N", np.zeros(samples))], per_frame)


def test_another_rate_keeps_moments_and_gaps() -> None:
    finer = walk().resampled(120.0)
    assert (finer.frames, finer.rate_hz, finer.first_frame) == (2 * FRAMES - 1, 120.0, 1)
    assert np.allclose(finer.positions[0, :, 0], np.arange(2 * FRAMES - 1) * 5.0)
    assert np.flatnonzero(~finer.valid[1]).tolist() == [7, 8, 9, 10, 11, 12, 13]
    assert [event.time_s for event in finer.events] == [0.05, 0.1]
    with pytest.raises(mt.ParameterError, match="above 0"):
        walk().resampled(-1.0)
