"""The grid and the stage without a window: what they show, and what mouse and keys do there."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests import harness
from tests.scene import library_stage as library

closing, grid_view, stage_view = (
    harness.module(name) for name in ("library.closing", "stage.grid_view", "stage.stage_view")
)
session = library.session


@pytest.fixture(autouse=True)
def _library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("MOTION_THEATER_LIBRARY", str(tmp_path / "library.sqlite"))
    monkeypatch.setattr(harness.module("stage.textures"), "get", lambda key, picture: None)
    library.scanned(tmp_path / "clips")
    yield
    closing.close()


def grid() -> library.Screen:
    screen = library.Screen(grid_view.GridView)
    screen.draw()
    return screen


def stage(size: int, name: str = "walk.amc") -> library.Screen:
    library.choose(name)
    screen = library.Screen(lambda host: stage_view.StageView(host, size))
    screen.draw()
    return screen


def on_tile(screen: library.Screen, name: str) -> None:
    """Put the mouse on a clip."""
    screen.mouse = screen.view.grid.tile(library.shown().index(name), grid_view.Remembered.scroll).middle


def test_the_grid_shows_every_clip_with_its_facts_and_why_one_cannot_be_read() -> None:
    texts = grid().texts()
    for name in library.NAMES:
        assert name in texts
    assert "6 clips" in texts
    assert "Not readable" in texts
    assert any(text.startswith("AMC") and "Hz" in text for text in texts)


def test_the_first_redraw_has_the_clips_that_a_quick_search_finds(monkeypatch: pytest.MonkeyPatch) -> None:
    closing.close()
    monkeypatch.setattr(session, "MOMENT_S", 60.0)
    screen = library.Screen(grid_view.GridView)
    screen.view.draw(library.canvas.Canvas(1.0), screen._window())
    assert screen.view.grid.count == len(library.NAMES)


def test_a_click_selects_and_a_double_click_opens() -> None:
    screen = grid()
    on_tile(screen, "turn.amc")
    assert screen.press("LEFTMOUSE")
    screen.press("LEFTMOUSE", value="RELEASE")
    assert session.state.active == library.shown().index("turn.amc")
    assert not screen.host.views
    screen.press("LEFTMOUSE", value="DOUBLE_CLICK")
    (opened,) = screen.host.views
    assert opened.is_single


def test_everything_outside_the_drawer_passes_through() -> None:
    screen = grid()
    screen.mouse = (600.0, 780.0)
    assert not screen.press("LEFTMOUSE")
    assert not screen.press("G")
    assert not screen.press("WHEELUPMOUSE")
    screen.mouse = (600.0, 200.0)
    assert screen.press("G"), "keys over the drawer must not act on the scene"
    assert not screen.press("Z", ctrl=True), "but undo is the user's own"


def test_typing_searches_and_esc_leaves_the_box_before_the_grid() -> None:
    screen = grid()
    screen.press("F", ctrl=True)
    for character in "wave":
        assert screen.press(character.upper(), text=character)
    library.settle()
    assert library.shown() == ["wave.amc"]
    screen.draw()
    assert "1 of 6 clips" in screen.texts()
    screen.press("A", ctrl=True, text="a")
    screen.press("V", ctrl=True, text="v")
    assert session.state.words == "pasted"
    screen.press("BACK_SPACE", ctrl=True)
    library.settle()
    assert len(library.shown()) == 6
    screen.press("ESC")
    assert not screen.host.left
    screen.press("ESC")
    assert screen.host.left == 1


def drag(screen: library.Screen, x: float, y: float) -> list[str]:
    """Drag a clip to a place and let go; return what was called. What was said on the way is in `texts`."""
    screen.host.calls.clear()
    on_tile(screen, "walk.amc")
    screen.press("LEFTMOUSE")
    screen.move(screen.mouse[0] + 40, screen.mouse[1] + 40)
    screen.move(x, y)
    screen.draw()
    screen.press("LEFTMOUSE", value="RELEASE")
    return [name for name, _ in screen.host.calls]


def test_a_clip_dragged_out_of_the_drawer_is_added_and_one_let_go_inside_is_not() -> None:
    screen = grid()
    assert drag(screen, 600.0, 780.0) == ["library_add_track"]
    assert "Release to add as track" in screen.texts()
    assert drag(screen, 500.0, 200.0) == []
    assert "Release to add as track" not in screen.texts()


def test_where_no_armature_is_active_a_dragged_clip_is_imported() -> None:
    screen = grid()
    screen.host.reasons["library_add_track"] = "Select an armature"
    assert drag(screen, 600.0, 780.0) == ["library_import"]
    assert "Release to import as new" in screen.texts()


def test_buttons_that_cannot_be_used_say_why_and_do_nothing() -> None:
    screen = grid()
    screen.host.reasons["library_add_track"] = "Select the armature that gets the track"
    screen.draw()
    (add,) = [one for one in screen.view.placed if one.button.name == "ADD"]
    screen.mouse = add.area.middle
    screen.draw()
    assert "Select the armature that gets the track" in screen.texts()
    screen.press("LEFTMOUSE")
    assert not screen.host.calls


def test_the_edge_can_be_dragged_and_stays_in_the_view() -> None:
    screen = grid()
    before = grid_view.Remembered.share
    screen.mouse = (600.0, screen.view.area.top)
    screen.press("LEFTMOUSE")
    screen.move(600.0, 790.0)
    screen.press("LEFTMOUSE", value="RELEASE")
    screen.draw()
    assert screen.view.area.top > 770
    screen.mouse = (600.0, screen.view.area.top)
    screen.press("LEFTMOUSE")
    screen.move(600.0, 3.0)
    screen.press("LEFTMOUSE", value="RELEASE")
    screen.draw()
    assert screen.view.area.height > 150
    grid_view.Remembered.share = before


def test_four_clips_play_at_once_by_time() -> None:
    screen = stage(4, "own.bvh")
    texts = screen.texts()
    for name in ("own.bvh", "turn.amc", "walk.amc", "wave.amc"):
        assert name in texts
    body = screen.view.body()
    assert screen.view.is_moving(screen.now)
    screen.now += 0.5 / body.rate_hz
    assert screen.view.frame(body, screen.now) == pytest.approx(0.5)
    screen.press("SPACE")
    screen.now += 10.0
    assert screen.view.frame(body, screen.now) == pytest.approx(0.5)
    assert not screen.view.is_moving(screen.now)


def test_paging_selects_the_first_clip_of_the_page() -> None:
    screen = stage(1, "turn.amc")
    screen.press("PAGE_DOWN")
    screen.draw()
    assert library.rows.active().name == "walk.amc"
    screen.press("PAGE_UP")
    screen.press("PAGE_UP")
    screen.draw()
    assert library.rows.active().name == "own.bvh"


def test_marks_are_set_at_the_playhead_and_go_into_the_track() -> None:
    screen = stage(1)
    view, body = screen.view, screen.view.body()
    screen.press("SPACE")
    for key, frame in (("I", 20), ("O", 60)):
        view.clock.scrub((frame - body.first_frame) / body.rate_hz, screen.now)
        screen.press(key)
    assert view.marks().range == (20, 60)
    screen.draw()
    assert "Cut 20-60" in screen.texts()
    screen.button("ADD")
    clip = library.rows.active()
    assert screen.host.calls == [("library_add_track", {"clip": clip.id, "cut_start": 20, "cut_end": 60})]
    screen.button("USABLE")
    assert screen.host.calls[-1] == ("library_mark_usable", {"clip": clip.id, "first": 20, "last": 60})
    screen.press("SPACE")
    screen.now += 1000.0
    assert 20 <= view.frame(body, screen.now) + body.first_frame <= 60, "playback stays between the marks"
    screen.button("CLEAR")
    assert not view.marks().are_set


def test_a_mark_can_be_dragged_with_the_mouse() -> None:
    screen = stage(1)
    bar = screen.view.transport.timeline
    screen.mouse = (bar.x(bar.first), bar.bar.middle[1])
    assert screen.press("LEFTMOUSE")
    screen.move(bar.x(30), 500.0)
    screen.press("LEFTMOUSE", value="RELEASE")
    assert screen.view.marks().range[0] == 30
    assert not screen.move(700.0, 500.0), "after letting go the mouse is free"


def test_looking_around_goes_to_the_view_and_the_scene_is_safe_from_other_keys() -> None:
    screen = stage(4)
    for kind in ("MIDDLEMOUSE", "WHEELUPMOUSE", "NUMPAD_1", "TRACKPADPAN", "MOUSEMOVE"):
        assert not screen.press(kind), kind
    for kind in ("X", "G", "DEL", "TAB"):
        assert screen.press(kind), kind
    assert not screen.press("S", ctrl=True)


def test_zooming_the_view_zooms_the_stages() -> None:
    screen = stage(1)

    def height() -> float:
        ((moving, _),) = [one for _, layers in screen.draw()._clips for layer in layers for one in layer.figures]
        shown = moving.cast.places[moving.cast.colors[:, 3] > 0]
        return float(shown[:, 1].max() - shown[:, 1].min())

    screen.rotation = library.np.array([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]])
    before = height()
    screen.distance = 20.0
    assert height() < 0.7 * before


def test_what_looks_the_same_is_the_same_for_the_graphics_card() -> None:
    """Between two redraws of a clip that plays, only figures and the playhead move, and words change."""
    screen = stage(4)
    screen.draw()
    before = [layer for _, layers in screen.sheet._clips for layer in layers]
    screen.now += 0.3
    after = [layer for _, layers in screen.draw()._clips for layer in layers]
    assert [layer.flat for layer in before] == [layer.flat for layer in after]
    assert [layer.shift for layer in before] != [layer.shift for layer in after]
    figures = [{id(moving) for layer in layers for moving, _ in layer.figures} for layers in (before, after)]
    assert len(figures[0]) == 1
    assert figures[0] == figures[1]


def test_what_cannot_be_read_says_so_on_its_stage() -> None:
    screen = stage(4, "broken.bvh")
    said = " ".join(screen.texts())
    assert "OFFSET" in said or "number" in said, said


def test_browsing_makes_no_data_blocks() -> None:
    before = library.data_blocks()
    screen = grid()
    for name in library.NAMES:
        on_tile(screen, name)
        screen.draw()
        screen.now += 1.0
        screen.draw()
    for size in (1, 4, 9):
        on_stage = stage(size, "own.bvh")
        for key in ("SPACE", "RIGHT_ARROW", "PAGE_DOWN", "PAGE_UP", "I", "O", "P", "UP_ARROW", "HOME"):
            on_stage.press(key)
            on_stage.now += 0.3
            on_stage.draw()
    assert library.data_blocks() == before


def test_caches_are_bounded_and_say_what_they_are() -> None:
    for where, name in (("rows", "ROWS"), ("pictures", "STILLS"), ("pictures", "STRIPS"), ("bodies", "BODIES")):
        cache = getattr(harness.module(f"library.{where}"), name)
        assert cache.name
        assert 0 < cache.limit <= 256_000_000
        assert cache.bytes <= cache.limit
