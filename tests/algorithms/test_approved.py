"""What a student reads and sees of every entry's telling runs is what was approved as text.

After a change that is meant, ``pytest tests/algorithms/test_approved.py --approve`` writes the files anew,
and the diff shows what became of them.
"""

from functools import cache
from pathlib import Path

import pytest

from tests.algorithms.telling_runs import FURTHER, telling_runs
from tests.algorithms.told import is_sentence_of, steps_of, tells, told, words
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry

APPROVED = Path(__file__).parent / "approved"
ENTRIES = catalogue.entries()
each = pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.slug)


@cache
def text_told(slug: str) -> str:
    """What is told of all telling runs of an entry."""
    entry = catalogue.get(slug)
    return told(entry, telling_runs(entry))


@each
def test_the_words_are_those_that_were_approved(entry: Entry, pytestconfig: pytest.Config) -> None:
    file = APPROVED / entry.topic / f"{entry.slug}.txt"
    text = text_told(entry.slug)
    if pytestconfig.getoption("approve"):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8", newline="\n")
    assert file.exists(), f"{file} is not there yet: look at what --approve writes"
    assert text.splitlines() == file.read_text(encoding="utf-8").splitlines()


@each
def test_every_view_that_says_something_is_among_them(entry: Entry) -> None:
    """Those for arrays too large to record are shown by ``engine/test_left_out.py``."""
    unseen = [
        view for view in entry.views if (view.sentence or view.row) and "not is_recorded(" not in view.when
    ]
    sentences = text_told(entry.slug).splitlines()
    for run in telling_runs(entry):
        for step in steps_of(entry, run):
            unseen = [view for view in unseen if not tells(view, step.view, (words(step.sentence),))]
    unseen = [view for view in unseen if not any(is_sentence_of(view, one) for one in sentences)]
    assert [(view.block, view.when) for view in unseen] == []


def test_every_approved_file_belongs_to_an_entry() -> None:
    files = {file.relative_to(APPROVED).as_posix() for file in APPROVED.rglob("*.txt")}
    assert files == {f"{entry.topic}/{entry.slug}.txt" for entry in ENTRIES}
    assert FURTHER.keys() <= {entry.slug for entry in ENTRIES}
