"""What the tests of the Transform panel share: what is shown of a chain, and how its handles are found."""

import numpy as np
from PySide6.QtCore import Qt

from tests.panels.by_hand import settle
from workbench.rendering.mapping import device_map


def figure(session):
    return session.active_figure


def chain(session):
    return figure(session).transforms


def device(session, x, y):
    return device_map(session.sheet).point(x, y)


def handle(panel, name):
    return panel.view.chain_box.box.places()[name]


def shown(panel, row, term):
    """The numbers of a matrix as it is shown, NaN where there is a dot."""
    cells = panel.matrices.rows[row].terms[term].cells
    return np.array([[np.nan if cell.value is None else cell.value for cell in line] for line in cells])


def whole(panel):
    """The matrix of the chain as it is shown: of one stage in the first row, else in the last."""
    single = set(panel.matrices.rows[0].of) == {2, 4}
    return shown(panel, 0, 4) if single else shown(panel, -1, 1)


def type_into(qtbot, field, text):
    field.field.setFocus()
    field.field.selectAll()
    qtbot.keyClicks(field.field, text)
    qtbot.keyClick(field.field, Qt.Key.Key_Return)
    settle()
