"""The stack of an armature as a small file, TOML or JSON: the one that `motion-theater combine` takes."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any

import motion_theater

from . import rig, scene, skeletons, sources, stack, tracks
from .logic import names, recipes
from .logic.messages import UserError, base_name, listing, sentences
from .logic.rates import usual

if TYPE_CHECKING:
    from bpy.types import Context, Object, Scene

    from .properties import MotionEntry, MotionStack

Files = list[tuple[str, bytes]]


def export(ob: Object, current: Scene, path: str) -> tuple[Files, list[str]]:
    """Return the stack file of an armature, and a skeleton beside it that is no file yet; with what is to be said."""
    motion = stack.of(ob)
    folder, stem = str(Path(sources.full_path(path)).parent), PurePath(path).stem
    writer = _Writer(ob, folder, stem)
    recipe: dict[str, Any] = {"rate_hz": usual(scene.rate_hz(current))}
    if motion.skeleton_text:
        recipe["skeleton"] = writer.skeleton(motion.skeleton_text, [motion.skeleton_source], stem)
    recipe["entries"] = [writer.entry(entry) for entry in motion.entries if entry.kind != "KEPT"]
    kept = [entry.name for entry in motion.entries if entry.kind == "KEPT"]
    if not any(entry["kind"] == "TRACK" for entry in recipe["entries"]):
        raise UserError(f"“{ob.name}” has no track: a stack file is made of motion files")
    if kept:
        writer.told.append(f"Edits by hand have no place in a stack file: left out {listing(kept)}")
    if motion.base_action is not None:
        writer.told.append(f"The base, “{motion.base_action.name}”, has no place in a stack file")
    text = motion_theater.format_recipe(recipe)
    if path.lower().endswith(".json"):
        plain = motion_theater.parse_recipe(text, name=base_name(path))
        text = json.dumps(plain, indent=2, ensure_ascii=False) + "\n"
    said = f"Exported {base_name(path)}: {_entries(len(recipe['entries']))}"
    return [*writer.files, (path, text.encode())], [said, *writer.told]


class _Writer:
    """Entries of a stack as entries of a file in a folder."""

    def __init__(self, ob: Object, folder: str, stem: str) -> None:
        self._ob, self._folder, self._stem = ob, folder, stem
        self._file_names = _file_names(ob)
        self.files: Files = []
        self.told: list[str] = []

    def entry(self, entry: MotionEntry) -> dict[str, Any]:
        """Return one entry."""
        is_track = entry.kind == "TRACK"
        settings = recipes.TRACK_SETTINGS if is_track else recipes.FILTER_SETTINGS
        made: dict[str, Any] = {"kind": entry.kind, "name": entry.name, "enabled": entry.enabled}
        made |= {name: getattr(entry, name) for name in settings}
        if not entry.all_bones:
            made["bones"] = self._bones(entry)
        if is_track:
            made["rate_hz"] = usual(entry.rate_hz) if entry.rate_hz else 0.0
            made |= self._files_of(entry)
        return made

    def _bones(self, entry: MotionEntry) -> list[str]:
        bones = names.split(entry.bones)
        unknown = [bone for bone in bones if bone not in self._file_names]
        if unknown:
            self.told.append(f"“{entry.name}”: {listing(unknown)} not in the skeleton file: left out")
        return [self._file_names[bone] for bone in bones if bone in self._file_names]

    def _files_of(self, entry: MotionEntry) -> dict[str, str]:
        """Return where motion and skeleton of a track lie."""
        if entry.packed_key:
            raise UserError(f"“{entry.name}” is packed, and a stack file names files: unpack the sources first")
        if not entry.source:
            raise UserError(f"“{entry.name}” has no source: relink it")
        path = sources.absolute(self._ob, entry.source)
        found = {"source": recipes.relative(path, self._folder)}
        text = entry.skeleton_text
        if text and not sources.has_own_skeleton(sources.read_file(path)):
            found["skeleton"] = self.skeleton(text, _skeletons_beside(path), f"{self._stem} {entry.name}")
        return found

    def skeleton(self, text: str, candidates: Iterable[str], stem: str) -> str:
        """Return where a skeleton lies: in one of these files, or in a new one."""
        for candidate in candidates:
            path = sources.absolute(self._ob, candidate)
            try:
                if path and sources.text_of(sources.read_file(path)) == text:
                    return recipes.relative(path, self._folder)
            except UserError:
                continue
        kind = "bvh" if text.lstrip().upper().startswith("HIERARCHY") else "asf"
        name = f"{stem} skeleton.{kind}"
        path, data = str(Path(self._folder) / name), text.encode("latin-1")
        if Path(path).is_file() and Path(path).read_bytes() != data:
            raise UserError(f"{name} is there already with another skeleton: choose another folder")
        if (path, data) not in self.files:
            self.files.append((path, data))
            self.told.append(f"Wrote the skeleton beside it, as {name}")
        return name


def _skeletons_beside(path: str) -> list[str]:
    try:
        return [sources.find_skeleton(path, sources.read_file(path), may_guess=False).skeleton.clip.path]
    except UserError:
        return []


def _file_names(ob: Object) -> dict[str, str]:
    """Return for each bone its name in the skeleton on which the stack's result moves."""
    motion = stack.of(ob)
    skeleton = _result_skeleton(ob, motion)
    bones = ob.data.bones.keys()
    matched = sources.matched_bones(motion, skeleton, bones) if skeleton is not None else {bone: bone for bone in bones}
    return {bone: name for name, bone in matched.items()}


