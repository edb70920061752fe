"""Motion capture: read it, combine it, filter it.

Arrays are C-contiguous float64 unless said otherwise. Quaternions are (w, x, y, z). Angles are radians.
Euler orders are Blender's: "XYZ" turns about X first, then Y, then Z, about fixed axes.
"""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any, Literal, final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "DEFAULT_SKELETON_ASF",
    "DEFAULT_SKELETON_NOTICE",
    "SIDECAR_LABELS",
    "AnalogChannel",
    "Answer",
    "BaseChannel",
    "Clip",
    "Evaluation",
    "Event",
    "Figure",
    "Filter",
    "Inference",
    "Library",
    "LibraryClip",
    "LibraryError",
    "LibraryFolder",
    "Markers",
    "MisfitError",
    "Motion",
    "MotionTheaterError",
    "Notice",
    "ParameterError",
    "ParseError",
    "Preview",
    "ResultChannel",
    "Rig",
    "Scan",
    "ScanProgress",
    "Sidecar",
    "Skeleton",
    "SkeletonCandidate",
    "Track",
    "__version__",
    "default_skeleton",
    "digest",
    "evaluate",
    "filter_rotations",
    "filter_values",
    "format_of",
    "format_recipe",
    "infer",
    "load_figure",
    "main",
    "parse_recipe",
    "read",
    "read_bytes",
    "read_sidecar",
    "sidecar_cleaned",
    "sidecar_for",
    "skeletons_for",
    "to_acclaim",
    "to_bvh",
]

__version__: str

Floats = NDArray[np.float64]

class MotionTheaterError(Exception):
    """The root of every error of this module but those of the operating system (`OSError`)."""

class ParseError(MotionTheaterError, ValueError):
    """A file is wrong. The text names file, line (or byte), what was expected and what was found."""

    path: str
    line: int | None
    column: int | None
    byte: int | None
    expected: str
    found: str

class MisfitError(MotionTheaterError, ValueError):
    """A motion and a skeleton do not belong together."""

    bones: list[str]

class ParameterError(MotionTheaterError, ValueError):
    """A number or combination that was asked for makes no sense."""

class LibraryError(MotionTheaterError):
    """A library cannot be opened, read or written; the text says why, and what to do."""

@final
class Skeleton:
    """Names, hierarchy and rest pose, in the file's own axes and units. Parents come before children."""

    name: str
    names: list[str]
    parents: list[int]
    """-1 for a root."""
    heads: Floats
    """(bones, 3) where each bone starts in the rest pose."""
    tails: Floats
    """(bones, 3) where each bone ends in the rest pose; equal to its head for a point."""
    axes: Floats
    """(bones, 4) the bone's own rotation axes in the rest pose: bone axes to file axes."""
    orders: list[str]
    """Euler order of each bone: "XYZ" and so on."""
    dofs: list[list[str]]
    """Per bone its degrees of freedom in file order: "tx", "ty", "tz", "rx", "ry", "rz", "l"."""
    limits: list[list[tuple[float, float]]]
    """Per bone one pair per degree of freedom, or nothing; radians for rotations."""
    up: tuple[float, float, float]
    unit_m: float
    """Metres per file unit."""
    unit_reason: str
    unit_is_certain: bool
    height: float
    """Extent of the rest pose along `up`, in file units."""

    def __new__(
        cls,
        names: Sequence[str],
        *,
        parents: Sequence[int],
        heads: Floats,
        tails: Floats,
        axes: Floats | None = None,
        orders: Sequence[str] | None = None,
        dofs: Sequence[Sequence[str]] | None = None,
        up: tuple[float, float, float] = ...,
        unit_m: float = 0.01,
        name: str = ...,
    ) -> Skeleton:
        """A skeleton of one's own. Arrays are as in the attributes of these names; `axes` are the file's where they are
        not given, `orders` "XYZ"."""

