"""The fields that say which clips are shown. They read and write the session."""

from __future__ import annotations

from typing import Any

from bpy.props import EnumProperty
from bpy.types import PropertyGroup

from ..logic.library import views
from . import session

SHOWS = (
    ("ALL", "All Clips", "Show all clips", "FILE_MOVIE", 0),
    ("FAVOURITES", "Favorites", "Show your favorites", "SOLO_ON", 1),
    (
        "RECENT",
        "Recently Used",
        "Show the clips that you brought into a scene in the last 30 days, the latest first",
        "TIME",
        2,
    ),
    ("BROKEN", "Not Readable", "Show the files that cannot be read", "ERROR", 3),
    ("MISSING", "Missing", "Show the clips whose file is gone", "UNLINKED", 4),
)
ANY = ("ANY", "All", "Do not filter")
YES_NO = (ANY, ("yes", "Yes", "Only clips that are"), ("no", "No", "Only clips that are not"))
CLEANED = (*YES_NO, ("unknown", "Not Known", "Only clips of which that is not known"))
USED = (
    ANY,
    ("7d", "Last 7 Days", "Only clips that were brought into a scene in the last 7 days"),
    ("30d", "Last 30 Days", "Only clips that were brought into a scene in the last 30 days"),
    ("yes", "Ever", "Only clips that were brought into a scene"),
    ("no", "Never", "Only clips that were never brought into a scene"),
)

_choices: dict[str, list[tuple[str, str, str]]] = {}


def choices(field: str) -> list[tuple[str, str, str]]:
    """Return the items of a menu of values. They are kept, for Blender does not keep their texts."""
    found = session.state.values.get(field, [])
    items = [ANY]
    items += [(value, f"{value} ({count:,})", "") for value, count in found if value]
    chosen = session.state.filters.get(field)
    if chosen and chosen not in {item[0] for item in items}:
        items.append((chosen, f"{chosen} (0)", ""))
    _choices[field] = items
    return items


def of_values(field: str) -> Any:
    """Return a menu that filters by the values that there are."""

    def items(self: PropertyGroup, context: Any) -> list[tuple[str, str, str]]:
        return choices(field)

    get, put = _access(field, lambda: choices(field))
    what = field.title()
    return EnumProperty(name=what, description=f"Show only clips of this {field}", items=items, get=get, set=put)


def of_kinds(field: str, name: str, description: str, items: Any) -> Any:
    """Return a menu that filters by a few kinds."""
    get, put = _access(field, lambda: items)
    return EnumProperty(name=name, description=description, items=items, get=get, set=put)


def of_views() -> Any:
    """Return the menu of what people look at most often."""
    names = [item[0] for item in SHOWS]

    def get(self: PropertyGroup) -> int:
        return names.index(views.of(session.state.filters))

    def put(self: PropertyGroup, value: int) -> None:
        session.show(names[value])

    return EnumProperty(name="Show", description="Which clips are shown", items=SHOWS, get=get, set=put)


def _access(field: str, items: Any) -> tuple[Any, Any]:
    """Return how a menu reads and writes the filter of a field."""

    def get(self: PropertyGroup) -> int:
        chosen = session.state.filters.get(field, "ANY")
        return next((number for number, item in enumerate(items()) if item[0] == chosen), 0)

    def put(self: PropertyGroup, value: int) -> None:
        chosen = items()[value][0]
        session.set_filter(field, "" if chosen == "ANY" else chosen)

    return get, put
