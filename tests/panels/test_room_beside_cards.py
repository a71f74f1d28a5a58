"""What a card holds is seen whole, and what stands beside it or under it is not covered by it."""

import pytest
from PySide6.QtCore import QPoint, QRect

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.edits import add_figure
from workbench.document.model import Polygon, WorldPoint
from workbench.document.samples.examples import blank_sheet, example
from workbench.document.transforms.edits import add_transform
from workbench.document.transforms.links import Rotate
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.space.visibility.page import VisibilityPage
from workbench.panels.transform.panel import TransformPanel
from workbench.session.session import Session
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.plots.trace_plot import TracePlot


@pytest.fixture
def shown(qtbot):
    """Shows a panel over a document, in a size."""
    sessions = []

    def show(kind, document, width, height):
        session = Session(document=document)
        sessions.append(session)
        panel = kind(session)
        keep_until_the_end(qtbot, panel)
        panel.resize(width, height)
        panel.show()
        if kind is VisibilityPage:
            session.visit("visibility", panel.usual)
            qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)
        settle()
        return panel

    yield show
    for session in sessions:
        session.close()
        session.deleteLater()


def place(widget, over):
    """Where a widget lies in another."""
    return QRect(widget.mapTo(over, QPoint(0, 0)), widget.size())


def test_the_numbers_of_the_card_of_visibility_have_their_right_border(shown):
    card = shown(VisibilityPage, example("overlapping-triangles").document, 900, 620).card
    for field in card.findChildren(NumberField):
        if field.isVisible():
            assert place(field, card._body).contains(place(field.field, card._body)), field.label.text()


@pytest.mark.parametrize("height", [620, 400, 300])
def test_the_card_of_visibility_ends_above_the_numbers_of_the_axis(shown, height):
    page = shown(VisibilityPage, example("overlapping-triangles").document, 900, height)
    assert place(page.card, page.canvas).bottom() < page.canvas.area.bottom / page.canvas.devicePixelRatioF()


def test_a_choice_of_the_card_of_draw_that_has_no_room_ends_in_dots(shown):
    panel = shown(DrawPanel, example("line").document, 850, 600)
    panel.session.update_state(selection=(panel.session.sheet.figures[0].id,))
    settle()
    box = panel.card.compare
    index = next(k for k in range(box.count()) if "fixed" in box.itemText(k))
    box.setCurrentIndex(index)
    settle()
    assert box.fontMetrics().horizontalAdvance(box.itemText(index)) > 200
    assert box.words_seen().endswith("…")
    assert box.itemText(index) in box.toolTip()


def test_what_a_transform_makes_lies_beside_the_card(shown):
    points = tuple(WorldPoint("", x, y) for x, y in ((55, 210), (121, 210), (88, 243)))
    document = add_figure("s1", Polygon("", points, "scan_line_exact", 1))(blank_sheet(400, 260))
    made = document.sheets[0].figures[0].id
    document = add_transform(made, Rotate("", angle=45.0))(document)
    panel = shown(TransformPanel, document, 762, 620)
    left, bottom, _right, _top = panel.canvas._whole()
    assert left < -100
    assert panel.canvas.widget_position(left - 0.5, bottom).x() > panel.card.geometry().right()


def test_a_title_that_is_cut_does_not_touch_the_value_beside_it(qtbot):
    plot = TracePlot("Light at the probe", "of its mean, measured", 2)
    qtbot.addWidget(plot)
    plot.resize(190, 104)
    plot.show_curve([0.0, 1.0], [0.0, 1.0], (0.0, 1.0), "16.7 ms", 0.5)
    plot.show()
    settle()
    assert plot._title.geometry().right() + 4 < plot._value.geometry().left()
