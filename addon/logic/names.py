"""Names of bones: lists kept as text, and which bone of a file is which bone of an armature."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence


def split(text: str) -> list[str]:
    """Return the names of a newline separated list."""
    return [name for name in text.split("\n") if name]


def join(names: Iterable[str]) -> str:
    """Return names as a newline separated list."""
    return "\n".join(names)


def encode_pairs(pairs: Iterable[tuple[str, str]]) -> str:
    """Return pairs of file name and bone name as JSON."""
    return json.dumps([list(pair) for pair in pairs], ensure_ascii=False)


def decode_pairs(text: str) -> dict[str, str]:
    """Return bone names by file name from what `encode_pairs` made; nothing where there is none, or rubbish."""
    return dict(_pairs(text))


def by_bone(text: str) -> dict[str, str]:
    """Return file names by bone name from what `encode_pairs` made; several bones may have the same."""
    return {bone: file_name for file_name, bone in _pairs(text)}


def _pairs(text: str) -> list[tuple[str, str]]:
    try:
        pairs = json.loads(text) if text else []
        return [(str(file_name), str(bone)) for file_name, bone in pairs]
    except (ValueError, TypeError):
        return []


def match(file_names: Iterable[str], bones: Sequence[str], known: Mapping[str, str]) -> dict[str, str]:
    """Return for each name in the file the bone that it means, as far as there is one.

    The pairs noted at import come first (Blender may have had to change a name), then the same name, then the same
    name in other upper and lower case if that is not ambiguous.
    """
    there = set(bones)
    by_folded: dict[str, list[str]] = {}
    for bone in bones:
        by_folded.setdefault(bone.casefold(), []).append(bone)
    matched = {}
    for name in file_names:
        noted = known.get(name)
        alike = by_folded.get(name.casefold(), [])
        if noted in there:
            matched[name] = noted
        elif name in there:
            matched[name] = name
        elif len(alike) == 1:
            matched[name] = alike[0]
    return matched
