"""A line of text that is typed into: the search box of the grid."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class TextField:
    """A text with a cursor. Keys are named as Blender's events are."""

    text: str = ""
    cursor: int = 0
    is_active: bool = False
    is_all_selected: bool = False

    def begin(self, *, select_all: bool = True) -> None:
        """Let it take keys."""
        self.is_active, self.cursor = True, len(self.text)
        self.is_all_selected = select_all and bool(self.text)

    def end(self) -> None:
        """Let it take none."""
        self.is_active = self.is_all_selected = False

    def insert(self, text: str) -> None:
        """Put text at the cursor, in place of what is selected."""
        if self.is_all_selected:
            self.clear()
        clean = "".join(character for character in text if character.isprintable())
        self.text = self.text[: self.cursor] + clean + self.text[self.cursor :]
        self.cursor += len(clean)

    def clear(self) -> None:
        """Take everything away."""
        self.text, self.cursor, self.is_all_selected = "", 0, False

    def press(self, key: str, *, by_word: bool = False) -> bool:
        """Take an editing key; return whether it was one."""
        if key in {"BACK_SPACE", "DEL"}:
            self._delete(key, by_word)
            return True
        places = {
            "LEFT_ARROW": self._left(by_word),
            "RIGHT_ARROW": self._right(by_word),
            "HOME": 0,
            "END": len(self.text),
        }
        if key not in places:
            return False
        self.cursor, self.is_all_selected = places[key], False
        return True

    def _delete(self, key: str, by_word: bool) -> None:
        if self.is_all_selected:
            self.clear()
            return
        other = self._left(by_word) if key == "BACK_SPACE" else self._right(by_word)
        low, high = sorted((self.cursor, other))
        self.text, self.cursor = self.text[:low] + self.text[high:], low

    def _left(self, by_word: bool) -> int:
        if not by_word:
            return max(0, self.cursor - 1)
        before = self.text[: self.cursor].rstrip()
        return before.rfind(" ") + 1

    def _right(self, by_word: bool) -> int:
        if not by_word:
            return min(len(self.text), self.cursor + 1)
        rest = self.text[self.cursor :].lstrip()
        skipped = len(self.text) - self.cursor - len(rest)
        space = rest.find(" ")
        return len(self.text) if space < 0 else self.cursor + skipped + space
