"""Stands in for Blender's layout: checks every name that draw code uses, and remembers what would be shown.

Blender itself only prints an error for a misspelt property or icon, and draws on. Here it fails the test.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import bpy

RNA = bpy.types.UILayout.bl_rna
ICONS = set(RNA.functions["prop"].parameters["icon"].enum_items.keys())
LAYOUTS = {"row", "column", "box", "split", "grid_flow", "column_flow", "menu_pie"}
WITH_PROPERTY = {"prop", "prop_enum", "prop_search", "prop_menu_enum", "prop_tabs_enum"}


@dataclass(frozen=True)
class Shown:
    """One thing that would be drawn."""

    what: str
    """The layout's function: "label", "prop", "operator", ..."""
    name: str = ""
    """Property, operator, menu or list."""
    text: str = ""
    icon: str = "NONE"
    enabled: bool = True
    active: bool = True
    alert: bool = False
    properties: dict[str, Any] = field(default_factory=dict, hash=False, compare=False)
    """What the button gives its operator."""


class Recorder:
    """A layout, or a part of one; all parts write into one list."""

    def __init__(self, parent: Recorder | None = None, *, open_panels: bool = True) -> None:
        state = {
            "shown": parent.shown if parent else [],
            "open_panels": parent.open_panels if parent else open_panels,
            "enabled": parent.enabled if parent else True,
            "active": parent.active if parent else True,
            "alert": parent.alert if parent else False,
        }
        for name, value in state.items():
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        assert name in RNA.properties, f"a layout has no property {name}"
        object.__setattr__(self, name, value)

    def __getattr__(self, name: str) -> Any:
        assert name in RNA.functions, f"a layout has no function {name}"

        def call(*positional: Any, **named: Any) -> Any:
            return self._call(name, _arguments(name, positional, named))

        return call

    def _call(self, name: str, given: dict[str, Any]) -> Any:
        icon = given.get("icon", "NONE")
        assert icon in ICONS, f"there is no icon {icon}"
        if name == "enum_item_icon":
            return _enum_item(given).icon and 1
        if name == "enum_item_name":
            return _enum_item(given).name
        if name in LAYOUTS:
            return Recorder(self)
        if name == "panel":
            return Recorder(self), Recorder(self) if self.open_panels else None
        for owner, prop in _properties_used(name, given):
            assert prop in owner.bl_rna.properties, f"{owner} has no property {prop}"
        target = str(
            given.get("property") or given.get("operator") or given.get("menu") or given.get("listtype_name", "")
        )
        shown = Shown(name, target, given.get("text", ""), icon, self.enabled, self.active, self.alert, {})
        self.shown.append(shown)
        if name == "operator":
            return _Properties(target, shown.properties)
        if name == "menu":
            assert hasattr(bpy.types, target), f"there is no menu {target}"
        if name == "template_list":
            assert hasattr(bpy.types, target), f"there is no list {target}"
        return None

    def texts(self) -> str:
        """Return all texts, for a search."""
        return "\n".join(shown.text for shown in self.shown)

    def names(self, what: str) -> list[str]:
        """Return what is shown of one kind."""
        return [shown.name for shown in self.shown if shown.what == what]

    def find(self, name: str, **properties: Any) -> Shown:
        """Return the one thing of a name, whose operator gets these properties."""
        found = [
            shown
            for shown in self.shown
            if shown.name == name and all(shown.properties.get(key) == value for key, value in properties.items())
        ]
        assert found, f"{name} is not shown; there are {[shown.name for shown in self.shown if shown.name]}"
        return found[0]


class _Properties:
    """The properties of an operator's button: only those that the operator has, and values that fit."""

    def __init__(self, operator: str, given: dict[str, Any]) -> None:
        module, name = operator.split(".")
        rna = getattr(getattr(bpy.ops, module), name).get_rna_type()  # KeyError if there is no such operator
        object.__setattr__(self, "_rna", rna)
        object.__setattr__(self, "_given", given)

    def __setattr__(self, name: str, value: Any) -> None:
        assert name in self._rna.properties, f"{self._rna.identifier} has no option {name}"
        prop = self._rna.properties[name]
        if prop.type == "ENUM":
            assert value in prop.enum_items, f"{self._rna.identifier}.{name} cannot be {value}"
        self._given[name] = value


def _arguments(function: str, positional: tuple[Any, ...], named: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments by name, as Blender's own definition of the function orders them."""
    parameters = [parameter.identifier for parameter in RNA.functions[function].parameters if not parameter.is_output]
    unknown = set(named) - set(parameters)
    assert not unknown, f"{function} has no argument {unknown}"
    return dict(zip(parameters, positional, strict=False)) | named


def _properties_used(function: str, given: dict[str, Any]) -> list[tuple[Any, str]]:
    if function == "template_list":
        return [
            (given["dataptr"], given["propname"]),
            (given["active_dataptr"], given["active_propname"]),
        ]
    used = [(given["data"], given["property"])] if function in WITH_PROPERTY else []
    if function == "prop_search":
        used.append((given["search_data"], given["search_property"]))
    return used


def _enum_item(given: dict[str, Any]) -> Any:
    return given["data"].bl_rna.properties[given["property"]].enum_items[given["identifier"]]


def draw(panel: Any, context: Any, *, open_panels: bool = True) -> Recorder:
    """Draw a panel or a menu, with its header."""
    layout = Recorder(open_panels=open_panels)
    stand_in = SimpleNamespace(layout=layout, bl_idname=panel.__name__)
    if hasattr(panel, "draw_header"):
        panel.draw_header(stand_in, context)
    panel.draw(stand_in, context)
    return layout
