"""The library's fields in the sidebar. They read and write the session, so nothing of them is stored in a .blend."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import bpy
from bpy.props import BoolProperty, CollectionProperty, EnumProperty, IntProperty, PointerProperty, StringProperty
from bpy.types import PropertyGroup

from ..logic.library import facts
from . import filters, notes, rows, session

if TYPE_CHECKING:
    import motion_theater

SHOWN_AT_MOST = 2000
"""Rows of the list in the sidebar; the grid shows all clips."""

SORTS = (
    ("name", "Name", "Sort by the name of the file"),
    ("path", "Folder", "Sort by where the file is"),
    ("date", "Recorded", "Sort by the day of the recording"),
    ("modified", "Changed", "Sort by when the file was changed"),
    ("duration", "Duration", "Sort by how long the clip plays"),
    ("rate", "Frame Rate", "Sort by samples per second"),
    ("frames", "Frames", "Sort by the number of frames"),
    ("size", "File Size", "Sort by the size of the file"),
    ("rating", "Rating", "Sort by rating"),
    ("used", "Recently Used", "Sort by when the clip was last brought into a scene"),
    ("relevance", "Relevance", "Sort by how well the clip fits the words of the search"),
)
LATEST_FIRST = frozenset({"date", "modified", "rating", "used"})
CLEANED = (
    ("UNKNOWN", "Not Known", "Nobody said whether this clip was cleaned"),
    ("YES", "Yes", "The clip was cleaned: gaps filled, spikes removed"),
    ("NO", "No", "The clip is as it was recorded"),
)
_CLEANED_VALUES = {"UNKNOWN": None, "YES": True, "NO": False}


def _write(field: str, value: object) -> None:
    clip = rows.active()
    if clip is not None:
        notes.edit(clip.id, {field: value})


def _words(field: str, name: str, description: str) -> Any:
    """Return a text of the selected clip that can be edited; an empty one takes the edit back."""

    def get(self: PropertyGroup) -> str:
        clip = rows.active()
        return str(getattr(clip, field) or "") if clip is not None else ""

    def put(self: PropertyGroup, value: str) -> None:
        if value != get(self):
            _write(field, value.strip() or None)

    return StringProperty(name=name, description=description, get=get, set=put)


def _get_tags(self: PropertyGroup) -> str:
    clip = rows.active()
    return ", ".join(clip.tags) if clip is not None else ""


def _set_tags(self: PropertyGroup, value: str) -> None:
    clip = rows.active()
    if clip is None:
        return
    wanted = facts.tags(value)
    folded = {tag.casefold() for tag in wanted}
    remove = [tag for tag in clip.tags if tag.casefold() not in folded]
    notes.tag(clip.id, wanted, remove)


def _clip_value(field: str, otherwise: Any) -> Any:
    def get(self: PropertyGroup) -> Any:
        clip = rows.active()
        return (getattr(clip, field) or otherwise) if clip is not None else otherwise

    return get


def _set_cleaned(self: PropertyGroup, value: int) -> None:
    _write("cleaned", _CLEANED_VALUES[CLEANED[value][0]])


def _get_cleaned(self: PropertyGroup) -> int:
    clip: motion_theater.LibraryClip | None = rows.active()
    cleaned = clip.cleaned if clip is not None else None
    return 0 if cleaned is None else 1 if cleaned else 2


def _set_words(self: PropertyGroup, value: str) -> None:
    if value != session.state.words:
        session.state.words = value
        session.search()


def _set_sort(self: PropertyGroup, value: int) -> None:
    session.state.sort = SORTS[value][0]
    session.state.descending = session.state.sort in LATEST_FIRST
    session.search()


def _get_sort(self: PropertyGroup) -> int:
    return next(number for number, item in enumerate(SORTS) if item[0] == session.state.sort)


def _set_descending(self: PropertyGroup, value: bool) -> None:
    session.state.descending = value
    session.search()


# Blender evaluates annotations by themselves: a lambda there would not find this module's names.
def _get_words(self: PropertyGroup) -> str:
    return session.state.words


def _get_descending(self: PropertyGroup) -> bool:
    return session.state.descending


def _get_active(self: PropertyGroup) -> int:
    return session.state.active


def _set_active(self: PropertyGroup, value: int) -> None:
    session.choose(value)


def _get_also_sidecar(self: PropertyGroup) -> bool:
    return session.state.also_sidecar


def _set_also_sidecar(self: PropertyGroup, value: bool) -> None:
    session.state.also_sidecar = value


def _setter(field: str) -> Any:
    def put(self: PropertyGroup, value: object) -> None:
        _write(field, value)

    return put


class LibraryRow(PropertyGroup):
    """A row of the list. What it shows is looked up by its place."""


class LibraryOptions(PropertyGroup):
    """The browser of the session."""

    search: StringProperty(
        name="Search",
        description='Words and terms: walk "turn left" -run subject:07 rate>=100 duration<10 format:c3d tag:good',
        get=_get_words,
        set=_set_words,
        options={"TEXTEDIT_UPDATE"},
    )
    sort: EnumProperty(name="Sort By", description="The order of the clips", items=SORTS, get=_get_sort, set=_set_sort)
    descending: BoolProperty(
        name="Descending",
        description="Turn the order round",
        get=_get_descending,
        set=_set_descending,
    )
    show: filters.of_views()
    filter_format: filters.of_values("format")
    filter_tag: filters.of_values("tag")
    filter_subject: filters.of_values("subject")
    filter_group: filters.of_values("group")
    filter_cleaned: filters.of_kinds(
        "cleaned", "Cleaned", "Show only clips that were cleaned, or were not", filters.CLEANED
    )
    filter_favourite: filters.of_kinds("favourite", "Favorites", "Show only favorites, or none", filters.YES_NO)
    filter_used: filters.of_kinds("used", "Used", "Show only clips that you have used, or have not", filters.USED)
    filter_broken: filters.of_kinds(
        "broken", "Not Readable", "Show only files that cannot be read, or none", filters.YES_NO
    )
    filter_missing: filters.of_kinds(
        "missing", "Missing", "Show only clips whose file is gone, or none", filters.YES_NO
    )
    active: IntProperty(
        name="Selected Clip",
        get=_get_active,
        set=_set_active,
    )
    rows: CollectionProperty(type=LibraryRow)

    subject: _words("subject", "Subject", "Who was recorded. Empty takes your edit back")
    recorded_on: _words(
        "recorded_on", "Recorded", "The day of the recording, as 2004-05-31. Empty takes your edit back"
    )
    description: _words("description", "Description", "What happens in the clip. Empty takes your edit back")
    session_group: _words("session_group", "Group", "The session or the project of the recording")
    tags: StringProperty(name="Tags", description="Tags, with commas between them", get=_get_tags, set=_set_tags)
    rating: IntProperty(
        name="Rating",
        description="One to five stars; zero is not rated",
        min=0,
        max=5,
        get=_clip_value("rating", 0),
        set=_setter("rating"),
    )
    cleaned: EnumProperty(
        name="Cleaned",
        description="Whether the clip was cleaned",
        items=CLEANED,
        get=_get_cleaned,
        set=_set_cleaned,
    )
    is_favourite: BoolProperty(
        name="Favorite",
        description="Keep this clip among your favorites",
        get=_clip_value("is_favourite", False),
        set=_setter("is_favourite"),
    )
    also_sidecar: BoolProperty(
        name="Also to the Sidecar",
        description="Write what you change here, and usable pieces, to the .i3d file beside the clip too",
        get=_get_also_sidecar,
        set=_set_also_sidecar,
    )


def fill_rows() -> None:
    """Let the list have as many rows as there are clips."""
    manager = bpy.context.window_manager
    if manager is None:
        return
    shown = manager.motion_theater_library.rows
    wanted = min(len(session.state.ids), SHOWN_AT_MOST)
    if wanted < len(shown) // 2:
        shown.clear()
    while len(shown) > wanted:
        shown.remove(len(shown) - 1)
    for _ in range(wanted - len(shown)):
        shown.add()


@bpy.app.handlers.persistent
def _before_save(*_: object) -> None:
    """Save nothing of the list."""
    manager = bpy.context.window_manager
    if manager is not None:
        manager.motion_theater_library.rows.clear()


@bpy.app.handlers.persistent
def _after(*_: object) -> None:
    """Show the list again, after saving or in another file."""
    fill_rows()


HANDLERS = (("save_pre", _before_save), ("save_post", _after), ("load_post", _after))
CLASSES = (LibraryRow, LibraryOptions)


def register_pointers() -> None:
    """Attach the fields to the window manager, and keep the list in step."""
    bpy.types.WindowManager.motion_theater_library = PointerProperty(type=LibraryOptions)
    session.on_change(fill_rows)
    for name, handler in HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister_pointers() -> None:
    """Detach what `register_pointers` attached."""
    for name, handler in HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    session.no_longer_on_change(fill_rows)
    del bpy.types.WindowManager.motion_theater_library
