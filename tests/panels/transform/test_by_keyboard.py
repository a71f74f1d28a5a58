"""Transform without a mouse, and what no transform can be: said in its field, with nothing lost."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import recorded, settle
from tests.panels.transform.hand import chain, type_into, whole
from workbench.document.transforms.chains import matrix_of
from workbench.document.transforms.links import Reflect, Rotate, Scale


def added(panel, kind):
    """The card of a link that was added from the list, of a kind."""
    for action in panel.chain.menu.actions():
        action.trigger()
        settle()
        if panel.chain.cards[-1].kind is kind:
            return panel.chain.cards[-1]
    raise AssertionError(kind)


def test_a_figure_is_turned_and_its_product_stepped_by_keys(qtbot, panel, session):
    type_into(qtbot, panel.chain.cards[0].fields["angle"], "180/2")
    assert chain(session)[0].angle == 90.0
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-12)
    panel.window().activateWindow()
    panel.canvas.setFocus()
    qtbot.waitUntil(lambda: QApplication.focusWidget() is panel.canvas)
    recorded(qtbot, session)
    step = session.run.number
    session.run.forward()
    assert session.run.number == step + 1
    for _tab in range(60):
        qtbot.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
        if QApplication.focusWidget() is panel.canvas:
            break
    assert QApplication.focusWidget() is panel.canvas  # the tab key goes round


@pytest.mark.parametrize("name", ["sx", "sy"])
def test_a_scale_of_0_is_said_and_can_be_put_right(qtbot, panel, session, name):
    card = added(panel, Scale)
    points = [(p.x, p.y) for p in session.active_figure.points_world]
    type_into(qtbot, card.fields[name], "0")
    assert getattr(chain(session)[-1], name) == 0.0
    assert "A factor of 0 flattens the figure" in card.complaint.text()
    type_into(qtbot, card.fields[name], "2")
    assert not card.complaint.text()
    assert [(p.x, p.y) for p in session.active_figure.points_world] == points


@pytest.mark.parametrize("text", ["inf", "1e400", "-1e12", "1/0", "nan"])
@pytest.mark.parametrize(("kind", "name"), [(Rotate, "x_pivot"), (Reflect, "y_pivot"), (Reflect, "angle")])
def test_a_pivot_at_infinity_and_a_mirror_without_direction_are_refused(
    qtbot, panel, session, kind, name, text
):
    card = added(panel, kind)
    before = session.document
    type_into(qtbot, card.fields[name], text)
    assert session.document is before
    assert card.fields[name].complaint.text().endswith(".")