@final
class Motion:
    """Channels over frames, for the bones of one skeleton or of one host armature."""

    names: list[str]
    first_frame: int
    """The file's own number of the first frame."""
    frames: int
    rate_hz: float | None

    def __new__(
        cls,
        skeleton: Skeleton,
        *,
        frames: int,
        rotations: Sequence[Floats | None],
        translations: Sequence[Floats | None],
        first_frame: int = 1,
        rate_hz: float | None = None,
    ) -> Motion:
        """A motion of one's own, in the file's axes: by bone (frames, 4) rotations relative to the rest pose and
        (frames, 3) translations of its start, both in the axes of the parent's global rotation; None where the bone
        has none."""

    def has_rotation(self, bone: int) -> bool: ...
    def has_translation(self, bone: int) -> bool: ...
    def rotations(self, bone: int) -> Floats:
        """(frames, 4) relative to the rest pose, or (0, 4) where the bone has none."""
    def angles(self, bone: int) -> Floats:
        """(frames, 3) the file's own Euler angles, indexed x, y, z; or (0, 3)."""
    def translations(self, bone: int) -> Floats:
        """(frames, 3) of the bone's start away from its rest position; or (0, 3)."""
    def pose(self, skeleton: Skeleton, frame: float) -> tuple[Floats, Floats, Floats]:
        """Heads (bones, 3), tails (bones, 3) and global rotations (bones, 4) at a real-valued file frame."""
    def resampled(self, rate_hz: float) -> Motion:
        """The same motion at another rate, low-passed first when going down; it lasts as long, to half a frame."""
    def in_rest_axes(
        self, names: Sequence[str | None], axes: Floats, scale: float, *, orders: Sequence[str | None] | None = None
    ) -> Motion:
        """The motion as channels of a host's bones.

        `names[i]` is this motion's bone for host bone i (None: no data), `axes` (host bones, 4) the rotation from
        this motion's axes into the host bone's rest axes, `scale` host length units per file unit. `orders[i]` asks
        for Euler angles of that order for bone i: the file's own numbers where the axes agree.
        """

@final
class Event:
    """Something that happened at a moment."""

    label: str
    context: str
    """Which side or kind: "Left"; possibly empty."""
    subject: str
    time_s: float
    """0 is the file's frame 1."""
    frame: float | None
    """The file's own number, not always whole; None where the file has no rate."""

@final
class AnalogChannel:
    """One signal that was recorded beside the markers."""

    name: str
    description: str
    unit: str
    rate_hz: float | None
    """As the file says; samples lie `analog_samples_per_frame` to a frame, whatever the rate."""
    samples: Floats
    """(samples,) in the channel's unit; a new array each time."""

@final
class Markers:
    """Named points over frames, in the file's own axes and units."""

    def __new__(
        cls,
        names: Sequence[str],
        positions: Floats,
        *,
        rate_hz: float | None = None,
        first_frame: int = 1,
        unit_m: float = 1.0,
        up: tuple[float, float, float] = ...,
        events: Sequence[tuple[str, float] | tuple[str, float, str, str]] = ...,
    ) -> Markers:
        """`positions` is (markers, frames, 3), NaN in gaps; `events` are labels with their time in seconds, 0 being
        frame 1, and where there are such with context and subject."""
    names: list[str]
    """In file order; they may be empty, or the same twice."""
    kinds: list[Literal["POSITION", "ANGLE", "FORCE", "MOMENT", "POWER", "SCALAR"]]
    """Laboratories store computed values beside markers, as three numbers each."""
    frames: int
    first_frame: int
    rate_hz: float | None
    unit_m: float
    """Metres per file unit."""
    unit_reason: str
    unit_is_certain: bool
    up: tuple[float, float, float]
    up_reason: str
    up_is_certain: bool
    positions: NDArray[np.float32] | Floats
    """(markers, frames, 3), NaN in gaps; float32 from C3D, float64 else. A new array each time."""
    valid: NDArray[np.bool_]
    """(markers, frames)."""
    residuals: NDArray[np.float32]
    """(markers, frames) in file units, 0 where not measured, -1 in gaps; (0, 0) where the format has none."""
    cameras: NDArray[np.uint8]
    """(markers, frames) which of the first seven cameras saw the marker, a bit each; (0, 0) where there are none."""
    events: list[Event]
    analog: list[AnalogChannel]
    analog_samples_per_frame: int

    def facing(self) -> Answer:
        """The axis towards which the figure looks, in file axes: most of the time, or on the first frame where it turns."""
    def gaps(self) -> list[tuple[int, int, int]]:
        """Marker, first frame and frame after the last, counted from 0, of every gap between two samples."""
    def filled(
        self, *, how: Literal["LINEAR", "CUBIC", "RIGID"], longest: int, markers: Sequence[str] | None = None
    ) -> tuple[Markers, list[tuple[int, int, int]]]:
        """The markers with their gaps of up to `longest` frames filled, and which were. "RIGID" leaves gaps in which
        fewer than three neighbours that keep their distance were seen."""
    def filtered(self, *, kind: FilterKind, depth: int, markers: Sequence[str] | None = None) -> Markers:
        """The markers filtered; no window reaches over a gap, and gaps stay."""
    def resampled(self, rate_hz: float) -> Markers:
        """The same movement at another rate, low-passed first when going down; gaps stay. Frame 1 stays the moment that
        events count from, so `first_frame` changes; residuals and analog signals are left out."""
    def with_analog(self, channels: Sequence[tuple[str, str, str, Floats]], samples_per_frame: int) -> Markers:
        """The markers with these signals instead of their own: name, description, unit and (frames *
        samples_per_frame,) samples each, kept as float32."""
    def neighbours(self) -> list[tuple[int, int]]:
        """Pairs of markers near each other whose distance stays nearly constant."""
    def to_bytes(
        self,
        extension: Literal["c3d", "csm", "trc"],
        *,
        processor: Literal["INTEL", "DEC", "MIPS"] = "INTEL",
        storage: Literal["INTEGER", "FLOAT"] = "FLOAT",
    ) -> bytes:
        """A new file. A CSM is in millimetres and Z up; `processor` and `storage` are for C3D."""

