"""Switching the add-on off leaves nothing behind, and it can be switched on again."""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import bpy
import pytest
from bpy_extras.io_utils import ExportHelper

from tests.harness import load_addon, module
from tests.panels.recorder import draw

addon = load_addon()
native, registration = module("native"), module("registration")
LIBRARY_ONLY = {
    *module("operators.library_browse").CLASSES,
    *module("operators.library_folders").CLASSES,
    module("operators.library_use").MOTION_THEATER_OT_library_mark_usable,
}
"""Operators that look at the library or write to it, and leave the scene alone: there is nothing to undo."""


def registered() -> set[str]:
    """Return the names of all our classes that Blender knows."""
    ours = ("MOTION_THEATER_", "MotionEntry", "MotionStack", "MarkerSet")
    return {name for name in dir(bpy.types) if name.startswith(ours)}


def handlers() -> int:
    return sum(
        len(getattr(bpy.app.handlers, name)) for name in dir(bpy.app.handlers) if name.endswith(("_pre", "_post"))
    )


def menu_entries() -> list[object]:
    """Return what add-ons put into File > Import and File > Export, in an order of its own."""
    menus = (bpy.types.TOPBAR_MT_file_import, bpy.types.TOPBAR_MT_file_export)
    return sorted((draw for menu in menus for draw in menu._dyn_ui_initialize()), key=id)


def test_unregister_mirrors_register() -> None:
    there, entries, number = registered(), menu_entries(), handlers()
    addon.unregister()
    try:
        assert not registered()
        assert not hasattr(bpy.types.Object, "motion_theater")
        assert not hasattr(bpy.types.Object, "motion_theater_markers")
        assert not hasattr(bpy.types.WindowManager, "motion_theater")
        assert len(menu_entries()) == len(entries) - len(registration.MENUS)
    finally:
        addon.register()
    assert registered() == there
    assert menu_entries() == entries
    assert handlers() == number


def test_registering_twice_in_turn_leaves_one_of_each() -> None:
    for _ in range(2):
        addon.unregister()
        addon.register()
    assert menu_entries().count(registration.MENUS[0][1]) == 1


def test_every_operator_can_be_undone_and_explains_itself() -> None:
    operators = [cls for cls in registration.CLASSES if issubclass(cls, bpy.types.Operator)]
    assert len(operators) == 37
    for cls in operators:
        rna = getattr(bpy.ops.motion_theater, cls.bl_idname.removeprefix("motion_theater.")).get_rna_type()
        writes_files_only = issubclass(cls, ExportHelper) or cls.bl_idname == "motion_theater.sidecar_edit"
        assert "REGISTER" in cls.bl_options, cls.bl_idname
        assert ("UNDO" in cls.bl_options) != (writes_files_only or cls in LIBRARY_ONLY), cls.bl_idname
        assert rna.description, f"{cls.bl_idname} has no tooltip"
        assert not rna.description.endswith("."), f"{cls.bl_idname}: Blender adds the full stop itself"
        for prop in rna.properties:
            if prop.identifier != "rna_type" and not prop.is_hidden:
                assert prop.name, f"{cls.bl_idname}.{prop.identifier} has no name"
                assert prop.description, f"{cls.bl_idname}.{prop.identifier} has no tooltip"
                assert not prop.description.endswith("."), f"{cls.bl_idname}.{prop.identifier} ends in a full stop"


def test_dropped_files_go_to_operators_that_take_them() -> None:
    for cls in registration.CLASSES:
        if issubclass(cls, bpy.types.FileHandler):
            module, name = cls.bl_import_operator.split(".")
            properties = getattr(getattr(bpy.ops, module), name).get_rna_type().properties
            assert "filepath" in properties or {"directory", "files"} <= set(properties.keys())


def test_the_manifest_names_what_the_native_module_is() -> None:
    manifest = tomllib.loads(Path(native.MANIFEST).read_text(encoding="utf-8"))
    assert manifest["id"] == "motion_theater"
    assert manifest["version"] == sys.modules["motion_theater"].__version__
    assert manifest["license"] == ["SPDX:GPL-3.0-or-later"]
    assert set(manifest["platforms"]) == {"linux-x64", "windows-x64", "macos-arm64", "macos-x64"}


def test_an_outdated_native_module_asks_for_a_restart() -> None:
    said = ". ".join(native.version_problem("0.2.0", "0.1.0"))
    assert "0.2.0" in said
    assert "0.1.0" in said
    assert "Restart Blender" in said
    assert native.version_problem("0.2.0", "0.2.0") == ()


@pytest.fixture
def without_native_module(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Run the add-on as on a machine where the native module cannot be loaded."""
    addon.unregister()
    native.problem.cache_clear()
    monkeypatch.setitem(sys.modules, "motion_theater", None)  # makes its import fail
    addon.register()
    yield
    addon.unregister()
    monkeypatch.undo()
    native.problem.cache_clear()
    addon.register()


@pytest.mark.usefixtures("without_native_module")
def test_without_the_native_module_only_the_preferences_say_so() -> None:
    assert not registered()
    assert not hasattr(bpy.types.Object, "motion_theater")
    texts = draw(native.MotionTheaterTrouble, bpy.context).texts()
    assert "cannot be loaded" in texts
    assert "Install the extension file" in texts


def test_the_native_module_of_another_version_is_not_used(monkeypatch: pytest.MonkeyPatch) -> None:
    other = ModuleType("motion_theater")
    other.__version__ = "0.0.1"  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "motion_theater", other)
    native.problem.cache_clear()
    try:
        assert "0.0.1" in native.problem()[0]
    finally:
        monkeypatch.undo()
        native.problem.cache_clear()
    assert native.problem() == ()
