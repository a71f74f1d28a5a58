"""The page Gun on paper: the drawing with labels and without, and the answer to an exam's question."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from workbench.algorithms.marks import Stroke, Word
from workbench.display.cutaway import labels
from workbench.display.gun import Gun
from workbench.exchange.diagram_svg import PaperMetrics, write_diagram
from workbench.exchange.diagrams import MARGIN_PT, PAGE_PT, WORD_PT, Arrow, Sentence
from workbench.exchange.formulas.layout import Typesetter
from workbench.panels.display.gun.page import GunPage
from workbench.panels.display.gun.paper import figure
from workbench.widgets.formulas.paper import write_pdf


def test_the_drawing_is_saved_with_labels_and_without(gun_page: GunPage) -> None:
    with_labels = gun_page.drawing()
    gun_page.bar.labels.setChecked(False)
    without = gun_page.drawing()
    assert with_labels is not None
    assert without is not None
    named, bare = write_diagram(with_labels), write_diagram(without)
    for title in ("control grid", "focusing anode", "conductive coating", "heater", "electron beam"):
        assert title in named
        assert title not in bare
    assert bare.count("<poly") > 20
    assert write_pdf(without).startswith(b"%PDF")


def test_the_answer_has_a_diagram_and_five_points(gun_page: GunPage) -> None:
    made = gun_page.derivation()
    assert made is not None
    text = write_diagram(made)
    for number in range(1, 6):
        assert f">{number}." in text.replace("\n", "")
    assert "24" in text
    assert "control grid" in text
    assert ">26524" in text  # km/s: the root of 2 e V / m at 2 kV, without relativity
    for asked in ("Electrostatic:", "Magnetic:", "Focus<", "Brightness<", "Contrast<"):
        assert asked in text


def test_the_answer_works_out_the_turn_of_coils(gun_page: GunPage) -> None:
    gun_page._edit({"coils": True, "length": 20.0, "x_field": 0.0, "y_field": 1.0})
    gun_page.session.flush()
    gun_page.refresh()
    made = gun_page.derivation()
    assert made is not None
    text = " ".join(block.text for block in made.blocks if isinstance(block, Sentence))
    assert "= 0.1326$ for $l = 20$ mm, $B = 1$ mT, $V_a = 2000$ V." in text
    assert "= 26.76$ mm from the middle" in text
    gun_page._edit({"y_field": 10.0})
    gun_page.session.flush()
    gun_page.refresh()
    made = gun_page.derivation()
    assert made is not None
    assert "No sine is 1 or more" in " ".join(b.text for b in made.blocks if isinstance(b, Sentence))


def test_the_button_asks_what_the_menu_asks(gun_page: GunPage, qtbot: QtBot) -> None:
    menu = QMenu()
    action = QAction("Export the drawing of the tube...", menu)
    action.setObjectName("export_tube")
    menu.addAction(action)
    gun_page.offer_export(menu)
    with qtbot.waitSignal(action.triggered):
        qtbot.mouseClick(gun_page.bar.save, Qt.MouseButton.LeftButton)


@pytest.mark.parametrize("gun", [Gun(), Gun(coils=True), Gun(coils=True, length=20.0), Gun(length=60.0)])
def test_words_on_paper_stand_apart_at_the_ends_of_their_lines(gun: Gun) -> None:
    drawing = figure(gun)
    xmin, ymin, xmax, ymax = drawing.window
    scale = min((PAGE_PT - 2 * MARGIN_PT) / (xmax - xmin), drawing.height / (ymax - ymin))
    words = [item for item in drawing.items if isinstance(item, Word)]
    typesetter = Typesetter(PaperMetrics())
    spread = {}
    for word in words:
        wide = typesetter.formula(word.text, WORD_PT).width
        left = word.x * scale - wide * (1 - word.right) / 2
        spread[word] = left, left + wide
    for k, one in enumerate(words):
        for other in words[:k]:
            if abs(one.y - other.y) * scale < 0.9 * WORD_PT:
                first, second = sorted((spread[one], spread[other]))
                assert second[0] - first[1] > 4.0, (one.text, other.text)
    titles = {f'"{each.title}"' for each in labels(gun)}
    leaders = [item for item in drawing.items if isinstance(item, Stroke) and len(item.points) == 2]
    for word in (each for each in words if each.text in titles):
        ends = [x for stroke in leaders for x, y in stroke.points if abs(y - word.y) * scale < WORD_PT]
        left, right = spread[word]
        assert any(left - 1.4 * WORD_PT < x * scale < right + 1.4 * WORD_PT for x in ends), word.text
    arrows = [item.points for item in drawing.items if isinstance(item, Arrow)]
    assert len(arrows) == 4
    for word in (each for each in words if each.text[0] in "lD"):
        left, right = spread[word]
        for points in (each for each in arrows if each[0][1] == word.y):
            begin, end = sorted(points[:, 0] * scale)
            assert end <= left or begin >= right, "no line goes through a length"
