"""A menu that is opened where the pointer is goes when it is closed: nothing is left however often."""

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.document.samples.examples import example_document
from workbench.panels.curves.panel import CurvesPanel
from workbench.session.session import Session
from workbench.widgets.plots.depth_plot import DepthPlot


def opened_and_closed(asked: QWidget) -> None:
    """Ask for the menu of a widget as the right button does, and leave it."""
    place = asked.rect().center()
    reason = QContextMenuEvent.Reason.Mouse
    QApplication.sendEvent(asked, QContextMenuEvent(reason, place, asked.mapToGlobal(place)))
    popup = QApplication.activePopupWidget()
    assert isinstance(popup, QMenu)
    assert popup.actions()
    popup.close()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QApplication.processEvents()


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
@pytest.mark.parametrize("which", ["canvas", "plot"])
def test_no_menu_is_left(qtbot: QtBot, which: str) -> None:
    session = Session(document=example_document())
    panel = CurvesPanel(session)
    shown: QWidget = panel.center if which == "canvas" else DepthPlot()
    keep_until_the_end(qtbot, shown)
    shown.resize(800, 500)
    shown.show()
    asked = panel.canvas if which == "canvas" else shown
    before = len(shown.findChildren(QMenu))
    for _turn in range(5):
        opened_and_closed(asked)
    assert len(shown.findChildren(QMenu)) == before
    session.close()
