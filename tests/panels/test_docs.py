"""The page of each operator names every option that a user or a script can set, with its default."""

from __future__ import annotations

import bpy
import pytest

from tests.harness import ROOT, module

PAGES = ROOT / "docs/operators"
OPERATORS = [
    cls.bl_idname.removeprefix("motion_theater.")
    for cls in module("registration").CLASSES
    if issubclass(cls, bpy.types.Operator)
]


def test_there_is_one_page_per_operator() -> None:
    assert {page.stem for page in PAGES.glob("*.md")} == set(OPERATORS)


@pytest.mark.parametrize("name", OPERATORS)
def test_a_page_names_every_option_with_its_default(name: str) -> None:
    text = (PAGES / f"{name}.md").read_text(encoding="utf-8")
    options = getattr(bpy.ops.motion_theater, name).get_rna_type().properties
    for option in options:
        if option.identifier == "rna_type" or (option.is_hidden and option.identifier != "filepath"):
            continue
        assert f"| `{option.identifier}` | {option.name} |" in text, f"{name}.md does not name {option.identifier}"
        if option.type in {"INT", "FLOAT"}:
            assert f"`{option.default:g}`" in text, f"{name}.md: the default of {option.identifier}"
        for item in option.enum_items if option.type == "ENUM" else ():
            assert f"`{item.identifier}` {item.name}" in text, f"{name}.md: the choice {item.identifier}"
