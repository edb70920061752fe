"""What became of many files fits into one line each."""

from __future__ import annotations

from addon.logic.batch import LONGEST_LINE, Verdicts, short


def test_a_long_line_is_cut_and_a_short_one_stays() -> None:
    assert short("Imported walk.c3d: 31 markers") == "Imported walk.c3d: 31 markers"
    cut = short("x" * 500)
    assert len(cut) == LONGEST_LINE
    assert cut.endswith("…")


def test_of_an_added_track_the_last_sentence_is_shown() -> None:
    line = "Took human.asf, because it came with the motion. Added walk.amc to 31 bones, frames 1-612"
    assert short(line) == "Added walk.amc to 31 bones, frames 1-612"


def test_the_counts_leave_the_reasons_to_the_summary() -> None:
    verdicts = Verdicts(["a", "b"], ["c.bvh: empty"], not_begun=3)
    assert verdicts.counts() == "Imported 2 files, skipped 1, stopped with 3 left"
    assert verdicts.summary() == "Imported 2 files, skipped 1, stopped with 3 left (c.bvh: empty)"
