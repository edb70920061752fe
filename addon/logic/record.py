"""What the last rebuild wrote, kept with the action as JSON: one short hash a bone.

Curves that no longer have the hash noted here were edited by hand.
"""

from __future__ import annotations

import json
from collections.abc import Mapping

KEY = "motion_theater"
"""The custom property of the action that holds the record, and by its presence marks the action as a result."""

VERSION = 1


def encode(digests: Mapping[str, str]) -> str:
    """Return the record as text."""
    return json.dumps({"version": VERSION, "digests": dict(digests)}, ensure_ascii=False)


def decode(text: object) -> dict[str, str]:
    """Return hashes by bone; nothing from what is no record, so that every curve then counts as the animator's own."""
    try:
        record = json.loads(text) if isinstance(text, str) else {}
        digests = record["digests"] if record.get("version") == VERSION else {}
        return {str(bone): str(digest) for bone, digest in digests.items()}
    except (ValueError, AttributeError, KeyError):
        return {}
