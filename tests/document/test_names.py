"""Names that tell things of one list apart."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.document.check import MAX_NAME
from workbench.document.names import first_free, free_name, name_of_copy

NAMES = st.one_of(
    st.text(max_size=MAX_NAME),
    st.text("a 1{}", max_size=8),
    st.sampled_from(["A line", "A line 2", "A line copy", "A line copy 3", "x" * MAX_NAME, "x" * 198 + " 9"]),
)


@given(NAMES, st.sets(NAMES, max_size=6))
def test_a_free_name_is_free_and_no_longer_than_names_are(name: str, others: set[str]) -> None:
    for naming in (free_name, name_of_copy):
        for taken in (others, others | {name}):
            free = naming(name, taken)
            assert free not in taken
            assert len(free) <= MAX_NAME


@given(NAMES.filter(lambda name: name == name.strip() != "" and len(name) < MAX_NAME - 10))
def test_naming_again_counts_up(name: str) -> None:
    for naming in (free_name, name_of_copy):
        taken = {name}
        names = [name]
        for _time in range(4):
            names.append(naming(names[-1], taken))
            taken.add(names[-1])
        numbers = [int(each.rpartition(" ")[2]) for each in names[2:]]
        assert numbers[0] < numbers[1] < numbers[2]
        assert len({each.rpartition(" ")[0] for each in names[2:]}) == 1


@pytest.mark.parametrize(
    ("name", "again", "copy"),
    [
        ("A line", "A line 2", "A line copy"),
        ("A line 2", "A line 3", "A line 2 copy"),
        ("A line 9", "A line 10", "A line 9 copy"),
        ("Exam 2081", "Exam 2081 2", "Exam 2081 copy"),
        ("A line copy", "A line copy 2", "A line copy 2"),
        ("A line copy 2", "A line copy 3", "A line copy"),
        ("{n} {name}", "{n} {name} 2", "{n} {name} copy"),
        ("x" * MAX_NAME, "x" * 198 + " 2", "x" * 195 + " copy"),
    ],
)
def test_a_name_that_is_taken(name: str, again: str, copy: str) -> None:
    assert free_name(name, {name}) == again
    assert name_of_copy(name, {name}) == copy


def test_the_first_of_several_that_is_not_taken() -> None:
    assert first_free((f"Sheet {n}" for n in range(2, 9)), {"Sheet 2", "Sheet 3"}) == "Sheet 4"
