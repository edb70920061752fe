"""Which skeleton file belongs to a motion file, where the user did not say.

An AMC rarely names its ASF, and where it does the name is often out of date. So candidates are put in order by how
much speaks for them, each with its reason in words; the caller takes the first that fits.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import PurePath


@dataclass(frozen=True)
class Candidate:
    """A skeleton file that may belong to a motion, and why."""

    path: str
    reason: str


def subject(stem: str) -> str:
    """Return the subject that the name of a take begins with: `02` of `02_03`, `09` of `09_06-run`."""
    return re.split(r"[_\-. ]", stem, maxsplit=1)[0].casefold()


def candidates(motion: str, hint: str | None, folder: Iterable[str], parent: Iterable[str]) -> list[Candidate]:
    """Return the skeleton files for a motion among the files of its folder and of the folder above, best first."""
    found: dict[str, Candidate] = {}
    for files, where in ((folder, ""), (parent, " of the folder above")):
        skeletons = sorted(path for path in files if path.casefold().endswith(".asf"))
        for candidate in _in_folder(motion, hint, skeletons, where):
            found.setdefault(candidate.path, candidate)
    return list(found.values())


def _in_folder(motion: str, hint: str | None, skeletons: list[str], where: str) -> Iterable[Candidate]:
    stem = PurePath(motion).stem.casefold()
    hinted = PurePath(hint.replace("\\", "/")).name.casefold() if hint else None
    for path in skeletons:
        if PurePath(path).name.casefold() == hinted:
            yield Candidate(path, "named in the motion file")
    for path in skeletons:
        if PurePath(path).stem.casefold() == stem:
            yield Candidate(path, "it has the same name")
    number = subject(stem)
    same_subject = [path for path in skeletons if subject(PurePath(path).stem) == number]
    for path in sorted(same_subject, key=lambda path: len(PurePath(path).stem)):
        yield Candidate(path, f"it is of the same subject, {number}")
    if len(skeletons) == 1:
        yield Candidate(skeletons[0], f"it is the only skeleton{where or ' in the folder'}")
