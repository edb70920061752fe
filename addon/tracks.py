"""Adding a motion file to an armature: which armature, which skeleton, which bones, which rate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from . import rig, scene, skeletons, sources, stack
from .logic import axes, names
from .logic.extent import ASSUMED_RATE_HZ
from .logic.messages import (
    NO_BONES_SELECTED,
    UserError,
    base_name,
    misfit,
    sentences,
    track_added,
)

if TYPE_CHECKING:
    from bpy.types import Context, Object

    from .logic.ranges import Choice

MARKER_FORMATS = frozenset({"c3d", "csm", "trc"})


@dataclass(frozen=True)
class Request:
    """What the user asked for."""

    path: str
    skeleton: str = ""
    """The skeleton file; empty: that of the armature, or the one that is found."""
    selected_only: bool = False
    bone_collection: str = ""
    rate: str = "RESAMPLE"
    scene_range: Choice = "EXTEND"
    import_options: Mapping[str, object] = field(default_factory=dict)
    """How a skeleton is imported where one is: arguments of `skeletons.import_skeleton`."""
    skeleton_candidates: tuple[str, ...] = ()
    """Skeleton files that came together with the motion."""
    settings: Mapping[str, object] = field(default_factory=dict)
    """Settings of the entry, by the names of its properties."""


def chosen_bones(ob: Object | None, *, selected_only: bool, bone_collection: str = "") -> list[str] | None:
    """Return the bones that the user means, None for all. Selected bones go before a collection."""
    if not selected_only and not bone_collection:
        return None
    if selected_only:
        found = rig.selected_bones(ob) if ob is not None else []
        if not found:
            raise UserError(NO_BONES_SELECTED)
        return found
    found = rig.bones_of_collection(ob, bone_collection) if ob is not None else []
    if not found:
        raise UserError(f"The armature has no bones in a collection “{bone_collection}”")
    return found


def add_track(context: Context, ob: Object | None, request: Request) -> str:
    """Add a motion file as a track; return the message for the user. Run inside `scene.unchanged_on_error`."""
    loaded = sources.read_file(request.path)
    check_is_motion(loaded)
    bones = chosen_bones(ob, selected_only=request.selected_only, bone_collection=request.bone_collection)
    ob, skeleton_text, told = _armature_for(context, ob, loaded, request, may_import=bones is None)
    rate_hz = _rate_of(loaded, request)
    if request.rate == "SCENE":
        scene.set_rate(context.scene, rate_hz)
    entry = stack.add_entry(
        ob,
        "TRACK",
        name=PurePath(base_name(request.path)).stem,
        source=sources.full_path(request.path),
        skeleton_text=skeleton_text,
        all_bones=bones is None,
        bones=names.join(bones or ()),
        keys="SAMPLES" if request.rate == "SAMPLES" else "FRAMES",
        **request.settings,
    )
    apply_range(context, ob, request.scene_range)
    count = len(ob.data.bones) if bones is None else len(bones)
    added = track_added(request.path, count, entry.result_start, entry.result_end)
    message = sentences(dict.fromkeys([*told, added, *loaded.clip.notices, *names.split(entry.notices)]))
    stack.of(ob).message = message
    return message


def check_is_motion(loaded: sources.Loaded) -> None:
    """Refuse a file without a motion of bones."""
    name = base_name(loaded.clip.path)
    if loaded.clip.format in MARKER_FORMATS:
        raise UserError(f"{name} holds markers, not the motion of bones: import it as it is")
    if not loaded.clip.frames:
        raise UserError(f"{name} holds no motion: choose an .amc or .bvh file")


def apply_range(context: Context, ob: Object, choice: Choice) -> None:
    """Let the frame range of the scene meet that of an armature's tracks."""
    tracks = [track for track in stack.of(ob).entries if track.kind == "TRACK" and track.enabled]
    if tracks:
        start, end = min(track.result_start for track in tracks), max(track.result_end for track in tracks)
        scene.apply_range(context.scene, choice, start, end)


def _rate_of(loaded: sources.Loaded, request: Request) -> float:
    asked = request.settings.get("rate_hz")
    return (asked if isinstance(asked, float) and asked else loaded.clip.rate_hz) or ASSUMED_RATE_HZ


def _armature_for(
    context: Context, ob: Object | None, loaded: sources.Loaded, request: Request, *, may_import: bool
) -> tuple[Object, str, list[str]]:
    """Return the armature for a motion, the skeleton text that its track needs for itself, and what was done for it.

    The given armature is taken if the motion fits it. Else, if all bones are meant, the motion's own skeleton is
    imported.
    """
    if ob is not None:
        reason = rig.writable_reason(ob)
        if reason:
            raise UserError(reason)
        try:
            return ob, *fitted(ob, loaded, request)
        except UserError:
            if not may_import:
                raise
            misfitting = ob
            try:
                pairing = pairing_of(loaded, request, may_guess=False)
            except UserError:
                pairing = None
            if pairing is None or _same_bones(misfitting, pairing.skeleton):
                raise
    else:
        pairing = pairing_of(loaded, request, may_guess=True)
    options: dict[str, Any] = dict(request.import_options)
    ob, told = skeletons.import_skeleton(context, pairing.skeleton, **options)
    return ob, "", [pairing.told, *told]


def pairing_of(loaded: sources.Loaded, request: Request, *, may_guess: bool) -> sources.Pairing:
    """Return the skeleton of a motion; nothing is said where it is the file's own, or the user named it."""
    if sources.has_own_skeleton(loaded):
        return sources.Pairing(loaded)
    if request.skeleton:
        named = sources.read_file(request.skeleton)
        sources.bind(loaded, sources.text_of(named))
        return sources.Pairing(named)
    return sources.find_skeleton(request.path, loaded, request.skeleton_candidates, may_guess=may_guess)


def _same_bones(ob: Object, skeleton: sources.Loaded) -> bool:
    """Return whether an armature has all bones of a skeleton file, so that importing it would not help."""
    file = sources.as_skeleton(skeleton)
    return len(sources.matched_bones(stack.of(ob), file, ob.data.bones.keys())) == len(file.names)


def fitted(ob: Object, loaded: sources.Loaded, request: Request) -> tuple[str, list[str]]:
    """Return the skeleton text that a track on this armature needs for itself, and what is to be said about it."""
    motion = stack.of(ob)
    told: list[str] = []
    own = motion.skeleton_text
    if request.skeleton or not own or sources.has_own_skeleton(loaded):
        pairing = pairing_of(loaded, request, may_guess=True)
        text = sources.text_of(pairing.skeleton)
        told += [pairing.told] if pairing.told else []
    else:
        text = own
    skeleton = sources.skeleton_from_text(text)
    sources.bind(loaded, text)
    missing = sources.missing_bones(loaded, sources.matched_bones(motion, skeleton, ob.data.bones.keys()))
    if missing:
        raise UserError(misfit(loaded.clip.path, missing, ob.name))
    if text == own:
        return "", told
    if not own:
        told.append(f"The armature is taken to be {axes.nearest_axis(skeleton.up)} up in the file and Z up in Blender")
    return text, told
