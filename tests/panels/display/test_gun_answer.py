"""The page Gun on paper: the drawing with labels and without, and the answer to an exam's question."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from workbench.exchange.diagram_svg import write_diagram
from workbench.exchange.diagrams import Sentence
from workbench.panels.display.gun.page import GunPage
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
