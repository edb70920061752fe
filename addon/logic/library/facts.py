"""What is known of a clip, in words."""

from __future__ import annotations

from collections.abc import Mapping

UNITS = ("bytes", "kB", "MB", "GB", "TB")


def size(count: int) -> str:
    """Return a number of bytes for people."""
    value, number = float(count), 0
    while value >= 999.5 and number + 1 < len(UNITS):
        value, number = value / 1000.0, number + 1
    digits = f"{value:.0f}" if not number or value >= 9.95 else f"{value:.1f}"
    return f"{digits} {UNITS[number]}"


def duration(seconds: float | None) -> str:
    """Return a length of time for people."""
    if seconds is None:
        return ""
    if seconds < 59.95:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes}:{rest:02d} min"


def rate(rate_hz: float | None) -> str:
    """Return a rate for people."""
    return f"{rate_hz:.4g} Hz" if rate_hz else "rate not known"


def count(number: int, one: str, many: str) -> str:
    """Return a number of things."""
    return f"1 {one}" if number == 1 else f"{number:,} {many}"


def span(first: int, last: int) -> str:
    """Return a range of frame numbers."""
    return f"{first}-{last}" if first >= 0 else f"{first} to {last}"


def stars(rating: int) -> str:
    """Return a rating as stars."""
    return "★" * rating + "☆" * (5 - rating) if rating else ""


def tags(text: str) -> list[str]:
    """Return the tags that a person typed, separated by commas, each once."""
    found: dict[str, str] = {}
    for tag in text.split(","):
        clean = " ".join(tag.split())
        if clean:
            found.setdefault(clean.casefold(), clean)
    return list(found.values())


def term(field: str, value: str) -> str:
    """Return a term of the search: quoted where a value has spaces."""
    clean = value.replace('"', "")
    return (
        f'{field}:"{clean}"'
        if not clean or any(not (c.isalnum() or c in "-_./") for c in clean)
        else f"{field}:{clean}"
    )


def query(words: str, filters: Mapping[str, str]) -> str:
    """Return what is searched for: the words of the search box and one term for each filter that is set."""
    terms = [term(field, value) for field, value in filters.items() if value]
    return " ".join(part for part in [words.strip(), *terms] if part)