def _result_skeleton(ob: Object, motion: MotionStack) -> motion_theater.Skeleton | None:
    if motion.skeleton_text:
        return sources.skeleton_from_text(motion.skeleton_text)
    for entry in motion.entries:
        if entry.kind == "TRACK" and entry.enabled:
            return sources.skeleton_of(ob, entry, sources.load(ob, entry))[0]
    return None


def take(context: Context, ob: Object | None, path: str, *, instead: bool, set_rate: bool) -> str:
    """Put the entries of a stack file on an armature; return the message. Run inside `scene.unchanged_on_error`.

    Without an armature, the skeleton that the file names is imported.
    """
    recipe = _read(path)
    folder = Path(sources.full_path(path)).parent
    entries = recipe.get("entries", [])
    if not entries:
        raise UserError(f"{base_name(path)} has no entries")
    skeleton = str(folder / recipe["skeleton"]) if recipe.get("skeleton") else ""
    told: list[str] = []
    if ob is None:
        ob, told = _imported(context, skeleton, folder, entries)
    reason = rig.writable_reason(ob)
    if reason:
        raise UserError(reason)
    rate_hz, scene_hz = float(recipe.get("rate_hz") or 0.0), scene.rate_hz(context.scene)
    if rate_hz and abs(usual(rate_hz) - usual(scene_hz)) > 1e-6 * scene_hz:
        if set_rate:
            scene.set_rate(context.scene, rate_hz)
        else:
            told.append(f"The stack was made for {rate_hz:.6g} frames per second, the scene has {scene_hz:.6g}")
    settings = [
        _settings(ob, entry, recipes.label(entry, number), folder, skeleton) for number, entry in enumerate(entries, 1)
    ]
    notices = stack.add_entries(ob, settings, instead=instead)
    tracks.apply_range(context, ob, "EXTEND")
    message = sentences([f"Took {_entries(len(entries))} from {base_name(path)}", *told, *notices])
    stack.of(ob).message = message
    return message


def _read(path: str) -> dict[str, Any]:
    name = base_name(path)
    try:
        text = Path(path).read_text("utf-8")
    except UnicodeDecodeError as error:
        raise UserError(f"{name}: a stack file is UTF-8 text, and this is none") from error
    return motion_theater.parse_recipe(text, name=name)


def _imported(context: Context, skeleton: str, folder: Path, entries: list[dict[str, Any]]) -> tuple[Object, list[str]]:
    """Import the skeleton of a stack file, or else that of its first track."""
    if not skeleton:
        first = next((entry for entry in entries if entry.get("source") and entry.get("enabled", True)), None)
        if first is None:
            raise UserError("The file names no skeleton: select an armature first")
        path = str(folder / first["source"])
        own = str(folder / first["skeleton"]) if first.get("skeleton") else ""
        pairing = tracks.pairing_of(sources.read_file(path), tracks.Request(path, skeleton=own), may_guess=True)
        return skeletons.import_skeleton(context, pairing.skeleton)
    return skeletons.import_skeleton(context, sources.read_file(os.path.normpath(skeleton)))


def _settings(ob: Object, entry: Mapping[str, Any], label: str, folder: Path, skeleton: str) -> dict[str, object]:
    """Return the settings of one entry as the armature's stack has them."""
    kind, is_enabled = entry.get("kind", "TRACK"), bool(entry.get("enabled", True))
    made: dict[str, object] = {"kind": kind, "enabled": is_enabled, **recipes.settings(entry, label)}
    made["name"] = entry.get("name") or (PurePath(str(entry.get("source", ""))).stem or "Filter")
    if "bones" in entry:
        made |= {"all_bones": False, "bones": names.join(_bones(ob, entry["bones"], label))}
    if kind != "TRACK":
        return made
    if not entry.get("source"):
        raise UserError(f"{label}: there is no source")
    path = os.path.normpath(folder / entry["source"])
    made["source"] = path
    own = os.path.normpath(folder / entry["skeleton"]) if entry.get("skeleton") else ""
    try:
        made["skeleton_text"] = _skeleton_text(ob, path, own, skeleton)
    except UserError as error:
        if is_enabled:
            raise UserError(f"{label}: {error}") from error
    return made


def _skeleton_text(ob: Object, path: str, own: str, of_stack: str) -> str:
    """Return the skeleton text that a track needs for itself: its own, the armature's, or that of the file."""
    loaded = sources.read_file(path)
    tracks.check_is_motion(loaded)
    try:
        return tracks.fitted(ob, loaded, tracks.Request(path, skeleton=own))[0]
    except UserError:
        if own or not of_stack:
            raise
        return tracks.fitted(ob, loaded, tracks.Request(path, skeleton=of_stack))[0]


def _bones(ob: Object, wanted: list[str], label: str) -> list[str]:
    matched = names.match(wanted, ob.data.bones.keys(), names.decode_pairs(stack.of(ob).bone_names))
    missing = [name for name in wanted if name not in matched]
    if missing:
        raise UserError(f"{label}: “{ob.name}” has no bone {listing(missing)}")
    return [matched[name] for name in wanted]


def _entries(count: int) -> str:
    return "1 entry" if count == 1 else f"{count} entries"
