"""Writes the clips into `testdata/`."""

from __future__ import annotations

from pathlib import Path

from .write import files

FOLDER = Path(__file__).resolve().parent.parent


def main() -> None:
    """Write every generated file and say so."""
    for name, text in files().items():
        (FOLDER / name).write_bytes(text.encode("ascii"))
        print(f"{name}: {len(text):,} bytes")


if __name__ == "__main__":
    main()