@final
class Clip:
    """What one file holds."""

    path: str
    format: Literal["asf", "amc", "bvh", "c3d", "csm", "trc"]
    notices: list[str]
    """What is odd in the file, and what was inferred."""
    names: list[str]
    """Bones or markers in file order."""
    frames: int
    """0 for a file without motion."""
    first_frame: int
    rate_hz: float | None
    skeleton: Skeleton | None
    motion: Motion | None
    """None for an AMC that was read without a skeleton: see `bind`."""
    skeleton_hint: str | None
    """The skeleton file that an AMC names in its comments; unreliable."""

    markers: Markers | None
    """Those of a C3D are named, and their unit and up axis worked out, when they or `notices` are first asked for."""

    parameters: dict[str, list[float] | list[str]]
    """Of a C3D, by "GROUP:NAME", flat; force plates and all others. Of two with one name, the first."""

    def bind(self, skeleton: Skeleton) -> Motion:
        """The motion of an AMC on its skeleton. Raises MisfitError with the names of the bones that do not fit."""
    def to_bytes(
        self,
        *,
        processor: Literal["INTEL", "DEC", "MIPS"] | None = None,
        storage: Literal["INTEGER", "FLOAT"] | None = None,
    ) -> bytes:
        """The file written anew: the same values, names and order. A C3D can be asked for in another encoding, with
        every parameter; without, it comes back byte for byte."""
    def skeleton_to_bytes(self) -> bytes:
        """The skeleton alone, as a file that gives the same one: an ASF, or a BVH without motion. Empty without one."""

def read(path: str | PathLike[str], *, skeleton: Skeleton | None = None) -> Clip:
    """Read any supported file. Raises ParseError, MisfitError or OSError."""

def read_bytes(data: bytes, *, name: str, skeleton: Skeleton | None = None) -> Clip:
    """Read a file that is already in memory; `name` stands for its path in messages and gives its extension."""

def format_of(path: str | PathLike[str]) -> str | None:
    """The format of a file by how it begins, or else by its extension; None for what has no reader. Raises OSError."""

@final
class Figure:
    """A clip as points and lines over frames, in metres, Z up, at the place where the file has it.

    Of a skeleton the points are its joints and the ends of its last bones, the lines its bones; of markers the points
    are those that are positions, the lines join neighbours that keep their distance, and groups of these. Arrays are
    made anew on every access."""

    names: list[str]
    """One per point."""
    points: NDArray[np.float32]
    """(frames, points, 3); NaN where a point is not seen."""
    lines: NDArray[np.int32]
    """(lines, 2) which points each line joins."""
    sides: NDArray[np.int8]
    """(lines,) -1 for the figure's own left, 1 for its right, 0 for the middle and where it is not known."""
    frames: int
    """How many frames there are here."""
    step: int
    """Every so many frames of the file one is here."""
    first_frame: int
    """The file's own number of the first frame."""
    rate_hz: float
    """Of the frames that are here; assumed where the file does not say."""
    bounds: NDArray[np.float32]
    """(2, 3) the lowest and the highest coordinates over all frames; zeros where nothing is ever seen."""
    floor: float
    """The height of the floor that the figure stands on: 0, or where the file has its origin elsewhere, as low as the
    figure comes."""

    def segments(self, frame: float) -> NDArray[np.float32]:
        """(lines * 2, 3) the ends of all lines, one line after the other, at a frame counted from 0; before the first
        and after the last frame these hold. Between frames points go straight, which is meant for the eye. A line in a
        gap has no length."""

    def dots(self, frame: float) -> NDArray[np.float32]:
        """(points that are seen, 3) at a frame, as in `segments`."""

    def colors(
        self,
        *,
        left: tuple[float, float, float, float],
        middle: tuple[float, float, float, float],
        right: tuple[float, float, float, float],
    ) -> NDArray[np.float32]:
        """(lines * 2, 4) a colour for each end of each line, in the order of `segments`."""

