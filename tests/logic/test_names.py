"""Names of bones: lists as text, and which bone of a file is which bone of an armature."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic import names

NAMES = st.lists(st.text(st.characters(exclude_characters="\n", exclude_categories=["Cs"]), min_size=1))


@given(NAMES)
def test_a_list_survives_as_text(some: list[str]) -> None:
    assert names.split(names.join(some)) == some


@given(
    st.dictionaries(
        st.text(st.characters(exclude_categories=["Cs"])), st.text(st.characters(exclude_categories=["Cs"]))
    )
)
def test_pairs_survive_as_text(pairs: dict[str, str]) -> None:
    assert names.decode_pairs(names.encode_pairs(pairs.items())) == pairs


@pytest.mark.parametrize("rubbish", ["", "{", "[1, 2]", "null", '{"a": 1}', '[["a"]]'])
def test_rubbish_is_no_pairs(rubbish: str) -> None:
    assert names.decode_pairs(rubbish) == {}


@pytest.mark.parametrize(
    ("file_names", "bones", "known", "expected"),
    [
        (["hips"], ["hips", "Hips"], {}, {"hips": "hips"}),
        (["HIPS"], ["Hips"], {}, {"HIPS": "Hips"}),
        (["HIPS"], ["Hips", "hips"], {}, {}),
        (["hips"], ["hips", "hips.001"], {"hips": "hips.001"}, {"hips": "hips.001"}),
        (["hips"], ["hips"], {"hips": "gone"}, {"hips": "hips"}),
        (["hips", "tail"], ["hips"], {}, {"hips": "hips"}),
    ],
    ids=["same", "other case", "ambiguous case", "noted", "noted but gone", "missing"],
)
def test_a_name_means(file_names: list[str], bones: list[str], known: dict[str, str], expected: dict[str, str]) -> None:
    assert names.match(file_names, bones, known) == expected
