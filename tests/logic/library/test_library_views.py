"""Which of the views the filters amount to."""

from __future__ import annotations

import pytest

from addon.logic.library import views


@pytest.mark.parametrize("view", views.VIEWS)
def test_a_view_takes_the_place_of_another_and_leaves_other_filters(view: str) -> None:
    for before in views.VIEWS:
        filters = views.applied({"format": "bvh"} | views.VIEWS[before], view)
        assert views.of(filters) == view
        assert filters == {"format": "bvh"} | views.VIEWS[view]


def test_a_filter_that_no_view_has_is_all_clips() -> None:
    assert views.of({"broken": "no"}) == "ALL"
    assert views.applied({"broken": "no", "used": "7d"}, "ALL") == {}
