"""What changed is told one way: who is told of it, and shows it, writes nothing back into the session."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.document.edits import move_figures, remove_figures, set_algorithm
from workbench.document.samples.examples import example
from workbench.document.state import SessionState
from workbench.document.storage.files import Stored
from workbench.document.subjects import Position, Subject
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.display.tubes_page import TubesPage
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.panels.shared.compare import ComparePanel
from workbench.panels.shared.inspector import InspectorPanel
from workbench.panels.shared.why import WhyList
from workbench.session.session import Session


class Watched(Session):
    """A session that notes who changes it while it tells, or while a panel is being refreshed."""

    def __init__(self) -> None:
        super().__init__(document=example("line").document)
        self.busy = 0
        self.written: list[dict[str, Any]] = []

    def update_state(self, **changes: Any) -> None:
        if self.busy:
            self.written.append(changes)
        super().update_state(**changes)

    def frame(self, by: int) -> None:
        """Connect a slot that counts telling up, or down."""

        def count(*_arguments: object) -> None:
            self.busy += by

        self.changed.connect(count)
        self.state_changed.connect(count)


def watch(kind: type[QWidget], session: Watched, monkeypatch: pytest.MonkeyPatch) -> None:
    """Note what a widget of this kind writes while it is being refreshed."""
    refresh = getattr(kind, "refresh", None)
    if refresh is None:
        return

    def watched(widget: QWidget, *arguments: Any) -> None:
        session.busy += 1
        try:
            refresh(widget, *arguments)
        finally:
            session.busy -= 1

    monkeypatch.setattr(kind, "refresh", watched)


@pytest.fixture
def session(qtbot: QtBot) -> Iterator[Watched]:
    """A session that is closed in the end."""
    session = Watched()
    yield session
    session.close()


def settle(session: Session, qtbot: QtBot) -> None:
    for _turn in range(3):
        QApplication.processEvents()
    qtbot.waitUntil(lambda: session.run.done and session.followers[0].done, timeout=20_000)
    QApplication.processEvents()


@pytest.mark.parametrize(
    ("kind", "slug"),
    [
        (DrawPanel, "line"),
        (FillPanel, "triangle"),
        (ClipPanel, "clip"),
        (CurvesPanel, "curve-interpolation"),
        (TubesPage, "line"),
        (ComparePanel, "slopes"),
        (WhyList, "line"),
        (InspectorPanel, "line"),
    ],
)
def test_nothing_is_written_while_it_is_told(
    session: Watched, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, kind: type[QWidget], slug: str
) -> None:
    watch(kind, session, monkeypatch)
    session.frame(1)
    panel = kind(session)  # type: ignore[call-overload]
    keep_until_the_end(qtbot, panel)
    session.frame(-1)
    panel.show()
    settle(session, qtbot)
    elsewhere = SessionState(workspace="elsewhere", positions={"elsewhere": Position(Subject("clipper"))})
    session.take(Stored(example(slug).document, elsewhere), Path("x.gwb"), None)
    settle(session, qtbot)
    usual = getattr(panel, "usual", Subject()) if hasattr(panel, "slug") else Subject("clipper")
    assert (session.state.workspace, session.state.subject) == (getattr(panel, "slug", "elsewhere"), usual)
    front = session.sheet.figures[-1]
    session.update_state(active=front.id, selection=(front.id,), pixel=(3, 3))
    settle(session, qtbot)
    session.update_state(subject=Subject("curve", entry="de_boor", arguments={"u": 0.25}))
    session.update_state(ask_first=True, detail=True, compare="dda_line")
    settle(session, qtbot)
    session.update_state(subject=usual)
    session.update_state(ask_first=False, detail=False, step=2)
    session.apply(move_figures([front.id], 1, 0), "Move")
    settle(session, qtbot)
    session.apply(set_algorithm(front.id, front.algorithms[-1]), "Change")
    settle(session, qtbot)
    session.undo_stack.undo()
    session.apply(remove_figures([figure.id for figure in session.sheet.figures]), "Delete")
    settle(session, qtbot)
    session.undo_stack.undo()
    settle(session, qtbot)
    assert session.busy == 0
    assert session.written == []
