"""What this session shows of the library: the search, its result, the clip that is selected, and the scan."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import bpy
import numpy as np

import motion_theater

from ..logic.library import facts, views
from ..logic.library.marks import Marks
from ..logic.messages import explained
from . import redraw, work

if TYPE_CHECKING:
    from numpy.typing import NDArray

PACKAGE = __package__.rpartition(".")[0]
DATABASE = "library.sqlite"
VARIABLE = "MOTION_THEATER_LIBRARY"
RETRY_S = 5.0
MOMENT_S = 0.015
MENU_FIELDS = ("format", "tag", "subject", "group")


@dataclass
class Session:
    """The state of the browser. It lasts as long as Blender runs and is never saved."""

    is_open: bool = False
    words: str = ""
    filters: dict[str, str] = field(default_factory=dict)
    sort: str = "name"
    descending: bool = False
    order_before: tuple[str, bool] | None = None
    """The order before the recently used clips were shown, which have their own."""
    ids: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, np.int64))
    """What was found, in order."""
    active: int = -1
    """The place of the selected clip in `ids`, or -1."""
    marks: dict[int, Marks] = field(default_factory=dict)
    """In and out marks of clips that were opened."""
    total: int = 0
    """Clips in the library."""
    folders: list[Any] = field(default_factory=list)
    values: dict[str, list[tuple[str, int]]] = field(default_factory=dict)
    """For menus: the values of a field, with how many clips have them."""
    misunderstood: str = ""
    """Why the search cannot be made as it stands."""
    asked: float = 0.0
    """When the library was last asked from the beginning."""
    trouble: str = ""
    """Why the library itself cannot be used."""
    message: str = ""
    """What was last done."""
    is_alarming: bool = False
    """Whether the message says that something could not be done."""
    about: int | None = None
    """The clip that the message is about."""
    also_sidecar: bool = False

    @property
    def active_id(self) -> int | None:
        """The selected clip."""
        return int(self.ids[self.active]) if 0 <= self.active < len(self.ids) else None


state = Session()
_local = threading.local()
_listeners: list[Callable[[], None]] = []


def path() -> str:
    """Return where the database lies: in the extension's own folder, or where the environment says."""
    named = os.environ.get(VARIABLE)
    if named:
        return named
    try:
        folder = bpy.utils.extension_path_user(PACKAGE, path="library", create=True)
    except ValueError:  # registered by a script, which is no extension
        folder = bpy.utils.user_resource("DATAFILES", path="motion_theater", create=True)
    return str(Path(folder) / DATABASE)


def library() -> motion_theater.Library:
    """Return the library, opened once in each thread: readers do not wait for each other."""
    wanted = path()
    if getattr(_local, "path", None) != wanted:
        _local.library, _local.path = motion_theater.Library(wanted), wanted
    return _local.library


def on_change(listener: Callable[[], None]) -> None:
    """Have a function called whenever another list of clips is shown."""
    if listener not in _listeners:
        _listeners.append(listener)


def no_longer_on_change(listener: Callable[[], None]) -> None:
    """Take that back."""
    if listener in _listeners:
        _listeners.remove(listener)


def ensure_open() -> None:
    """Read what the library holds, unless that was done before; after a failure, try again. Asked at each redraw."""
    is_due = bool(state.trouble) and time.monotonic() - state.asked > RETRY_S
    if not state.is_open or is_due:
        state.is_open, state.asked = True, time.monotonic()
        refresh()


def begin() -> None:
    """Read what the library holds, and let the first redraw have clips to show if that is a matter of a moment."""
    ensure_open()
    if not len(state.ids):
        work.give("data", "search", MOMENT_S)


def refresh() -> None:
    """Look anew what is in the library and what the search finds."""
    search()
    work.ask("data", "overview", _overview, _show_overview)


def search() -> None:
    """Find the clips that are asked for."""
    query = facts.query(state.words, state.filters)
    sort, descending = state.sort, state.descending
    work.ask("data", "search", lambda: library().search(query, sort=sort, descending=descending), _show_found)


def is_searching() -> bool:
    """Return whether what is shown is not yet what was asked for."""
    return work.waits("data", "search")


def set_filter(name: str, value: str) -> None:
    """Filter by a field; nothing takes the filter away."""
    filters = {key: kept for key, kept in state.filters.items() if key != name}
    if value:
        filters[name] = value
    if filters != state.filters:
        state.filters = filters
        search()


def show(view: str) -> None:
    """Show one of the views; recently used clips come with the latest first."""
    if views.of(state.filters) == view:
        return
    state.filters = views.applied(state.filters, view)
    if state.order_before is not None:
        (state.sort, state.descending), state.order_before = state.order_before, None
    if view == "RECENT":
        state.order_before = state.sort, state.descending
        state.sort, state.descending = "used", True
    search()


def say(message: str, *, is_alarming: bool = False, about: int | None = None) -> None:
    """Show in the panel what was done, or why it could not be; an empty message takes that away."""
    state.message, state.is_alarming, state.about = message, is_alarming, about
    redraw.everything()


def choose(index: int) -> None:
    """Select a clip by its place in the list. What was said of another one goes."""
    index = min(max(index, -1), len(state.ids) - 1)
    if index != state.active:
        state.active = index
        say("")


def change(call: Callable[[], Any], said: str = "", *, about: int | None = None) -> None:
    """Write to the library in the background, and show the outcome."""

    def deliver(_: Any, error: BaseException | None) -> None:
        from . import rows

        if error is not None:
            say(_words(error), is_alarming=True, about=about)
        elif said:
            say(said)
        # Also after an error: a part may have been done.
        rows.renew()
        refresh()

    work.ask("edits", object(), call, deliver)


def _overview() -> tuple[int, list[Any], dict[str, list[tuple[str, int]]]]:
    here = library()
    return here.count(), here.folders(), {name: here.values(name) for name in MENU_FIELDS}


def _show_overview(result: Any, error: BaseException | None) -> None:
    if error is not None:
        state.trouble = _words(error)
    else:
        state.trouble = ""
        state.total, state.folders, state.values = result
    redraw.everything()


def _show_found(result: Any, error: BaseException | None) -> None:
    if error is not None:
        state.misunderstood = _words(error)
        redraw.everything()
        return
    state.misunderstood = ""
    chosen = state.active_id
    state.ids = result
    places = [] if chosen is None else np.flatnonzero(result == chosen).tolist()
    state.active = places[0] if places else (0 if len(result) else -1)
    for listener in _listeners:
        listener()
    redraw.everything()


def _words(error: BaseException) -> str:
    said = explained(error)
    if said is None:
        raise error
    return said


def close() -> None:
    """Forget everything, as at the start of Blender."""
    state.__init__()  # type: ignore[misc]
