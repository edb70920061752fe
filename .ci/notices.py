"""The licence notices of what is linked into the wheel: every Rust crate of the module, for one platform."""

from __future__ import annotations

import json
import subprocess
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
MODULE = "motion-theater-python"
NOTICE_FILES = ("LICENSE*", "LICENCE*", "COPYING*", "COPYRIGHT*", "NOTICE*", "UNLICENSE*")


def linked_packages(metadata: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the foreign packages whose code ends up in the module: no build scripts, no macros, no test helpers."""
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    found: set[str] = set()
    waiting = [package["id"] for package in metadata["packages"] if package["name"] == MODULE]
    while waiting:
        identifier = waiting.pop()
        is_macro = any("proc-macro" in target["kind"] for target in packages[identifier]["targets"])
        if identifier in found or is_macro:
            continue
        found.add(identifier)
        for dependency in nodes[identifier]["deps"]:
            if any(kind["kind"] is None for kind in dependency["dep_kinds"]):
                waiting.append(dependency["pkg"])
    return sorted((packages[i] for i in found if packages[i]["source"]), key=lambda package: str(package["name"]))


def notice_texts(package: dict[str, Any]) -> Iterator[str]:
    """Yield the licence texts that a package ships."""
    folder = Path(package["manifest_path"]).parent
    for path in sorted({path for pattern in NOTICE_FILES for path in folder.glob(pattern) if path.is_file()}):
        yield path.read_text(encoding="utf-8").strip()


def third_party_notices(target: str) -> str:
    """Return one text for the wheel of a Rust target: who is in it, then each licence text once."""
    command = ["cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", target]
    metadata = json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout)
    users: dict[str, list[str]] = defaultdict(list)
    texts: dict[str, str] = {}
    lines = ["The native module of Motion Theater contains code of these Rust crates:", ""]
    for package in linked_packages(metadata):
        name = f"{package['name']} {package['version']}"
        lines.append(f"  {name}  ({package['license']})  {', '.join(package['authors'])}".rstrip())
        for text in notice_texts(package):
            key = " ".join(text.split())  # the same licence, wrapped otherwise
            texts.setdefault(key, text)
            users[key].append(name)
    lines += ["", "and of the standard library of Rust (MIT OR Apache-2.0), by the Rust project's contributors.", ""]
    for key, text in texts.items():
        lines += ["-" * 100, f"For {', '.join(dict.fromkeys(users[key]))}:", "", text, ""]
    return "\n".join(lines)
