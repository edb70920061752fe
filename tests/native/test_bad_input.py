"""Broken files: each gives one clear error with its place, and nothing panics.

A panic of the core would arrive as a `BaseException` that none of these tests expect.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import motion_theater as mt
from tests.native.files import TESTDATA

ASF = """\
:version 1.10
:name bad
:units
  mass 1.0
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name hips
    direction 0 1 0
    length 2.5
    axis 0 0 0 XYZ
    dof rx ry rz
    limits (-160.0 20.0)
           (-70.0 70.0)
           (-60.0 70.0)
  end
  begin
    id 2
    name chest
    direction 0 1 0
    length 3.5
    axis 0 0 0 XYZ
    dof rx
    limits (-60.0 60.0)
  end
:hierarchy
  begin
    root hips
    hips chest
  end
"""

AMC = """\
#!OML:ASF bad.asf
:FULLY-SPECIFIED
:DEGREES
1
root 0 0 0 0 0 0
hips 1 2 3
chest 4
2
root 0 0 0 0 0 0
hips 1 2 3
chest 5
"""


def asf(old: str, new: str) -> bytes:
    """Return the skeleton with one passage changed."""
    assert old in ASF
    return ASF.replace(old, new, 1).encode()


def amc(old: str, new: str) -> bytes:
    """Return the motion with one passage changed."""
    assert old in AMC
    return AMC.replace(old, new, 1).encode()


# What is broken, as which file, its bytes, the line of the error, and a word of what was expected or found.
BROKEN = [
    ("an empty skeleton", "a.asf", b"", 1, "an empty file"),
    ("an empty motion", "a.amc", b"", 1, "an empty file"),
    ("binary noise as skeleton", "a.asf", bytes(range(256)) * 4, 1, ""),
    ("binary noise as motion", "a.amc", bytes(range(256)) * 4, 1, ""),
    ("a picture as skeleton", "a.asf", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 1, ""),
    ("UTF-16 skeleton", "a.asf", ASF.encode("utf-16"), 1, "UTF-16"),
    ("UTF-16 motion", "a.amc", AMC.encode("utf-16"), 1, "UTF-16"),
    ("a length that is no number", "a.asf", asf("length 2.5", "length long"), 17, "`long`"),
    ("a length that is NaN", "a.asf", asf("length 2.5", "length nan"), 17, "nan"),
    ("an infinite direction", "a.asf", asf("direction 0 1 0", "direction 0 inf 0"), 16, "inf"),
    ("a length beyond all numbers", "a.asf", asf("length 2.5", "length 1e999"), 17, "1e999"),
    ("a direction of two numbers", "a.asf", asf("direction 0 1 0", "direction 0 1"), 16, ""),
    ("an unknown degree of freedom", "a.asf", asf("dof rx ry rz", "dof rx ry rw"), 19, "`rw`"),
    ("an unknown order", "a.asf", asf("axis 0 0 0 XYZ", "axis 0 0 0 XYX"), 18, "XYX"),
    ("a limit without its upper end", "a.asf", asf("(-160.0 20.0)", "(-160.0)"), 23, "`end`"),
    ("two bones of one name", "a.asf", asf("name chest", "name hips"), None, "hips"),
    ("a bone without a name", "a.asf", asf("    name hips\n", ""), None, "name"),
    ("a bone that never ends", "a.asf", asf("  end\n:hierarchy", ":hierarchy"), None, ""),
    ("an unknown bone in the hierarchy", "a.asf", asf("hips chest\n", "hips chest tail\n"), 36, "tail"),
    (
        "a bone that is its own ancestor",
        "a.asf",
        asf("    hips chest\n", "    hips chest\n    chest hips\n"),
        37,
        "hips",
    ),
    ("a bone with two parents", "a.asf", asf("root hips\n", "root hips chest\n"), 36, "chest"),
    (
        "a ring of bones apart from the root",
        "a.asf",
        asf("root hips\n    hips chest\n", "hips chest\n    chest hips\n"),
        None,
        "",
    ),
    ("a value that is no number", "a.amc", amc("hips 1 2 3", "hips 1 two 3"), 6, "`two`"),
    ("a value that is NaN", "a.amc", amc("hips 1 2 3", "hips 1 nan 3"), 6, "nan"),
    ("a value that is infinite", "a.amc", amc("hips 1 2 3", "hips 1 -inf 3"), 6, "inf"),
    ("a value beyond all numbers", "a.amc", amc("hips 1 2 3", "hips 1 1e999 3"), 6, "1e999"),
    ("a bone twice in a frame", "a.amc", amc("chest 4", "chest 4\nchest 4"), 8, "chest"),
    ("a bone missing in the second frame", "a.amc", amc("chest 5\n", ""), None, "chest"),
    ("a bone that the first frame lacks", "a.amc", amc("chest 5\n", "chest 5\ntail 1\n"), 12, "tail"),
    ("a value too few in the second frame", "a.amc", amc("hips 1 2 3\nchest 5", "hips 1 2\nchest 5"), 10, "hips"),
    ("a value too many in the second frame", "a.amc", amc("chest 5", "chest 5 6"), 11, "chest"),
    ("a rate of nothing", "a.amc", amc(":DEGREES", ":SAMPLES-PER-SECOND 0\n:DEGREES"), 3, ""),
    ("keywords without a frame", "a.amc", b":FULLY-SPECIFIED\n:DEGREES\n", None, "end of the file"),
]


@pytest.mark.parametrize(("what", "name", "data", "line", "word"), BROKEN, ids=[row[0] for row in BROKEN])
def test_a_broken_file_is_met_with_its_place_and_what_was_expected_and_found(
    what: str, name: str, data: bytes, line: int | None, word: str, tmp_path: Path
) -> None:
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(mt.ParseError) as from_disk:
        mt.read(path)
    with pytest.raises(mt.ParseError) as from_memory:
        mt.read_bytes(data, name=name)
    error = from_disk.value
    assert error.path == str(path)
    assert error.line is not None
    assert error.line >= 1
    if line is not None:
        assert error.line == line
    assert error.byte is None
    assert error.expected
    assert error.found
    assert word in f"{error.expected} {error.found}"
    assert str(error).startswith(f"{path}, line {error.line}")
    assert error.expected in str(error)
    assert error.found in str(error)
    assert "\n" not in str(error)
    assert (from_memory.value.line, from_memory.value.expected, from_memory.value.found) == (
        error.line,
        error.expected,
        error.found,
    )


def test_what_a_file_is_counts_more_than_what_it_is_called() -> None:
    assert mt.read_bytes(AMC.encode(), name="a.asf").format == "amc"
    assert mt.read_bytes(ASF.encode(), name="a.amc").format == "asf"


def test_every_parse_error_is_a_motion_theater_error_and_a_value_error() -> None:
    assert issubclass(mt.ParseError, mt.MotionTheaterError)
    assert issubclass(mt.ParseError, ValueError)
    assert not issubclass(mt.MotionTheaterError, OSError)


@pytest.fixture(scope="module")
def skeleton() -> mt.Skeleton:
    """Return the two-bone skeleton that the motions of this file fit."""
    found = mt.read_bytes(ASF.encode(), name="good.asf").skeleton
    assert found is not None
    return found


MISFITS = [
    ("an unknown bone", AMC.replace("chest", "tail"), "tail"),
    ("a value too many", AMC.replace("chest 4", "chest 4 4").replace("chest 5", "chest 5 5"), "chest"),
    ("a value too few", AMC.replace("hips 1 2 3", "hips 1 2"), "hips"),
]


@pytest.mark.parametrize(("what", "text", "bone"), MISFITS, ids=[row[0] for row in MISFITS])
def test_a_motion_that_does_not_fit_is_refused_with_the_bones(
    what: str, text: str, bone: str, skeleton: mt.Skeleton
) -> None:
    with pytest.raises(mt.MisfitError) as refused:
        mt.read_bytes(text.encode(), name="a.amc", skeleton=skeleton)
    assert any(bone in entry for entry in refused.value.bones)
    assert bone in str(refused.value)
    clip = mt.read_bytes(text.encode(), name="a.amc")
    with pytest.raises(mt.MisfitError):
        clip.bind(skeleton)


def cut_somewhere(data: bytes, name: str) -> Iterator[str]:
    """Yield what happens to a file that ends after each of its bytes."""
    for length in range(len(data)):
        try:
            mt.read_bytes(data[:length], name=name)
            yield "read"
        except mt.ParseError as error:
            assert error.line is not None
            assert 1 <= error.line <= data[:length].count(b"\n") + 1
            yield "refused"


def test_a_skeleton_cut_off_at_any_byte_is_refused_or_read() -> None:
    data = (TESTDATA / "human.asf").read_bytes()
    outcomes = list(cut_somewhere(data, "cut.asf"))
    assert outcomes.count("refused") > 0.99 * len(data)


def test_a_motion_cut_off_at_any_byte_is_refused_or_read() -> None:
    data = b"".join((TESTDATA / "walk.amc").read_bytes().splitlines(keepends=True)[:100])
    outcomes = list(cut_somewhere(data, "cut.amc"))
    assert "refused" in outcomes
    assert len(outcomes) == len(data)


@settings(max_examples=300)
@given(st.binary(max_size=400), st.sampled_from(["x.asf", "x.amc"]))
def test_noise_gives_no_other_error(data: bytes, name: str) -> None:
    try:
        clip = mt.read_bytes(data, name=name)
    except mt.ParseError as error:
        assert str(error).startswith(name)
    else:
        assert clip.format == name[-3:]


@settings(max_examples=300)
@given(
    st.sampled_from([("x.asf", ASF), ("x.amc", AMC)]),
    st.lists(st.tuples(st.integers(0, 10_000), st.integers(0, 255)), min_size=1, max_size=8),
)
def test_a_file_with_changed_bytes_gives_no_other_error(
    skeleton: mt.Skeleton, file: tuple[str, str], changes: list[tuple[int, int]]
) -> None:
    name, text = file
    changed = bytearray(text.encode())
    for place, value in changes:
        changed[place % len(changed)] = value
    try:
        clip = mt.read_bytes(bytes(changed), name=name, skeleton=skeleton)
    except (mt.ParseError, mt.MisfitError) as error:
        assert name in str(error)
        return
    if clip.skeleton is not None:
        assert np.isfinite(clip.skeleton.heads).all()
    if clip.motion is not None:
        clip.motion.pose(skeleton, float(clip.motion.first_frame))


def deep_skeleton(depth: int) -> bytes:
    """Return a chain of that many bones."""
    head, rest = ASF.split(":bonedata\n")
    bones = "".join(f"begin\nname b{index}\ndirection 0 1 0\nlength 1\naxis 0 0 0 XYZ\nend\n" for index in range(depth))
    links = "".join(f"b{index - 1} b{index}\n" for index in range(1, depth))
    assert rest
    return f"{head}:bonedata\n{bones}:hierarchy\nbegin\nroot b0\n{links}end\n".encode()


def test_a_million_bones_in_a_chain_overflow_nothing() -> None:
    clip = mt.read_bytes(deep_skeleton(1_000_000), name="deep.asf")
    assert clip.skeleton is not None
    assert len(clip.skeleton.names) == 1_000_001
    assert clip.skeleton.height == 1_000_000


def test_a_missing_file_is_a_file_not_found_error(tmp_path: Path) -> None:
    path = tmp_path / "gone.asf"
    with pytest.raises(FileNotFoundError) as error:
        mt.read(path)
    assert str(path) in str(error.value)


def test_a_file_that_vanishes_between_two_calls_is_a_file_not_found_error(tmp_path: Path) -> None:
    path = tmp_path / "here.asf"
    path.write_text(ASF, encoding="utf-8")
    assert mt.read(path).format == "asf"
    path.unlink()
    with pytest.raises(FileNotFoundError):
        mt.read(path)


@pytest.mark.parametrize("name", ["folder.asf", "folder.amc"])
def test_a_directory_is_an_is_a_directory_error(tmp_path: Path, name: str) -> None:
    (tmp_path / name).mkdir()
    with pytest.raises(IsADirectoryError):
        mt.read(tmp_path / name)


@pytest.mark.parametrize("name", ["no.asf", "no.amc"])
def test_a_file_without_permission_is_a_permission_error(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text(ASF, encoding="utf-8")
    path.chmod(0)
    user = os.geteuid()
    if user == 0:
        os.seteuid(65534)  # to the one who may do everything, nothing is forbidden
    try:
        with pytest.raises(PermissionError):
            mt.read(path)
    finally:
        os.seteuid(user)


@pytest.mark.parametrize("name", ["motion.txt", "motion", "motion.fbx"])
def test_a_kind_of_file_that_is_not_supported_is_said(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text("a letter\n", encoding="utf-8")
    with pytest.raises(mt.MotionTheaterError) as error:
        mt.read(path)
    assert name in str(error.value)


def test_files_in_other_cases_line_ends_and_with_a_mark_are_read_alike(skeleton: mt.Skeleton) -> None:
    plain = mt.read_bytes(AMC.encode(), name="a.amc", skeleton=skeleton).motion
    assert plain is not None
    changed = b"\xef\xbb\xbf" + AMC.replace("\n", "\r\n").replace(" ", "\t  ").rstrip().encode()
    other = mt.read_bytes(changed, name="A.AMC", skeleton=skeleton).motion
    assert other is not None
    for bone in range(len(plain.names)):
        np.testing.assert_array_equal(plain.angles(bone), other.angles(bone))
