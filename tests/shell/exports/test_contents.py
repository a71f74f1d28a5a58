"""What is exported: the picture, the drawing, steps and tables, each whole."""

import csv
import json
import threading
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import type_name
from tests.shell.exports.exporting import BLUE, recorded, trigger, written
from workbench.shell.command_palette import offers
from workbench.shell.window import MainWindow

# The offscreen platform says so of every dialog and menu.
pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


def test_the_picture_has_every_pixel(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    trigger(window, "export_picture")
    type_name(qtbot, window, "p")
    assert "p.png has been written" in written(qtbot, window)
    sheet = window.session.sheet
    with Image.open(tmp_path / "p.png") as image:
        cell = image.width // sheet.width_px
        assert image.size == (cell * sheet.width_px, cell * sheet.height_px)
        middle = cell // 2
        assert image.getpixel((20 * cell + middle, (sheet.height_px - 1 - 10) * cell + middle)) == BLUE


def test_the_picture_is_drawn_beside_the_interface(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import workbench.rendering as rendering

    real, threads = rendering.frame_buffer, []
    watched = lambda sheet: (threads.append(threading.current_thread().name), real(sheet))[1]  # noqa: E731
    monkeypatch.setattr(rendering, "frame_buffer", watched)
    trigger(window, "export_picture")
    type_name(qtbot, window, "dots")
    written(qtbot, window)
    assert threads == ["write"]


def test_the_drawing_is_xml_and_the_step_is_too(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    trigger(window, "export_drawing")
    type_name(qtbot, window, "d")
    written(qtbot, window)
    (line,) = [e for e in ElementTree.parse(tmp_path / "d.svg").iter() if e.tag.endswith("}line")]
    assert (line.get("x1"), line.get("y1"), line.get("x2"), line.get("y2")) == ("20", "-10", "30", "-18")
    trigger(window, "export_step")
    type_name(qtbot, window, "s.svg")
    written(qtbot, window)
    assert len(list(ElementTree.parse(tmp_path / "s.svg").iter())) > 20


def test_a_sheet_that_moves_is_a_gif_frames_and_a_sheet_of_frames(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    trigger(window, "export_animation")  # nothing moves: that is said, and nothing is asked
    window.session.open_example("animate-clock")
    card = window.files.exports.writing.card
    trigger(window, "export_animation")
    assert card.speed.currentText() == "24 frames per second"
    assert card.note.text().startswith("61 frames at its own rate: ")
    card.width_px.setCurrentIndex(card.width_px.findData(480))
    card.go.click()
    type_name(qtbot, window, "a")
    said = written(qtbot, window)
    assert "a.gif has been written" in said
    assert "hundredths of a second" in said
    with Image.open(tmp_path / "a.gif") as gif:
        assert (gif.n_frames, gif.size) == (61, (480, 480))
    trigger(window, "export_animation")
    card.kind.setCurrentIndex(1)
    card.speed.setCurrentIndex(card.speed.findText("5 frames per second"))
    assert card.speed.currentText() == "5 frames per second"
    card.go.click()
    (tmp_path / "f-003.png").write_bytes(b"mine")
    type_name(qtbot, window, "f.png")
    assert "f-003.png" in window.messages.text  # which is asked about before it is replaced
    window.messages.buttons()[-1].click()
    written(qtbot, window)
    assert len(list(tmp_path.glob("f-*.png"))) == 12
    trigger(window, "export_contacts")
    type_name(qtbot, window, "all")
    written(qtbot, window)
    with Image.open(tmp_path / "all.png") as whole:
        assert whole.size == (5 * 644, 5 * 644)


def test_the_hand_table_in_each_format(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    for name in ("t", "t.json", "t.html"):
        trigger(window, "export_hand")
        type_name(qtbot, window, name)
        written(qtbot, window)
    rows = list(csv.reader((tmp_path / "t.csv").read_text(encoding="utf-8").splitlines()))
    assert [int(row[1]) for row in rows[1:]] == [6, 2, -2, 14, 10, 6, 2, -2, 14, 10]
    told = json.loads((tmp_path / "t.json").read_text(encoding="utf-8"))
    assert [row[1] for row in told["rows"]] == [6, 2, -2, 14, 10, 6, 2, -2, 14, 10]
    cells = ElementTree.fromstring((tmp_path / "t.html").read_text(encoding="utf-8")).findall(".//tbody/tr")
    assert len(cells) == 10


def test_asked_first_the_files_tell_nothing_beforehand(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    window.session.update_state(ask_first=True)
    qtbot.waitUntil(lambda: window.session.run.ask_first)
    trigger(window, "export_hand")
    assert window.status.hover.text().startswith("The steps are kept back")
    window.say_status("")
    trigger(window, "export_run")
    assert window.status.hover.text().startswith("The steps are kept back")
    assert not any("line" in each.title for each in window.files.exports.tables())


def test_every_table_that_is_offered_is_written(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.open_example("triangle")
    window.session.update_state(active=window.session.sheet.figures[-1].id)
    recorded(qtbot, window)
    window.session.run.go(3)
    titles = [each.title for each in window.files.exports.tables()]
    assert titles[:2] == ["Pixels in the order in which they are painted", "Every line with its variables"]
    assert any("at this step" in title for title in titles)
    for number in range(len(titles)):
        window.files.exports.tables()[number].ask()
        type_name(qtbot, window, f"t{number}")
        written(qtbot, window)
        rows = list(csv.reader((tmp_path / f"t{number}.csv").read_text(encoding="utf-8").splitlines()))
        assert len(rows) > 1, titles[number]
        assert len({len(row) for row in rows}) == 1


def test_export_is_found_by_its_name(window: MainWindow) -> None:
    offered = [offer.text for offer in offers(window) if "xport" in offer.text]
    assert "Export this run..." in offered
    assert "Export a table: Every line with its variables" in offered
    menu = window.menus.submenus["export"]
    assert [a.text() for a in menu.actions() if a.text()] == [
        "Export the picture as PNG...",
        "Export the figures as SVG...",
        "Export this step...",
        "Export this run...",
        "Export the derivation...",
        "Export the drawing of the tube...",
        "Export the hand table...",
        "Export the points of the curve...",
        "Export the animation...",
        "Export a sheet of frames...",
        "Export the scene as PNG...",
        "Export the wireframe as SVG...",
        "Export without hidden lines as SVG...",
        "Export the mesh...",
        "Export another table",
    ]


def test_import_takes_what_can_be_dropped(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def choose(path: Path) -> None:
        monkeypatch.setattr("workbench.shell.files.ask_for_file", lambda *_given: path)

    (tmp_path / "points.txt").write_text("x y\n1 2\n20 30\n40 10\n", encoding="utf-8")
    for command in ("import", "open"):
        choose(tmp_path / "points.txt")
        points = [len(each.points_world) for each in window.session.sheet.figures]
        trigger(window, command)
        assert window.place == "curves"
        assert sum(len(each.points_world) for each in window.session.sheet.figures) == sum(points) + 3
    sheets = window.session.document.sheets
    choose(tmp_path / "work.gwb")
    trigger(window, "import")
    assert len(window.session.document.sheets) == len(sheets) + 1
    assert window.session.sheet.figures[0].points_world[1].x == 30
    window.session.undo_stack.undo()
    assert window.session.document.sheets == sheets
