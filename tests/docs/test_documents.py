"""The documents: their examples run, their links lead somewhere, every operator has its page."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]
EXAMPLES = [
    pytest.param(code, id=f"{document.name}-{number}")
    for document in DOCUMENTS
    for number, code in enumerate(re.findall(r"^```python\n(.*?)^```", document.read_text("utf-8"), re.M | re.S))
]
RUNNABLE = [example for example in EXAMPLES if "bpy" not in str(example.values[0])]
TRANSCRIPTS = [
    pytest.param(document, id=document.name)
    for document in DOCUMENTS
    if re.search(r"^```console$", document.read_text("utf-8"), re.M)
]
OPERATORS = sorted(
    name
    for path in (ROOT / "addon/operators").glob("*.py")
    for name in re.findall(r'bl_idname = "motion_theater\.(\w+)"', path.read_text("utf-8"))
)

documents = pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))


@pytest.mark.parametrize("code", EXAMPLES)
def test_an_example_calls_operators_that_there_are(code: str) -> None:
    compile(code, "example", "exec")
    assert set(re.findall(r"bpy\.ops\.motion_theater\.(\w+)", code)) <= set(OPERATORS)


@pytest.mark.parametrize("code", RUNNABLE)
def test_an_example_without_blender_runs_and_prints_something(
    code: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    exec(compile(code, "example", "exec"), {})
    assert capsys.readouterr().out.strip()


@pytest.mark.parametrize("document", TRANSCRIPTS)
def test_what_a_shell_is_shown_to_say_is_what_it_says(document: Path, tmp_path: Path) -> None:
    """Run a document's commands in a folder with our clips and the stack file that it shows, one after the other."""
    text = document.read_text("utf-8")
    shutil.copytree(ROOT / "testdata", tmp_path / "testdata", ignore=shutil.ignore_patterns("generate", "*.py"))
    for stack in re.findall(r"^```toml\n(.*?)^```", text, re.M | re.S):
        (tmp_path / "stack.toml").write_text(stack, "utf-8")
    environment = {**os.environ, "PATH": os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"]))}
    for transcript in re.findall(r"^```console\n(.*?)^```", text, re.M | re.S):
        commands = re.findall(r"^\$ (.*)$", transcript, re.M)
        ended = subprocess.run(
            ["bash", "-c", "\n".join(commands)],
            cwd=tmp_path,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
            check=False,
        )
        shown = re.sub(r"^\$ .*\n", "", transcript, flags=re.M)
        wanted = ".*\n".join(re.escape(part) for part in re.split(r"^\.\.\.\n", shown, flags=re.M))
        assert re.fullmatch(wanted, ended.stdout, re.S), f"shown:\n{shown}\nsaid:\n{ended.stdout}"


@documents
def test_every_link_to_a_file_leads_somewhere(document: Path) -> None:
    targets = re.findall(r"\]\(([^)#\s]+)", document.read_text("utf-8"))
    missing = [target for target in targets if "://" not in target and not (document.parent / target).exists()]
    assert missing == []


@pytest.mark.parametrize("operator", OPERATORS)
def test_every_operator_has_its_page_in_the_list(operator: str) -> None:
    assert (ROOT / f"docs/operators/{operator}.md").is_file()
    assert f"](operators/{operator}.md)" in (ROOT / "docs/README.md").read_text("utf-8")