def load_figure(path: str | PathLike[str], *, skeleton: Skeleton | None = None, longest: int | None = None) -> Figure:
    """Read any supported file as a figure. `skeleton` is that of an AMC; without one the first that fits of
    `skeletons_for` is taken, or the default one. Where there are more frames than `longest`, every second, third, ...
    is taken, so that the figure moves at its speed. Raises `ParseError`, `MisfitError` or `OSError`."""

@final
class SkeletonCandidate:
    """A skeleton file that may belong to a motion, and why."""

    path: str
    reason: str
    """The end of "Took 02.asf, because ...": "it is of the same subject, 02"."""

def skeletons_for(
    path: str | PathLike[str],
    *,
    chosen: Sequence[str | PathLike[str]] = (),
    others: Sequence[str | PathLike[str]] = (),
) -> list[SkeletonCandidate]:
    """The skeleton files that may belong to a motion file, best first: those chosen together with it, the one
    that its sidecar names, those of its folder and of the folder above, all others that are known.

    The motion is only looked at for what it says of its skeleton, and no skeleton is opened: the first that fits is
    meant (`Clip.bind`). Raises OSError."""

def default_skeleton() -> Skeleton:
    """The skeleton that stands in for one that is not to be found: the usual Acclaim human, root and 30 bones."""

DEFAULT_SKELETON_ASF: str
"""The same as an ASF file."""
DEFAULT_SKELETON_NOTICE: str
"""What the user is told where it is used."""

@final
class Answer:
    """A value that was worked out."""

    value: Any
    """The likeliest one where it is not certain: a float, a direction (x, y, z), or None."""
    reason: str
    is_certain: bool

@final
class Inference:
    """What a skeleton and its motion do not say of themselves."""

    unit_m: Answer
    """Metres per file unit."""
    up: Answer
    """The axis that points up, in file axes."""
    facing: Answer
    """The axis towards which the figure looks."""
    rate_hz: Answer

def infer(skeleton: Skeleton, motion: Motion | None = None) -> Inference:
    """Work out unit, up axis, facing and rate; `motion` is in the file's axes."""

def to_bvh(skeleton: Skeleton, motion: Motion) -> bytes:
    """A BVH file. A rotation has the channels of its bone, or all three where these are not enough."""

def to_acclaim(skeleton: Skeleton, motion: Motion) -> tuple[bytes, bytes]:
    """An ASF and an AMC file that belong together. Bones get the degrees of freedom that the motion needs."""

FilterKind = Literal["MEDIAN", "AVERAGE", "WEIGHTED"]

def filter_values(values: Floats, *, kind: FilterKind, depth: int) -> Floats:
    """Filter (channels, frames) along the last axis. Near the ends the window shrinks so that it stays centred."""

def filter_rotations(values: Floats, *, kind: FilterKind, depth: int) -> Floats:
    """Filter (bones, frames, 4) quaternions as rotations."""

@final
class Rig:
    """The armature a stack is evaluated for: bones in the host's order and its rest pose in armature space."""

    def __new__(
        cls,
        names: Sequence[str],
        *,
        rest_rotations: Floats,
        rest_heads: Floats,
        parents: Sequence[int],
        modes: Sequence[str],
        up: tuple[float, float, float],
        rate_hz: float,
        file_axes: Floats | None = None,
        file_orders: Sequence[str] | None = None,
    ) -> Rig:
        """`modes[i]` is "QUATERNION" or an Euler order; `rate_hz` the scene's. `file_axes` (bones, 4), from the file's
        bone axes to the host bone's rest axes, and `file_orders`: the angles in which "Linear (Euler)" blends on
        quaternion bones."""

