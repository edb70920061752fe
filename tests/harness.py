"""The add-on inside the bpy module: loading it, empty files, selections, and pictures of a scene to compare.

The folder `addon/` is imported as a package of another name, as Blender does: the add-on never knows its own.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from types import ModuleType
from typing import Any

import bpy
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
TESTDATA = ROOT / "testdata"
SHARED = ROOT.parent / "shared" / "data"
PACKAGE = "motion_theater_addon"
DATA_BLOCKS = ("objects", "armatures", "actions", "collections", "meshes", "materials", "texts", "images", "scenes")


def load_addon() -> ModuleType:
    """Import and register the add-on, once a process."""
    if PACKAGE in sys.modules:
        return sys.modules[PACKAGE]
    folder = ROOT / "addon"
    spec = importlib.util.spec_from_file_location(
        PACKAGE, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    assert spec is not None
    assert spec.loader is not None
    package = importlib.util.module_from_spec(spec)
    sys.modules[PACKAGE] = package
    spec.loader.exec_module(package)
    package.register()
    return package


def module(name: str) -> ModuleType:
    """Return a module of the add-on: `module("stack")`, `module("curves.read")`."""
    load_addon()
    return importlib.import_module(f"{PACKAGE}.{name}")


def empty_file() -> None:
    """Start with nothing: no objects, no animation, Blender's own settings."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    load_addon()


def armature() -> bpy.types.Object:
    """Return the active armature."""
    ob = bpy.context.view_layer.objects.active
    assert ob is not None
    assert ob.type == "ARMATURE"
    return ob


def import_human(**options: object) -> bpy.types.Object:
    """Import the skeleton of the project's own clips."""
    bpy.ops.motion_theater.import_skeleton(filepath=str(TESTDATA / "human.asf"), **options)
    return armature()


def add(clip: str, **options: object) -> bpy.types.Object:
    """Add one of the project's own clips to the active armature."""
    bpy.ops.motion_theater.add_track(filepath=str(TESTDATA / clip), **options)
    return armature()


def load_human(path: str, *, link: bool) -> bpy.types.Object:
    """Append or link the armature of another .blend file."""
    libraries: Any = bpy.data.libraries
    with libraries.load(path, link=link) as (_, into):
        into.objects = ["human"]
    (ob,) = into.objects
    bpy.context.scene.collection.objects.link(ob)
    return ob


def select(ob: bpy.types.Object, names: Iterable[str]) -> None:
    """Select these bones and no others."""
    compat, wanted = module("compat"), set(names)
    for bone in ob.pose.bones:
        compat.select_bone(bone, bone.name in wanted)


def below(ob: bpy.types.Object, *tops: str) -> list[str]:
    """Return the names of some bones and of all below them."""
    return [
        bone.name for bone in ob.data.bones if bone.name in tops or any(up.name in tops for up in bone.parent_recursive)
    ]


def fcurves(ob: bpy.types.Object) -> dict[tuple[str, int], bpy.types.FCurve]:
    """Return the F-curves that animate an object."""
    action = ob.animation_data.action if ob.animation_data else None
    return module("curves.read").index(module("compat").bag_of(ob, action))


def keys(ob: bpy.types.Object) -> dict[tuple[str, int], dict[str, np.ndarray]]:
    """Return all fields of all keys of an object, as copies."""
    read = module("curves.read")
    return {path: read.keys(curve) for path, curve in fcurves(ob).items()}


def same_keys(some: dict, others: dict, *, of: Callable[[str], bool] = lambda path: True) -> bool:
    """Return whether keys are equal bit for bit, of the data paths that are asked for."""
    some, others = ({at: fields for at, fields in keys.items() if of(at[0])} for keys in (some, others))
    return some.keys() == others.keys() and all(
        fields[name].tobytes() == others[at][name].tobytes() for at, fields in some.items() for name in fields
    )


def of_bones(names: Iterable[str]) -> Callable[[str], bool]:
    """Return a filter for data paths of these bones."""
    starts = tuple(f'pose.bones["{name}"].' for name in names)
    return lambda path: path.startswith(starts)


def key_rows(ob: bpy.types.Object, bone: str, channel: str) -> np.ndarray:
    """Return (keys, 1 + components): frame and values of one channel, whose curves must have the same frames."""
    read, curves = module("curves.read"), fcurves(ob)
    rows = [
        read.coordinates(curves[read.path(bone, channel), component]).reshape(-1, 2)
        for component in range(read.CHANNELS[channel])
    ]
    assert all(np.array_equal(row[:, 0], rows[0][:, 0]) for row in rows)
    return np.column_stack([rows[0][:, 0], *(row[:, 1] for row in rows)])


def pose(ob: bpy.types.Object, frame: float) -> np.ndarray:
    """Return (bones, 4, 4): the pose matrices at a scene frame, in armature space."""
    scene = bpy.context.scene
    scene.frame_set(int(np.floor(frame)), subframe=float(frame - np.floor(frame)))
    matrices = np.empty(16 * len(ob.pose.bones), np.float32)
    ob.pose.bones.foreach_get("matrix", matrices)
    return matrices.reshape(-1, 4, 4).transpose(0, 2, 1).astype(np.float64)


def snapshot() -> dict[str, object]:
    """Return what an action that fails must leave as it was."""
    context, scene = bpy.context, bpy.context.scene
    active = context.view_layer.objects.active
    state: dict[str, object] = {kind: sorted(block.name for block in getattr(bpy.data, kind)) for kind in DATA_BLOCKS}
    state |= {
        "active": active.name if active else None,
        "mode": context.mode,
        "selected": sorted(ob.name for ob in context.view_layer.objects if ob.select_get()),
        "frame": scene.frame_current_final,
        "range": (scene.frame_start, scene.frame_end),
        "rate": (scene.render.fps, scene.render.fps_base),
    }
    compat = module("compat")
    for ob in bpy.data.objects:
        if ob.type == "ARMATURE":
            animation = ob.animation_data
            state[f"bones of {ob.name}"] = [(bone.name, compat.is_selected(bone)) for bone in ob.pose.bones]
            state[f"action of {ob.name}"] = animation.action.name if animation and animation.action else None
            state[f"entries of {ob.name}"] = [settings(entry) for entry in ob.motion_theater.entries]
            state[f"keys of {ob.name}"] = {
                at: tuple(field.tobytes() for field in fields.values()) for at, fields in keys(ob).items()
            }
    return state


def settings(entry: object) -> dict[str, object]:
    """Return all settings of an entry but what the last rebuild noted there."""
    noted = {"rna_type", "notices", "error"}
    names = [definition.identifier for definition in entry.bl_rna.properties]  # type: ignore[attr-defined]
    values = {name: getattr(entry, name) for name in names if name not in noted}
    return {name: value.name if hasattr(value, "name") else value for name, value in values.items()}


def refusal(call: Callable[[], object]) -> str:
    """Return the message with which an operator refuses; fails if it does not, or if more than one sentence reached
    the user as an error."""
    try:
        call()
    except RuntimeError as error:  # how Blender hands a reported error to a Python caller
        lines = [line for line in str(error).splitlines() if line.strip()]
        assert "Traceback" not in str(error), str(error)
        assert len(lines) == 1, lines
        return lines[0].removeprefix("Error: ")
    raise AssertionError("the operator did not refuse")
