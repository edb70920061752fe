"""Caches that stay within their bounds, and a background thread that does what is wanted last."""

from __future__ import annotations

import threading
import time
from collections import deque

from hypothesis import given
from hypothesis import strategies as st

from addon.logic.library import facts
from addon.logic.library.kept import Kept
from addon.logic.library.lane import Done, Lane


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(1, 40)), max_size=60))
def test_a_cache_never_holds_more_than_its_bound_but_for_one_value(kept: list[tuple[int, int]]) -> None:
    cache: Kept[int] = Kept("Test", 100)
    for key, size in kept:
        cache.keep(key, size, size)
        assert cache.get(key) == size
        assert cache.bytes <= 100 or len(cache) == 1
        assert cache.bytes == sum(cache.get(k) or 0 for k in range(10))
    assert cache.peak <= 100


def test_what_was_asked_for_last_stays() -> None:
    cache: Kept[str] = Kept("Test", 3)
    for name in "abc":
        cache.keep(name, name, 1)
    cache.get("a")
    cache.keep("d", "d", 1)
    assert "a" in cache
    assert "b" not in cache
    cache.keep("large", "large", 50)
    assert len(cache) == 1
    cache.clear()
    assert cache.bytes == 0


def run(*, newest_first: bool) -> list[int]:
    """Ask for ten calls while the thread is busy; return the order in which they were made."""
    finished: deque[Done] = deque()
    lane = Lane("test", finished, newest_first=newest_first)
    gate, made = threading.Event(), []
    lane.ask("gate", lambda: gate.wait(5.0), lambda result, error: None)
    while not lane.waits("gate") or lane._waiting:
        time.sleep(0.001)
    for number in range(10):
        lane.ask(number, lambda number=number: made.append(number), lambda result, error: None)  # type: ignore[misc]
    lane.ask(3, lambda: made.append(33), lambda result, error: None)
    gate.set()
    while not lane.is_idle:
        time.sleep(0.001)
    lane.close()
    assert len(finished) == 11
    return made


def test_what_is_looked_at_is_fetched_newest_first_and_edits_are_made_in_their_order() -> None:
    assert run(newest_first=True) == [33, 9, 8, 7, 6, 5, 4, 2, 1, 0]
    assert run(newest_first=False) == [0, 1, 2, 4, 5, 6, 7, 8, 9, 33]


def test_an_error_in_the_background_is_a_result() -> None:
    finished: deque[Done] = deque()
    lane = Lane("test", finished)
    lane.ask("bad", lambda: 1 / 0, lambda result, error: None)
    while not finished:
        time.sleep(0.001)
    assert isinstance(finished[0].error, ZeroDivisionError)
    lane.close()


def test_of_pictures_that_nobody_will_see_the_oldest_are_dropped() -> None:
    finished: deque[Done] = deque()
    lane = Lane("test", finished, newest_first=True)
    gate = threading.Event()
    lane.ask("gate", lambda: gate.wait(5.0), lambda result, error: None)
    for number in range(1000):
        lane.ask(number, lambda: None, lambda result, error: None)
    assert not lane.waits(1)
    assert lane.waits(999)
    lane.drop()
    assert not lane.waits(999)
    gate.set()
    lane.close()


def test_facts_are_said_as_people_say_them() -> None:
    assert facts.size(999) == "999 bytes"
    assert facts.size(1_234_567) == "1.2 MB"
    assert facts.size(96_000) == "96 kB"
    assert facts.duration(2.64) == "2.6 s"
    assert facts.duration(125) == "2:05 min"
    assert facts.duration(None) == ""
    assert facts.rate(120.00048) == "120 Hz"
    assert facts.rate(None) == "rate not known"
    assert facts.count(1, "clip", "clips") == "1 clip"
    assert facts.count(3000, "clip", "clips") == "3,000 clips"


def test_filters_are_terms_of_the_search() -> None:
    filters = {"format": "c3d", "tag": "turn left", "cleaned": ""}
    assert facts.query(" walk ", filters) == 'walk format:c3d tag:"turn left"'
    assert facts.query("", {}) == ""


def test_tags_are_typed_with_commas() -> None:
    assert facts.tags(" walk,  turn   left ,Walk,,") == ["walk", "turn left"]


def test_at_the_end_a_lane_drops_what_waits_unless_it_is_to_finish_that() -> None:
    for finishes, expected in ((False, []), (True, [0, 2])):
        lane, gate = Lane("test", deque()), threading.Event()
        made: list[int] = []
        lane.ask("gate", lambda gate=gate: gate.wait(5.0), lambda result, error: None)  # type: ignore[misc]
        while lane._waiting:
            time.sleep(0.001)
        for number in range(3):
            lane.ask(number, lambda number=number, made=made: made.append(number), lambda *_: None)  # type: ignore[misc]
        lane.forget(1)
        threading.Timer(0.05, gate.set).start()
        lane.close(5.0, finishes=finishes)
        assert made == expected