@final
class Track:
    """A clip on some bones, with its cut, scale and blend. Frames that are None are not set."""

    def __new__(
        cls,
        motion: Motion,
        *,
        label: str = ...,
        bones: Sequence[int] | None = None,
        cut_start: int | None = None,
        cut_end: int | None = None,
        scale_start: int | None = None,
        scale_end: int | None = None,
        blend_depth: int | None = None,
        preserve: bool = False,
        preserve_rotation: Literal["HEADING", "FULL"] = "HEADING",
        preserve_height: bool = False,
        discard: bool = False,
        blend: Literal["SLERP", "EULER"] = "SLERP",
        sampling: Literal["LINEAR", "SMOOTH"] = "LINEAR",
        keys: Literal["FRAMES", "SAMPLES"] = "FRAMES",
        rate_hz: float | None = None,
    ) -> Track:
        """`motion` comes from `Motion.in_rest_axes` for the same bones as the rig. `bones` None: all.
        `keys`: on whole scene frames, or one per sample of the file on sub-frames. `rate_hz`: where the file's own
        is missing or wrong."""

@final
class Filter:
    """A filter on some bones."""

    def __new__(
        cls,
        *,
        kind: FilterKind,
        depth: int,
        label: str = ...,
        bones: Sequence[int] | None = None,
        channels: Literal["ROTATION", "CHANNELS"] = "ROTATION",
    ) -> Filter: ...

@final
class BaseChannel:
    """What one channel of one bone held before the first entry: "rotation_quaternion", "rotation_euler" or "location".

    `frames` ascend; `values` is (frames, 4) or (frames, 3). Where the host's keys are sparse, give what is seen on
    every whole frame between them too and mark in `is_key` where a key really stands: the result then replaces as much
    of the curve as is needed for its shape outside the tracks to stay what it was.
    """

    def __new__(
        cls,
        bone: int,
        channel: str,
        frames: Floats,
        values: Floats,
        is_key: NDArray[np.bool_] | None = None,
    ) -> BaseChannel: ...

@final
class ResultChannel:
    """What one channel of one bone became. Outside `start`..`end` the base's own keys stay as they are."""

    bone: int
    channel: str
    """ "rotation_quaternion", "rotation_euler" or "location"."""
    start: float
    end: float
    coordinates: NDArray[np.float32]
    """(components, 2 * keys) frame and value by turns: one row is what `foreach_set("co", ...)` takes."""
    interpolation: NDArray[np.int32] | None
    """Per key 0 constant, 1 linear, 2 Bezier (Blender's numbers); None where all are linear."""

@final
class Notice:
    entry: int
    """Index of the entry it is about."""
    text: str

@final
class Evaluation:
    channels: list[ResultChannel]
    """Only channels that an entry touches."""
    notices: list[Notice]
    start: float
    end: float
    """First and last key of what the entries made."""

def evaluate(rig: Rig, base: Sequence[BaseChannel], entries: Sequence[Track | Filter]) -> Evaluation:
    """Base motion + entries, in order, -> the resulting motion per channel, with what the user should know."""

def digest(arrays: Sequence[NDArray[np.float32]]) -> str:
    """A short hash of float32 arrays, to notice curves that were edited by hand."""

def parse_recipe(text: str, *, name: str | PathLike[str]) -> dict[str, Any]:
    """Read the text of a stack file, TOML or JSON: `version`, `skeleton`, `rate_hz` and `entries`, whose keys are the
    names of the add-on's properties. What has its default is left out. Raises ParameterError with the line."""

def format_recipe(recipe: Mapping[str, Any]) -> str:
    """Return a stack file as TOML. Raises ParameterError where it holds what a stack file cannot."""

@final
class LibraryFolder:
    """A folder of the library."""

    path: str
    clips: int
    """How many clips belong to it, broken and missing ones too."""
    broken: int
    """How many of them cannot be read."""
    missing: int
    """How many of them are no longer there."""
    scanned_at: int | None
    """When a scan of it was last complete, in seconds since 1970."""

