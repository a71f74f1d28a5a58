"""File, Export and Save as in their real dialogs; what is written is read back by another reader."""

import csv
import json
import os
import re
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image, ImageSequence
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import dialog_of, type_name
from workbench.document.storage.files import load
from workbench.shell.command_palette import offers
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow

# The offscreen platform says so of every dialog and menu.
pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)

BLUE = (0x00, 0x72, 0xB2)


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[MainWindow]:
    """The whole program, with a line in Draw whose run is recorded, saved as work.gwb."""
    from workbench.session.session import Session

    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    made = make_window(Settings())
    made.resize(1280, 680)
    made.show()
    made.attach(Session(made))
    qtbot.waitExposed(made)
    made.open_example("line")
    made.session.save_as(tmp_path / "work.gwb")
    recorded(qtbot, made)
    yield made
    made.session.undo_stack.setClean()
    made.close()
    made.deleteLater()


def recorded(qtbot: QtBot, window: MainWindow) -> None:
    run = window.session.run
    window.session.flush()
    qtbot.waitUntil(lambda: run.entry is not None and run.done, timeout=10_000)


def trigger(window: MainWindow, name: str) -> None:
    window.menus.actions[name].trigger()


def written(qtbot: QtBot, window: MainWindow) -> str:
    """Wait until it is written; what is said then."""
    qtbot.waitUntil(lambda: not window.files.exports.writing.writer.busy, timeout=20_000)
    return window.messages.text


def names(folder: Path) -> list[str]:
    return sorted(each.name for each in folder.iterdir())


def choose_run(window: MainWindow, suffix: str, width: int = 480, seconds: float = 0.5) -> None:
    """Export this run: choose on the card and go on to the dialog."""
    trigger(window, "export_run")
    card = window.files.exports.writing.card
    card.kind.setCurrentIndex([row.suffix for row in card._formats].index(suffix))
    card.width_px.setCurrentIndex(card.width_px.findData(width))
    card.speed.setCurrentIndex(card.speed.findData(seconds))
    card.go.click()


# Save as


