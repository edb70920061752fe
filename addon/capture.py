"""Importing files of any kind, one or many: what each becomes in the scene, and what became of it."""

from __future__ import annotations

import traceback
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import motion_theater

from . import markers, scene, skeletons, sources, stack, tracks
from .logic import batch
from .logic.messages import base_name, explained, sentences

if TYPE_CHECKING:
    from bpy.types import Context, Object

    from .logic.ranges import Choice


@dataclass(frozen=True)
class Options:
    """How files are imported; the names are those of the operator."""

    target: str = "AUTO"
    scale: float = 1.0
    up: str = "AUTO"
    forward: str = "FILE"
    bone_style: str = "POINT"
    rate: str = "RESAMPLE"
    rate_hz: float = 0.0
    scene_range: Choice = "EXTEND"
    with_lines: bool = False
    with_events: bool = False
    with_analog: bool = False

    @property
    def of_skeleton(self) -> dict[str, object]:
        """The part that `skeletons.import_skeleton` takes."""
        return {name: getattr(self, name) for name in ("scale", "up", "forward", "bone_style")}

    @property
    def of_markers(self) -> dict[str, Any]:
        """The part that `markers.import_markers` takes."""
        others = ("target", "bone_style")
        return {name: getattr(self, name) for name in self.__dataclass_fields__ if name not in others}


@dataclass
class Batch:
    """Files on their way into the scene, one at a time. A file that fails leaves nothing and stops nothing."""

    paths: Sequence[str]
    options: Options
    active: Object | None
    """The armature that motion may be added to."""
    verdicts: batch.Verdicts = field(default_factory=lambda: batch.Verdicts([], []))

    def __post_init__(self) -> None:
        self._jobs = batch.plan(self.paths, _format_of)
        self._count = len(self._jobs)
        self._brought: dict[str, str] = {}

    @property
    def count(self) -> int:
        """How many files there are."""
        return self._count

    @property
    def left(self) -> int:
        """How many files are still to come."""
        return len(self._jobs)

    @property
    def next_name(self) -> str:
        """The name of the file that comes next."""
        return base_name(self._jobs[0].path) if self._jobs else ""

    def step(self, context: Context) -> None:
        """Import the next file."""
        job = self._jobs.pop(0)
        try:
            if job.path in self._brought:
                self.verdicts.done.append(batch.used_by(job.path, self._brought[job.path]))
                return
            with scene.unchanged_on_error(context):
                message = self._imported(context, job)
            self.verdicts.done.append(message)
        except BaseException as error:
            text = explained(error)
            if text is None:
                if not isinstance(error, Exception):
                    raise
                traceback.print_exc()  # a mistake of our own must not cost the other files
                text = f"an error of Motion Theater itself, please report it: {error!r}"
            name = base_name(job.path)
            text = text.replace(job.path, name)  # one line of many: the folder is known
            self.verdicts.skipped.append(text if name in text else f"{name}: {text}")

    def stop(self) -> None:
        """Leave the rest of the files."""
        self.verdicts.not_begun, self._jobs = len(self._jobs), []

    def _imported(self, context: Context, job: batch.Job) -> str:
        if job.format in tracks.MARKER_FORMATS:
            return self._markers(context, job)
        loaded = sources.read_file(job.path)
        if loaded.clip.skeleton is not None and not loaded.clip.frames:
            ob, told = skeletons.import_skeleton(context, loaded, **self.options.of_skeleton)  # type: ignore[arg-type]
            message = sentences(told)
            stack.of(ob).message = message
            return message
        request = tracks.Request(
            path=job.path,
            rate=self.options.rate,
            scene_range=self.options.scene_range,
            import_options=self.options.of_skeleton,
            skeleton_candidates=job.skeletons,
            settings={"rate_hz": self.options.rate_hz},
        )
        message = tracks.add_track(context, self._target(loaded), request)
        if self.options.rate == "SCENE" and self.count > 1:
            # A scene has one rate: the first motion sets it, and the others are resampled to it.
            self.options = replace(self.options, rate="RESAMPLE")
        skeleton = stack.of(context.view_layer.objects.active).skeleton_source if job.skeletons else ""
        for path in job.skeletons:
            if sources.full_path(path) == skeleton:
                self._brought[path] = job.path
        return message

    def _target(self, loaded: sources.Loaded) -> Object | None:
        """Return the armature to which a motion is added where it fits; None for a new one."""
        if self.options.target == "ACTIVE":
            return self.active
        is_alone = self.count == 1 and not sources.has_own_skeleton(loaded)
        return self.active if self.options.target == "AUTO" and is_alone else None

    def _markers(self, context: Context, job: batch.Job) -> str:
        clip = sources.read_file(job.path).clip
        return markers.import_markers(context, clip, **self.options.of_markers)


def _format_of(path: str) -> str:
    """Return what the content of a file says; nothing where it cannot be read, which is said when its turn comes."""
    try:
        return motion_theater.format_of(path) or ""
    except (OSError, ValueError):
        return ""