@final
class LibraryClip:
    """A clip as the library knows it. What nobody knows is None; docs/library.md says what every field means."""

    id: int
    """The clip's number in its library: it stays, wherever the file moves."""
    path: str
    name: str
    folder: str
    """The folder of the library in which it lies and the folders below it, with "/" between them."""
    size: int
    modified_ns: int
    content_hash: str | None
    """The BLAKE3 hash of the file's bytes in hexadecimal digits."""
    format: str
    frames: int | None
    first_frame: int | None
    rate_hz: float | None
    duration_s: float | None
    joints: int | None
    markers: int | None
    skeleton_fingerprint: str | None
    height_m: float | None
    unit_m: float | None
    up: str | None
    skeleton_path: str | None
    skeleton_reason: str | None
    subject: str | None
    recorded_on: str | None
    description: str | None
    session_group: str | None
    cleaned: bool | None
    rating: int
    """From 1 to 5 stars; 0 for none."""
    is_favourite: bool
    used_at: int | None
    """When it was last used, in seconds since 1970."""
    notices: list[str]
    error: str | None
    """Why the file cannot be read."""
    is_missing: bool
    tags: list[str]
    segments: list[tuple[int, int]]
    """The usable pieces: first and last frame, in the file's own numbers."""
    sources: dict[str, str]
    """Which source says what is in force, by field: "FILE", "INDEX", "SIDECAR" or "USER"."""

@final
class ScanProgress:
    """How far a scan is."""

    phase: str
    """"LOOKING", "READING", "DRAWING" or "DONE"."""
    done: int
    """How many files it has read, ..."""
    total: int
    """... of how many that are new or changed; it grows while the scan is looking."""
    current: str
    """The path of the file that was taken up last."""
    unchanged: int
    """How many clips are as they were: these are not opened."""
    new: int
    changed: int
    moved: int
    missing: int
    broken: int
    """How many of the files that were read are damaged."""
    previews_done: int
    previews_total: int
    is_finished: bool
    error: str | None
    """Why it could not go on."""

@final
class Scan:
    """A scan that runs in the background, also when nobody holds this any more."""

    def progress(self) -> ScanProgress: ...
    def cancel(self) -> None:
        """Stop as soon as the files that are being read are done; what was read stays in the library."""

    def wait(self, timeout_s: float | None = None) -> bool:
        """Wait for the end, at most so long, and return whether it has come. Releases the interpreter."""

@final
class Library:
    """A catalogue of clips in a file. Several processes and threads may use one at a time, also while one scans.

    Raises LibraryError where the file is something else or of a later version (it is left as it is then), or cannot be
    written; ParameterError for what makes no sense; OSError for folders that are not there.
    """

    def __new__(cls, path: str | PathLike[str]) -> Library:
        """Open a library; make it where there is no file, bring one of an earlier version up to date."""

    path: str
    def folders(self) -> list[LibraryFolder]: ...
    def add_folder(self, path: str | PathLike[str]) -> None:
        """Add a folder; its clips come with the next scan."""

    def remove_folder(self, path: str | PathLike[str]) -> None:
        """Remove a folder and what is known of its clips; the files stay."""

    def scan(
        self,
        folders: Sequence[str | PathLike[str]] | None = None,
        *,
        with_previews: bool = True,
        jobs: int | None = None,
    ) -> Scan:
        """Begin a scan of folders of the library, or folders within them (None: all), and return at once."""

    def check(self) -> list[str]:
        """Look at every page of the database, and return what is wrong; nothing where all is well."""

    def count(self) -> int:
        """Return how many clips there are, missing and broken ones too."""

    def search(self, query: str = "", *, sort: str = "name", descending: bool = False) -> NDArray[np.int64]:
        """Return the ids of the clips that a query gives, in order; docs/library.md, "Searching", says what it may hold.

        `sort` is one of "name", "path", "date", "modified", "duration", "rate", "frames", "size", "rating", "used" and
        "relevance"; equal ones follow by name, those of which it is not known stand at the end. Raises ParameterError
        where a term means nothing: the text names it and says what would be right."""

    def clips(self, ids: Sequence[int]) -> list[LibraryClip]:
        """Return clips in the order of `ids`; those that are not there are left out."""

    def values(self, field: str) -> list[tuple[str, int]]:
        """Return the values of "tag", "subject", "format" or "group", each with how many clips have it."""

    def edit(self, ids: Sequence[int], fields: dict[str, object]) -> None:
        """Write what the user says: `subject`, `recorded_on`, `description`, `session_group` as text, `cleaned` as a truth
        value (None takes the user's own value back), `rating`, `is_favourite`. All clips, or none."""

    def tag(self, ids: Sequence[int], *, add: Sequence[str] = ..., remove: Sequence[str] = ...) -> None: ...
    def set_segments(self, id: int, segments: Sequence[tuple[int, int]]) -> None:
        """Replace the usable pieces: first and last frame of each, in the file's own numbers."""

    def import_index(self, path: str | PathLike[str], columns: dict[str, str] | None = None) -> int:
        """Read a list that describes clips, such as CMU's, and return how many it describes: of the folder that it lies in
        and those below, or of the whole library where it lies elsewhere.

        `columns` maps "file", "subject", "trial", "description", "date", "group" and "cleaned" to what stands over these
        columns; without it that is guessed. Raises ParameterError where the list does not say which clips it means."""

    def mark_used(self, id: int) -> None: ...
    def sidecar(self, id: int) -> Sidecar:
        """Open the sidecar of a clip, or make a new one with what the library knows of it and else the clip itself tells.

        After `save`, `read_sidecar` lets the library know."""

    def write_sidecar(
        self, id: int, *, emptied: Sequence[str] = ..., today: str | None = None, who: str | None = None
    ) -> str:
        """Write what is known of a clip to the sidecar beside it, which is made where there is none; return its path.

        What means the same already, and what the library does not know, stays as it is. Lines of the names in `emptied`
        lose their values instead. `today` (an ISO date) and `who` are those of the system where they are not given."""

    def read_sidecar(self, id: int, *, edited: Sequence[str] = ...) -> None:
        """Take in at once what the sidecar of a clip says, as the next scan would. What the user had said in the library
        of the lines of the names in `edited` is taken back: there, the sidecar is the user's latest word."""

    def still(self, id: int) -> NDArray[np.uint8] | None:
        """The most telling pose of a clip, (height, width, 4): red, green, blue and opacity, rows from the top, colours
        not multiplied by opacity. None where it has not been drawn (`scan`)."""

    def strip(self, id: int) -> Preview | None:
        """The liveliest seconds of a clip. None where it has not been drawn (`scan`)."""

