"""A card ends within its canvas, however low that is, and all that it holds can be reached."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QScrollArea, QToolButton, QWidget

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.panels.stage.folding_card import WIDTH_PX, FoldingCard
from workbench.widgets.canvas.pixel_canvas import PixelCanvas

GAP_PX = 8


@pytest.fixture
def canvas(qtbot):
    widget = PixelCanvas()
    keep_until_the_end(qtbot, widget)
    widget.resize(800, 600)
    widget.show()
    qtbot.waitExposed(widget)
    return widget


@pytest.fixture
def card(canvas):
    folding = FoldingCard(canvas)
    folding.move(GAP_PX, GAP_PX)
    for number in range(10):
        label = QLabel(f"Line {number}")
        label.setMinimumHeight(30)
        folding.body.addWidget(label)
    folding.show()
    settle()
    return folding


def bar(card):
    return card.findChild(QScrollArea).verticalScrollBar()


def whole(label, card):
    """Whether all of a label is seen."""
    return label.visibleRegion().boundingRect() == label.rect()


def test_a_card_with_room_has_no_bar(card):
    assert card.width() == WIDTH_PX
    assert bar(card).maximum() == 0
    assert all(whole(label, card) for label in card.body.parentWidget().findChildren(QLabel))


@pytest.mark.parametrize("height", [120, 200, 330])
def test_a_card_on_a_low_canvas_scrolls_to_its_last_line(card, canvas, height):
    canvas.resize(800, height)
    settle()
    assert card.geometry().bottom() < canvas.area.bottom / canvas.devicePixelRatioF() < height
    assert bar(card).maximum() > 0
    labels = card.body.parentWidget().findChildren(QLabel)
    bar(card).setValue(bar(card).maximum())
    settle()
    assert whole(labels[-1], card)
    assert labels[-1].width() == WIDTH_PX - 20, "its bar stands beside what it holds"


def test_its_button_is_called_what_it_does_now(qtbot, card):
    """A folded card is not to be folded again."""
    button = card.findChild(QToolButton)
    for words in ("Fold this card", "Unfold this card", "Fold this card"):
        assert button.accessibleName() == button.toolTip() == words
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_a_card_grows_again_with_its_canvas(card, canvas):
    before = card.size()
    canvas.resize(800, 200)
    settle()
    canvas.resize(800, 600)
    settle()
    assert card.size() == before


def test_a_card_is_as_high_as_what_it_holds_now(card):
    before = card.height()
    card.body.itemAt(0).widget().hide()
    settle()
    assert card.height() == before - 30 - card.body.spacing()


def test_what_asks_for_more_width_than_the_card_has_ends_before_its_bar(card, canvas):
    wide = QWidget()
    row = QHBoxLayout(wide)
    for name in ("near", "far"):
        row.addWidget(QPushButton(name * 4))
    card.body.addWidget(wide)
    canvas.resize(800, 200)
    settle()
    area = card.findChild(QScrollArea)
    assert area.widget().width() == area.viewport().width()
