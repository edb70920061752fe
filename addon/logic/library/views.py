"""The clips that people look at most often, each a filter of its own: favorites, recently used ones, damaged ones."""

from __future__ import annotations

from collections.abc import Mapping

VIEWS: dict[str, dict[str, str]] = {
    "ALL": {},
    "FAVOURITES": {"favourite": "yes"},
    "RECENT": {"used": "30d"},
    "BROKEN": {"broken": "yes"},
    "MISSING": {"missing": "yes"},
}
"""Terms of the search, by the name of the view."""


def of(filters: Mapping[str, str]) -> str:
    """Return which of them filters amount to; all clips where they are none of the others."""
    fitting = (name for name, terms in VIEWS.items() if terms and terms.items() <= filters.items())
    return next(fitting, "ALL")


def applied(filters: Mapping[str, str], view: str) -> dict[str, str]:
    """Return filters with a view in the place of another; those that no view has stay."""
    own = {field for terms in VIEWS.values() for field in terms}
    return {field: value for field, value in filters.items() if field not in own} | VIEWS[view]
