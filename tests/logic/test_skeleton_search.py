"""Which skeleton file is taken for a motion file."""

from __future__ import annotations

import pytest

from addon.logic.skeleton_search import candidates, subject


@pytest.mark.parametrize(
    ("motion", "hint", "folder", "parent", "expected"),
    [
        ("/d/02_03.amc", None, ["/d/01.asf", "/d/02.asf"], [], [("/d/02.asf", "it is of the same subject, 02")]),
        ("/d/a.amc", None, ["/d/a.ASF", "/d/b.asf"], [], [("/d/a.ASF", "it has the same name")]),
        ("/d/09_06-run.amc", None, ["/d/09-run.asf"], [], [("/d/09-run.asf", "it is of the same subject, 09")]),
        ("/d/walk.amc", None, ["/d/any.asf"], [], [("/d/any.asf", "it is the only skeleton in the folder")]),
        ("/d/walk.amc", None, [], ["/any.asf"], [("/any.asf", "it is the only skeleton of the folder above")]),
        (
            "/d/a_1.amc",
            "C:\\old\\B.ASF",
            ["/d/a.asf", "/d/b.asf"],
            [],
            [("/d/b.asf", "named in the motion file"), ("/d/a.asf", "it is of the same subject, a")],
        ),
        ("/d/walk.amc", None, ["/d/x.asf", "/d/y.asf", "/d/walk.txt"], [], []),
        (
            "/d/a.amc",
            None,
            ["/d/a.asf"],
            ["/a.asf"],
            [("/d/a.asf", "it has the same name"), ("/a.asf", "it has the same name")],
        ),
    ],
    ids=["subject", "name", "subject with more", "only one", "only one above", "hint first", "none", "nearer first"],
)
def test_candidates_come_best_first(
    motion: str, hint: str | None, folder: list[str], parent: list[str], expected: list[tuple[str, str]]
) -> None:
    assert [(found.path, found.reason) for found in candidates(motion, hint, folder, parent)] == expected


def test_the_exact_subject_goes_before_a_longer_name() -> None:
    found = candidates("/d/02_03.amc", None, ["/d/02-long.asf", "/d/02.asf"], [])
    assert [candidate.path for candidate in found] == ["/d/02.asf", "/d/02-long.asf"]


@pytest.mark.parametrize(("stem", "number"), [("02_03", "02"), ("09-run", "09"), ("Walk", "walk"), ("a.b", "a")])
def test_the_subject_begins_the_name(stem: str, number: str) -> None:
    assert subject(stem) == number
