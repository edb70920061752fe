"""The program `motion-theater` as the wheel installs it."""

from __future__ import annotations

import json
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import OUR_PAIRS, REAL_PAIRS, ROOT, TESTDATA, Pair

PROGRAM = shutil.which("motion-theater", path=str(Path(sys.executable).parent))

pairs = pytest.mark.parametrize("pair", OUR_PAIRS + REAL_PAIRS, ids=lambda pair: pair.name)


def run(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run the installed program in the project's folder."""
    assert PROGRAM is not None, "the wheel installs the program beside its Python"
    words = [PROGRAM, *map(str, arguments)]
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True, encoding="utf-8", check=False)


def answer(*arguments: str | Path) -> list[dict[str, Any]]:
    """Return the JSON objects of a run that goes well."""
    ended = run(*arguments, "--json")
    assert (ended.returncode, ended.stderr) == (0, "")
    return [json.loads(line) for line in ended.stdout.splitlines()]


def test_the_program_says_the_version_of_the_module() -> None:
    assert run("--version").stdout == f"motion-theater {mt.__version__}\n"


def test_exit_codes_are_0_for_good_1_for_a_bad_file_and_2_for_wrong_use() -> None:
    assert run("info", TESTDATA / "walk.amc").returncode == 0
    bad = run("info", TESTDATA / "walk.amc", TESTDATA / "none.amc")
    assert (bad.returncode, bad.stderr) == (1, f"{TESTDATA / 'none.amc'}: No such file or directory\n")
    assert run("convert", "walk.amc").returncode == 2


@pairs
def test_info_says_what_the_module_reads(pair: Pair) -> None:
    skeleton, motion, clip = pair.read()
    (info,) = answer("info", pair.amc, "--skeleton", pair.asf)
    assert (info["format"], info["frames"], info["joints"]) == ("amc", motion.frames, clip.names)
    assert (info["unit_m"], info["up"], info["error"]) == (skeleton.unit_m, "Y", None)
    assert info["rate_hz"] == (motion.rate_hz or 120.0)
    assert info["duration_s"] == motion.frames / info["rate_hz"]


@pairs
def test_a_pose_is_that_of_the_core(pair: Pair) -> None:
    skeleton, motion, _ = pair.read()
    frame = motion.first_frame + motion.frames // 2
    (pose,) = answer("pose", pair.amc, "--skeleton", pair.asf, "--frame", str(frame))
    _, tails, _ = motion.pose(skeleton, frame)
    assert (pose["frame"], pose["names"]) == (frame, skeleton.names)
    assert np.array_equal(pose["positions_file"], tails)
    assert np.allclose(pose["positions_m"], tails[:, [0, 2, 1]] * (1, -1, 1) * skeleton.unit_m, rtol=0, atol=1e-12)


def test_output_that_nobody_reads_is_no_error() -> None:
    assert PROGRAM is not None
    files = [str(TESTDATA / "walk.amc")] * 50
    with subprocess.Popen([PROGRAM, "info", *files], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        assert (process.stderr.read(), process.wait()) == (b"", 0)


@pytest.mark.skipif(sys.platform == "win32", reason="a process there is interrupted in another way")
def test_ctrl_c_ends_a_folder_between_two_files(tmp_path: Path) -> None:
    assert PROGRAM is not None
    source = tmp_path / "in"
    source.mkdir()
    shutil.copy(TESTDATA / "human.asf", source)
    for number in range(200):
        shutil.copy(TESTDATA / "walk.amc", source / f"walk{number:03}.amc")
    command = [PROGRAM, "convert", str(source), str(tmp_path / "out"), "--format", "bvh", "--jobs", "2"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        summary = process.stdout.read().splitlines()[-1]
        assert process.wait() == 130
    assert summary.endswith(" not begun")
    written = sorted((tmp_path / "out").iterdir())
    assert summary.startswith(f"{len(written)} converted, ")
    assert 0 < len(written) < 200
    assert {mt.read(path).frames for path in written} == {612}


def test_a_stack_file_goes_through_python_and_back() -> None:
    text = 'skeleton = "human.asf"\n[[entries]]\nkind = "TRACK"\nsource = "wave.amc"\ncut_end = 55\n'
    recipe = mt.parse_recipe(text, name="stack.toml")
    entry = {"kind": "TRACK", "source": "wave.amc", "cut_end": 55}
    assert recipe == {"version": 1, "skeleton": "human.asf", "entries": [entry]}
    assert mt.parse_recipe(mt.format_recipe(recipe), name="again") == recipe
    with pytest.raises(mt.ParameterError, match=r"stack.toml, line 1, column 1: unknown field `speed`"):
        mt.parse_recipe("speed = 2", name="stack.toml")
    with pytest.raises(mt.ParameterError, match="unknown field `speed`"):
        mt.format_recipe({"speed": 2})
