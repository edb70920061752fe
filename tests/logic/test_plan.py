"""Which entry acts on which bones."""

from __future__ import annotations

import pytest

from addon.logic.messages import UserError
from addon.logic.plan import Entry, Kind, check_depth, frame_or_none, plan

BONES = ["root", "leg", "arm"]


def entry(kind: Kind, *bones: str, enabled: bool = True) -> Entry:
    return Entry(kind, kind.lower(), enabled, bones or None)


def acting(*entries: Entry) -> list[tuple[int, tuple[int, ...]]]:
    return [(step.entry, step.bones) for step in plan(entries, BONES).steps]


def test_all_bones_or_those_that_are_named() -> None:
    assert acting(entry("TRACK"), entry("FILTER", "arm", "leg")) == [(0, (0, 1, 2)), (1, (1, 2))]


def test_a_muted_entry_takes_no_part() -> None:
    assert acting(entry("TRACK", enabled=False), entry("TRACK", "arm")) == [(1, (2,))]
    assert plan([entry("KEPT", "arm", enabled=False)], BONES).touched == set()


def test_kept_edits_replace_what_lies_below_them() -> None:
    stack = [entry("TRACK"), entry("KEPT", "arm"), entry("FILTER")]
    assert acting(*stack) == [(0, (0, 1)), (2, (0, 1, 2))]
    assert plan(stack, BONES).kept == {2: 1}


def test_the_upper_of_two_kept_edits_counts() -> None:
    stack = [entry("KEPT", "arm"), entry("FILTER", "arm"), entry("KEPT", "arm")]
    result = plan(stack, BONES)
    assert result.steps == []
    assert result.kept == {2: 2}
    assert result.notices == [(1, "Kept edits above replace this entry on all its bones")]


def test_bones_that_are_gone_are_said() -> None:
    result = plan([entry("TRACK", "arm", "tail", "wing")], BONES)
    assert [step.bones for step in result.steps] == [(2,)]
    assert result.notices == [(0, "The armature has no bone tail, wing")]


def test_touched_bones_are_those_of_tracks_filters_and_kept_edits() -> None:
    assert plan([entry("TRACK", "leg"), entry("KEPT", "arm")], BONES).touched == {1, 2}


@pytest.mark.parametrize("depth", [-3, 0, 1, 2, 4, 100])
def test_a_depth_needs_a_middle(depth: int) -> None:
    with pytest.raises(UserError, match=f"odd number from 3 on, not {depth}"):
        check_depth(depth)
    check_depth(depth * 2 + 9 if depth < 0 else depth * 2 + 3)


def test_zero_is_an_empty_field() -> None:
    assert [frame_or_none(value) for value in (0, 1, -5)] == [None, 1, -5]
