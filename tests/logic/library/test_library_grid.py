"""Which tile of the grid is where, and which one the mouse and the arrow keys mean."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic.library.free_area import free_area
from addon.logic.library.grid import Grid
from addon.logic.library.rect import Rect, cells

VIEW = Rect(10, 20, 640, 300)


def grid(count: int = 100, view: Rect = VIEW) -> Grid:
    return Grid(view, count, tile_width=150, tile_height=120, gap=8)


def test_tiles_share_the_width_and_begin_at_the_top_left() -> None:
    one = grid()
    assert one.columns == 4
    first, last = one.tile(0, 0.0), one.tile(3, 0.0)
    assert (first.x, first.top) == (18, 312)
    assert last.right == pytest.approx(642)
    assert first.width == last.width


@given(st.integers(1, 5000), st.floats(0, 1), st.integers(60, 1500), st.integers(60, 900), st.data())
def test_the_tile_under_a_point_is_the_one_that_covers_it(
    count: int, share: float, width: int, height: int, data: st.DataObject
) -> None:
    one = grid(count, Rect(0, 0, width, height))
    scroll = share * one.largest_scroll
    x, y = data.draw(st.floats(0, width - 1)), data.draw(st.floats(0, height - 1))
    covering = [index for index in range(count) if one.tile(index, scroll).contains(x, y)]
    assert ([one.at(x, y, scroll)] if one.at(x, y, scroll) is not None else []) == covering


@given(st.integers(1, 5000), st.floats(0, 1))
def test_what_is_seen_is_what_overlaps_the_view(count: int, share: float) -> None:
    one = grid(count)
    scroll = share * one.largest_scroll
    tiles = {index: one.tile(index, scroll) for index in range(count)}
    overlapping = {index for index, tile in tiles.items() if tile.top > VIEW.y and tile.y < VIEW.top}
    assert overlapping <= set(one.visible(scroll))
    assert len(one.visible(scroll)) <= len(overlapping) + 2 * one.columns


@given(st.integers(1, 3000), st.data())
def test_scrolling_to_a_tile_shows_it_whole_and_moves_no_more_than_needed(count: int, data: st.DataObject) -> None:
    one = grid(count)
    index, scroll = data.draw(st.integers(0, count - 1)), data.draw(st.floats(0, one.largest_scroll))
    moved = one.scroll_to(index, scroll)
    tile = one.tile(index, moved)
    assert tile.y >= VIEW.y - 1e-6
    assert tile.top <= VIEW.top + 1e-6
    before = one.tile(index, scroll)
    if before.y >= VIEW.y + one.gap and before.top <= VIEW.top - one.gap:
        assert moved == pytest.approx(scroll)


def test_outside_of_the_view_there_is_no_tile() -> None:
    assert grid().at(5, 100, 0.0) is None
    assert grid().at(100, 321, 0.0) is None


def test_arrow_keys_stay_in_the_grid() -> None:
    one = grid(10)
    assert one.moved(0, -1, 0) == 0
    assert one.moved(9, 1, 0) == 9
    assert one.moved(0, 0, 1) == 4
    assert one.moved(8, 0, 1) == 8
    assert one.moved(1, 0, -1) == 1


def test_the_scroll_bar_is_there_only_where_something_is_hidden_and_leads_back_to_its_scroll() -> None:
    assert grid(4).bar(0.0, 9) is None
    one = grid(3000)
    for share in (0.0, 0.3, 1.0):
        handle = one.bar(share * one.largest_scroll, 9)
        assert handle is not None
        assert VIEW.y - 1e-6 <= handle.y
        assert handle.top <= VIEW.top + 1e-6
        assert one.scroll_at(handle.middle[1], handle.height) == pytest.approx(share * one.largest_scroll)


@pytest.mark.parametrize(("count", "places"), [(1, 1), (4, 4), (9, 9)])
def test_stages_do_not_overlap_and_fill_the_area(count: int, places: int) -> None:
    found = cells(Rect(0, 0, 900, 600), count, 6)
    assert len(found) == places
    assert max(cell.right for cell in found) == pytest.approx(900)
    assert min(cell.y for cell in found) == pytest.approx(0)
    assert found[0].top == pytest.approx(600)
    for number, one in enumerate(found):
        assert not any(one.contains(*other.middle) for other in found[number + 1 :])


def test_what_lies_over_the_edges_of_a_view_is_not_drawn_on() -> None:
    whole = Rect(0, 0, 1000, 600)
    toolbar, sidebar, header = Rect(0, 0, 50, 570), Rect(720, 0, 280, 570), Rect(0, 570, 1000, 30)
    beside = Rect(0, 600, 1000, 26)
    assert free_area(whole, [toolbar, sidebar, header, beside]) == Rect(50, 0, 670, 570)
