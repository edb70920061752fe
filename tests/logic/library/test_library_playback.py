"""Playing by time, paging, marks, the timeline and what is typed into the search box."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic.library.clock import Clock, frame_at, seconds
from addon.logic.library.field import TextField
from addon.logic.library.marks import Marks
from addon.logic.library.pages import Pages
from addon.logic.library.rect import Rect
from addon.logic.library.timeline import Timeline


@given(st.lists(st.floats(0.001, 3.0), min_size=1, max_size=30))
def test_playback_is_as_far_however_seldom_it_is_looked_at(looks: list[float]) -> None:
    often, once = Clock(duration_s=1000.0), Clock(duration_s=1000.0)
    often.play(5.0)
    once.play(5.0)
    now = 5.0
    for wait in looks:
        now += wait
        often.position(now)
    assert often.position(now) == pytest.approx(once.position(now))
    assert once.position(now) == pytest.approx(now - 5.0)


def test_playback_begins_anew_at_the_end_and_stays_between_the_marks() -> None:
    one = Clock(duration_s=3.0, start_s=1.0)
    one.play(0.0)
    assert one.position(0.0) == 1.0
    assert one.position(1.5) == pytest.approx(2.5)
    assert one.position(2.5) == pytest.approx(1.5)


def test_another_speed_holds_from_now_on() -> None:
    one = Clock(duration_s=100.0)
    one.play(0.0)
    one.set_speed(0.5, 10.0)
    assert one.position(10.0) == pytest.approx(10.0)
    assert one.position(20.0) == pytest.approx(15.0)
    one.faster(1, 20.0)
    assert one.speed == 1.0
    one.faster(-9, 20.0)
    assert one.speed == 0.1


def test_stop_returns_to_the_first_frame_and_step_pauses() -> None:
    one = Clock(duration_s=10.0)
    one.play(0.0)
    one.step(0.5, 2.0)
    assert (one.is_playing, one.position(99.0)) == (False, 2.5)
    one.step(-50.0, 3.0)
    assert one.position(3.0) == 0.0
    one.step(50.0, 3.0)
    assert one.position(3.0) == 10.0
    one.stop()
    assert one.position(4.0) == 0.0


def test_playing_at_the_end_begins_at_the_start() -> None:
    one = Clock(duration_s=2.0)
    one.scrub(2.0, 0.0)
    one.play(5.0)
    assert one.position(5.5) == 0.5


@given(st.floats(0, 1e4), st.integers(1, 5000), st.floats(1, 1000))
def test_a_frame_is_one_that_there_is(position: float, frames: int, rate: float) -> None:
    assert 0 <= frame_at(position, frames, rate) <= frames - 1


def test_a_clip_without_a_rate_or_of_one_frame_stands_still() -> None:
    assert frame_at(3.0, 100, 0.0) == 0.0
    assert frame_at(3.0, 1, 60.0) == 0.0
    assert seconds(1, 60.0) == 0.0
    assert seconds(121, 60.0) == 2.0


def test_paging_reaches_every_clip_and_stops_at_the_ends() -> None:
    page = Pages(10, 4)
    shown = list(page.shown)
    while page.has_next:
        page = page.turned(1)
        shown += page.shown
    assert shown == list(range(10))
    assert page.turned(1) == page
    assert page.turned(-9).first == 0
    assert Pages(10, 4, 9).words() == "10 of 10"
    assert Pages(3000, 4, 4).words() == "5-8 of 3,000"


def test_a_page_may_begin_with_any_clip_and_keeps_it_when_resized() -> None:
    assert list(Pages(10, 4, 7).resized(9).shown) == [7, 8, 9]
    assert Pages(10, 4, 2).turned(-1).first == 0


def test_marks_become_the_cut_of_a_track() -> None:
    marks = Marks(1, 300)
    assert marks.cut() == (0, 0)
    marks = marks.with_begin(50.4).with_end(120)
    assert marks.cut() == (50, 120)
    assert marks.range == (50, 120)
    assert marks.with_begin(1).cut() == (0, 120)
    assert marks.with_end(999).cut() == (50, 0)
    assert marks.cleared() == Marks(1, 300)


def test_a_mark_beyond_the_other_takes_it_away() -> None:
    marks = Marks(1, 300).with_begin(100).with_end(200)
    assert marks.with_begin(250).range == (250, 300)
    assert marks.with_end(50).range == (1, 50)


@given(st.integers(-500, 500), st.integers(1, 1000), st.data())
def test_what_is_shown_between_the_marks_is_what_the_cut_gives(first: int, length: int, data: st.DataObject) -> None:
    last = first + length
    frame = data.draw(st.integers(first, last))
    for marks, shown in (
        (Marks(first, last).with_begin(frame), lambda marks: marks.range[0]),
        (Marks(first, last).with_end(frame), lambda marks: marks.range[1]),
    ):
        start, end = marks.cut()
        assert (start or first, end or last) == marks.range
        assert first <= marks.range[0] <= marks.range[1] <= last
        assert shown(marks) == frame or (frame == 0 and abs(shown(marks)) == 1)


def test_a_mark_on_frame_zero_inside_of_a_clip_is_set_on_the_next_one() -> None:
    below_zero = Marks(-10, 10)
    assert below_zero.with_begin(0).range == (1, 10)
    assert below_zero.with_end(0).range == (-10, -1)
    from_zero = Marks(0, 10)
    assert from_zero.with_begin(0).cut() == (0, 0)
    assert from_zero.with_end(0).range == (0, 1)
    assert Marks(-10, 0).with_begin(0).range == (-1, 0)
    assert Marks(-10, 0).with_end(0).cut() == (0, 0)
    assert Marks(0, 0).with_begin(0).with_end(0).cut() == (0, 0)


TIMELINE = Timeline(Rect(100, 10, 400, 16), 1, 401)


@given(st.floats(1, 401))
def test_the_frame_at_the_place_of_a_frame_is_that_frame(frame: float) -> None:
    assert TIMELINE.frame(TIMELINE.x(frame)) == pytest.approx(frame)


def test_marks_are_taken_hold_of_before_the_playhead() -> None:
    marks = Marks(1, 401).with_begin(100).with_end(300)
    assert TIMELINE.grip(TIMELINE.x(100) + 3, 15, marks, 6) == "BEGIN"
    assert TIMELINE.grip(TIMELINE.x(300) - 3, 15, marks, 6) == "END"
    assert TIMELINE.grip(TIMELINE.x(200), 15, marks, 6) == "HEAD"
    assert TIMELINE.grip(TIMELINE.x(100), 60, marks, 6) is None
    assert TIMELINE.grip(TIMELINE.x(100), 15, None, 6) == "HEAD"


def test_ticks_are_round_numbers_that_do_not_crowd() -> None:
    assert TIMELINE.ticks(70) == [100, 200, 300, 400]
    assert Timeline(Rect(0, 0, 400, 16), 5, 5).ticks(70) == []


def test_the_search_box_is_edited_as_any_other() -> None:
    box = TextField()
    box.begin()
    for character in "walk rate>=100":
        box.insert(character)
    box.press("HOME")
    box.insert("-")
    assert box.text == "-walk rate>=100"
    box.press("RIGHT_ARROW", by_word=True)
    assert box.cursor == 5
    box.press("END")
    box.press("BACK_SPACE", by_word=True)
    assert box.text == "-walk "
    box.begin()
    box.insert("run\n")
    assert box.text == "run"
    box.press("LEFT_ARROW")
    box.press("DEL")
    assert box.text == "ru"
    assert not box.press("F5")