@final
class Preview:
    """A moving strip of a clip, at the speed of the clip."""

    frames: NDArray[np.uint8]
    """(frames, height, width, 4), as a `still`."""
    rate_hz: float
    """How many frames make a second."""
    still_frame: int
    """The file's own number of the frame that the still shows."""

SIDECAR_LABELS: dict[str, str]
"""The fields of a sidecar in order: "last_change": "Last changed on"."""

@final
class Sidecar:
    """What people say of a clip: `NAME.i3d` beside it, eleven lines of `label: value`.

    Labels in other words, another order, missing lines and whatever else stands there are understood as far as they can
    be, and kept in place. Raises OSError where it cannot be read or written, ParameterError for a value that a field
    cannot hold, LibraryError where someone else changed the file meanwhile; the file is what it was then."""

    path: str
    is_on_disk: bool
    """False for a new one, until it is saved."""
    is_edited: bool
    """Whether saving would change the file."""
    fields: dict[str, str]
    """Every field by its name, in the order of `SIDECAR_LABELS`; empty where there is no value."""
    unknown: list[str]
    """Lines that no field means."""
    faults: list[str]
    """What is wrong with the values, a sentence each."""

    def set(self, field: str, value: str) -> None:
        """Edit one field; nothing is on disk before `save`. *Cleaned* is empty or one of J, Ja, Y, Yes, N, Nein, No."""
    def stamp(self, *, today: str | None = None, who: str | None = None) -> None:
        """Say who changed it and when (an ISO date), if anything was changed and nothing else was said of this.

        Both are those of the system where they are not given."""
    def save(self) -> None:
        """Write the file as a whole or not at all. Permissions, encoding and line ends stay."""
    def to_bytes(self) -> bytes:
        """The file as it would be saved."""

def read_sidecar(path: str | PathLike[str]) -> Sidecar:
    """Open a sidecar that is there."""

def sidecar_cleaned(value: str) -> bool | None:
    """What *Cleaned* says: True for J, Ja, Y, Yes, False for N, Nein, No, in any case; None where it is empty. Raises
    ParameterError for anything else."""

def sidecar_for(clip_path: str | PathLike[str]) -> Sidecar:
    """Open the sidecar beside a clip, or make a new one with what the clip tells.

    That is date, subject, duration, frame rate and the skeleton that was found. A new one is on disk only once it is
    saved."""

def main() -> int:
    """The program `motion-theater`: takes `sys.argv`, prints, returns the exit code."""
