"""What is read beside the interface: however it ends, its end is told."""

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.errors import DocumentError
from workbench.exchange.reading import Job, Result
from workbench.session.incoming import Incoming

MANY = Job("points", content=b"".join(b"%d %d\n" % (k, k % 7) for k in range(9000)))


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
@pytest.mark.parametrize("error", [RecursionError("deep"), KeyError("none"), MemoryError()])
def test_a_failure_of_the_program_is_told_and_the_next_one_works(qtbot: QtBot, error: Exception) -> None:
    incoming = Incoming()
    taken: list[Result] = []
    refused: list[str] = []

    def fail(_result: Result) -> Result:
        raise error

    with qtbot.waitSignal(incoming.ended, timeout=20_000):
        assert not incoming.read(MANY, "many", taken.append, refused.append, fail)
    assert not incoming.busy
    assert taken == []
    assert refused == ["Something in the program failed while this was being read; try another file."]
    with qtbot.waitSignal(incoming.ended, timeout=20_000):
        incoming.read(MANY, "many", taken.append, refused.append)
    assert len(taken[0]) == 9000
    assert len(refused) == 1


@pytest.mark.parametrize("job", [MANY, Job("points", content=b"1 2")])
def test_why_a_document_refuses_it_is_said_without_the_path_of_a_field(qtbot: QtBot, job: Job) -> None:
    incoming = Incoming()
    refused: list[str] = []

    def refuse(_result: Result) -> Result:
        raise DocumentError("sheets[1].name", "sheets[1].name is too long.", "The name is too long.")

    incoming.read(job, "points", lambda _result: None, refused.append, refuse)
    qtbot.waitUntil(lambda: bool(refused), timeout=20_000)
    assert refused == ["The name is too long."]


def test_a_refusal_is_no_failure(qtbot: QtBot) -> None:
    incoming = Incoming()
    refused: list[str] = []

    def refuse(_result: Result) -> Result:
        raise ValueError("There is no room.")

    with qtbot.waitSignal(incoming.ended, timeout=20_000):
        incoming.read(MANY, "many", lambda _result: None, refused.append, refuse)
    assert refused == ["There is no room."]
