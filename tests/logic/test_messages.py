"""What the user is told."""

from __future__ import annotations

import pytest

from addon.logic import messages, record


@pytest.mark.parametrize(
    ("path", "name"),
    [("/a/b.amc", "b.amc"), ("C:\\takes\\b.amc", "b.amc"), ("b.amc", "b.amc"), ("//clips/b.amc", "b.amc")],
)
def test_a_file_is_named_without_its_folder(path: str, name: str) -> None:
    assert messages.base_name(path) == name


def test_long_lists_are_cut() -> None:
    assert messages.listing(["a", "b"]) == "a, b"
    assert messages.listing([str(number) for number in range(10)]) == "0, 1, 2, 3, 4, 5, 6, 7 and 2 more"


def test_a_new_track_is_told_in_one_sentence() -> None:
    assert messages.track_added("/a/walk.amc", 7, 1.0, 113.0) == "Added walk.amc to 7 bones, frames 1-113"
    assert messages.track_added("walk.amc", 1, 5.0, 5.0) == "Added walk.amc to 1 bone, frame 5"
    assert messages.track_added("walk.amc", 2, 1.0, 23.4) == "Added walk.amc to 2 bones, frames 1-23.4"


def test_sentences_begin_in_upper_case_and_end_open() -> None:
    assert messages.sentences(["added.", "", "blend depth 10 reduced to 3"]) == "Added. Blend depth 10 reduced to 3"
    assert messages.sentences([]) == ""


def test_a_misfit_names_file_armature_and_bones() -> None:
    assert (
        messages.misfit("/a/x.amc", ["tail"], "human") == "x.amc does not fit “human”: tail is missing in the armature"
    )
    assert "tail, wing are missing" in messages.misfit("x.amc", ["tail", "wing"], "human")


class PanicException(BaseException):
    """Of the same name as that of the native module."""


@pytest.mark.parametrize(
    ("error", "text"),
    [
        (messages.UserError("No."), "No."),
        (
            FileNotFoundError(2, "No such file or directory", "/a/b.amc"),
            "b.amc cannot be used: No such file or directory",
        ),
        (PanicException("oh"), "Motion Theater ran into an error of its own, please report it: oh"),
        (KeyError("a mistake of ours"), None),
        (KeyboardInterrupt(), None),
    ],
)
def test_errors_are_told_or_left_to_be_seen(error: BaseException, text: str | None) -> None:
    assert messages.explained(error) == text


def test_a_record_survives_as_text() -> None:
    digests = {"lfemur": "0af.", "schlüssel": "1.2"}
    assert record.decode(record.encode(digests)) == digests


@pytest.mark.parametrize(
    "rubbish", [None, 5, "", "{", "[]", '{"version": 99, "digests": {"a": "b"}}', '{"version": 1}']
)
def test_rubbish_is_no_record(rubbish: object) -> None:
    assert record.decode(rubbish) == {}