def test_a_name_without_ending_is_completed_before_the_question(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    before = (tmp_path / "work.gwb").read_bytes()
    window.open_example("octants")
    drawn = window.session.document
    window.files.save_as()
    asked = type_name(qtbot, window, "work", "No")
    assert len(asked) == 1
    assert "work.gwb" in asked[0]
    assert (tmp_path / "work.gwb").read_bytes() == before
    assert type_name(qtbot, window, "work", "Yes") == asked
    window.session.finish_saving()
    assert load(tmp_path / "work.gwb") == drawn
    assert names(tmp_path) == ["work.gwb"]


@pytest.mark.parametrize(
    ("typed", "name"), [("lab 2.3", "lab 2.3.gwb"), ("new.", "new.gwb"), ("A.GWB", "A.GWB")]
)
def test_a_point_in_a_name_is_no_ending(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, typed: str, name: str
) -> None:
    window.files.save_as()
    assert type_name(qtbot, window, typed) == []
    window.session.finish_saving()
    assert names(tmp_path) == sorted([name, "work.gwb"])


def test_a_completed_name_that_is_there_is_asked_about(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    (tmp_path / "lab 2.3.gwb").write_bytes(b"mine")
    window.files.save_as()
    (question,) = type_name(qtbot, window, "lab 2.3", "No")
    assert "lab 2.3.gwb" in question
    assert (tmp_path / "lab 2.3.gwb").read_bytes() == b"mine"
    dialog_of(qtbot, window).reject()


def test_a_wrong_ending_is_refused_with_those_there_are(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    window.files.save_as()
    assert type_name(qtbot, window, "work.png") == ["work.png: choose a name that ends in .gwb."]
    dialog_of(qtbot, window).reject()
    trigger(window, "export_step")
    (said,) = type_name(qtbot, window, "step.xyz")
    assert said == "step.xyz: choose a name that ends in .png, .svg or .pdf."
    dialog_of(qtbot, window).reject()
    assert names(tmp_path) == ["work.gwb"]


# Export: where it begins, and what is in it


def test_dialogs_begin_beside_the_document_with_its_name(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    for command, name in (
        ("export_picture", "work.png"),
        ("export_drawing", "work.svg"),
        ("export_step", "work-step.png"),
        ("export_hand", "work-table.csv"),
    ):
        trigger(window, command)
        dialog = dialog_of(qtbot, window)
        assert Path(dialog.selectedFiles()[0]) == tmp_path / name
        dialog.reject()
        qtbot.waitUntil(lambda dialog=dialog: not dialog.isVisible())


def test_without_a_home_dialogs_begin_here(window: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    def none() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", none)
    window.session.new()
    assert window.files.exports.writing.proposed("run", ".gif") == Path("Untitled-run.gif")


def test_the_ending_follows_the_kind_that_is_chosen(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    trigger(window, "export_step")
    dialog = dialog_of(qtbot, window)
    dialog.selectNameFilter("PDF (*.pdf)")
    dialog.filterSelected.emit("PDF (*.pdf)")
    assert Path(dialog.selectedFiles()[0]) == tmp_path / "work-step.pdf"
    assert type_name(qtbot, window, "mine") == []
    written(qtbot, window)
    assert (tmp_path / "mine.pdf").read_bytes().startswith(b"%PDF-")


def test_the_picture_has_every_pixel(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    trigger(window, "export_picture")
    type_name(qtbot, window, "p")
    assert "p.png is written" in written(qtbot, window)
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
    assert window.status.hover.text().startswith("There is no hand table yet")
    trigger(window, "export_run")
    assert window.status.hover.text().startswith("No run is recorded")
    assert not any("line" in each.title for each in window.files.exports.tables())


def test_every_table_that_is_offered_is_written(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.open_example("triangle")
    window.session.update_state(active=window.session.sheet.figures[-1].id)
    recorded(qtbot, window)
    window.session.run.go(3)
    titles = [each.title for each in window.files.exports.tables()]
    assert titles[:2] == ["Pixels in the order of painting", "Every line with its variables"]
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
        "Export the hand table...",
        "Export the points of the curve...",
        "Export another table",
    ]


# A run


def test_a_run_as_gif_has_every_step_at_the_speed_that_was_chosen(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    choose_run(window, ".gif", width=480, seconds=0.2)
    type_name(qtbot, window, "walk")
    assert "walk.gif is written" in written(qtbot, window)
    with Image.open(tmp_path / "walk.gif") as image:
        assert image.width == 480
        assert image.info["loop"] == 0
        frames = [(f.info["duration"], dict(map(reversed, f.convert("RGB").getcolors(1 << 20))))
                  for f in ImageSequence.Iterator(image)]  # fmt: skip
    assert [duration for duration, _colours in frames] == [200] * 10 + [600]
    blue = [colours.get(BLUE, 0) for _duration, colours in frames]
    assert blue == sorted(blue)
    assert 0 < 2 * blue[1] < blue[-1]


def test_a_run_as_pdf_has_a_page_for_each_step(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    choose_run(window, ".pdf")
    type_name(qtbot, window, "walk")
    written(qtbot, window)
    data = (tmp_path / "walk.pdf").read_bytes()
    assert len(re.findall(rb"/Type\s*/Page\b", data)) == 11
    assert b"/Subtype /Image" not in data


def test_frames_say_exactly_what_they_replace(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    (tmp_path / "walk-003.png").write_bytes(b"mine")
    (tmp_path / "walk-010.png").write_bytes(b"mine too")
    before = names(tmp_path)
    choose_run(window, ".png")
    assert type_name(qtbot, window, "walk") == []
    assert window.messages.text == (
        "2 of the 11 files walk-000.png to walk-010.png are there already, the first of them walk-003.png."
    )
    assert names(tmp_path) == before
    next(each for each in window.messages.buttons() if each.text() == "Replace them").click()
    assert "11 files, walk-000.png to walk-010.png, are written" in written(qtbot, window)
    assert names(tmp_path) == [*(f"walk-{k:03d}.png" for k in range(11)), "work.gwb"]
    for k in range(11):
        with Image.open(tmp_path / f"walk-{k:03d}.png") as image:
            image.load()
            assert image.width == 480


def test_cancelled_nothing_is_left(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow(monkeypatch)
    (tmp_path / "walk-003.png").write_bytes(b"mine")
    choose_run(window, ".png")
    type_name(qtbot, window, "walk")
    next(each for each in window.messages.buttons() if each.text() == "Replace it").click()
    card = window.files.exports.writing.card
    qtbot.waitUntil(lambda: card.isVisible() and card.bar.value() >= 2, timeout=10_000)
    qtbot.mouseClick(card.cancel, Qt.MouseButton.LeftButton)
    written(qtbot, window)
    assert not card.isVisible()
    assert names(tmp_path) == ["walk-003.png", "work.gwb"]
    assert (tmp_path / "walk-003.png").read_bytes() == b"mine"
    assert window.status.hover.text() == "Cancelled; walk.png was not written."


def slow(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every page takes a while."""
    from workbench.panels.stage import pages as figure_pages

    quick = figure_pages.page_image
    monkeypatch.setattr(figure_pages, "page_image", lambda *given: (time.sleep(0.15), quick(*given))[1])


def test_a_picture_that_is_changed_meanwhile_is_not_half_of_each(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from workbench.document.edits import move_figures

    slow(monkeypatch)
    choose_run(window, ".gif")
    type_name(qtbot, window, "walk")
    qtbot.waitUntil(lambda: window.files.exports.writing.card.bar.value() >= 2, timeout=10_000)
    window.session.apply(move_figures([window.session.sheet.figures[0].id], 1, 1), "Move")
    assert written(qtbot, window).startswith("The picture was changed before all its steps were written")
    assert names(tmp_path) == ["work.gwb"]


def test_the_window_does_not_close_on_what_is_being_written(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow(monkeypatch)
    choose_run(window, ".gif")
    type_name(qtbot, window, "walk")
    window.close()
    assert window.isVisible()
    assert window.messages.text == "walk.gif is still being written."
    window.menus.actions["export_picture"].trigger()
    assert window.status.hover.text() == "walk.gif is still being written."
    next(each for each in window.messages.buttons() if each.text() == "Close when it is written").click()
    qtbot.waitUntil(lambda: not window.isVisible(), timeout=10_000)
    with Image.open(tmp_path / "walk.gif") as image:
        assert image.n_frames == 11


@pytest.mark.parametrize("when", ["before", "after"])
def test_a_failed_export_does_not_close_the_window(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, when: str
) -> None:
    from workbench.document.edits import move_figures

    slow(monkeypatch)
    choose_run(window, ".gif")
    type_name(qtbot, window, "walk")
    window.close()
    window.session.apply(move_figures([window.session.sheet.figures[0].id], 1, 1), "Move")
    wish = next(each for each in window.messages.buttons() if each.text() == "Close when it is written")
    if when == "after":
        qtbot.waitUntil(lambda: not window.files.exports.writing.writer.busy, timeout=10_000)
    wish.click()
    assert written(qtbot, window).startswith("The picture was changed before all its steps were written")
    assert window.isVisible()
    assert names(tmp_path) == ["work.gwb"]


# What the disk refuses


@pytest.mark.skipif(os.name != "posix", reason="devices and pipes of POSIX")
@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("folder", "is a folder; choose another name."),
        ("pipe", "is a device, not a file; choose another name."),
        ("full", "is a device, not a file; choose another name."),
        ("long", "is too long; choose a shorter one."),
    ],
)
def test_what_is_no_file_is_left_alone(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, kind: str, said: str
) -> None:
    target = tmp_path / ("n" * 300 + ".svg" if kind == "long" else "out.svg")
    if kind == "folder":
        target.mkdir()
    elif kind == "pipe":
        os.mkfifo(target)
    elif kind == "full":
        target.symlink_to("/dev/full")
    before = names(tmp_path)
    exports = window.files.exports
    from workbench.exchange.svg_writing import write_svg
    from workbench.exchange.written import formats

    exports.writing._write(formats("drawing")[0], lambda: write_svg(window.session.sheet), target)
    assert written(qtbot, window).endswith(said)
    assert names(tmp_path) == before


def test_import_takes_what_can_be_dropped(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []

    def choose(path: Path) -> Callable[..., tuple[str, str]]:
        return lambda *given: (asked.append(given[3]), (str(path), ""))[1]

    (tmp_path / "points.txt").write_text("x y\n1 2\n20 30\n40 10\n", encoding="utf-8")
    for command in ("import", "open"):
        monkeypatch.setattr(QFileDialog, "getOpenFileName", choose(tmp_path / "points.txt"))
        points = [len(each.points_world) for each in window.session.sheet.figures]
        trigger(window, command)
        assert window.place == "curves"
        assert sum(len(each.points_world) for each in window.session.sheet.figures) == sum(points) + 3
    assert all(ending in kinds for ending in (".gwb", ".svg", ".csv", ".txt") for kinds in asked)
    sheets = window.session.document.sheets
    monkeypatch.setattr(QFileDialog, "getOpenFileName", choose(tmp_path / "work.gwb"))
    trigger(window, "import")
    assert len(window.session.document.sheets) == len(sheets) + 1
    assert window.session.sheet.figures[0].points_world[1].x == 30
    window.session.undo_stack.undo()
    assert window.session.document.sheets == sheets
