"""Runs are written beside the window: every step, until cancelled or refused."""

import os
import re
import time
from pathlib import Path

import pytest
from PIL import Image, ImageSequence
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import type_name
from tests.shell.exports.exporting import BLUE, names, trigger, written
from workbench.shell.window import MainWindow

# The offscreen platform says so of every dialog and menu.
pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


def choose_run(window: MainWindow, suffix: str, width: int = 480, seconds: float = 0.5) -> None:
    """Export this run: choose on the card and go on to the dialog."""
    trigger(window, "export_run")
    card = window.files.exports.writing.card
    suffixes = [card.kind.itemData(k).suffix for k in range(card.kind.count())]
    card.kind.setCurrentIndex(suffixes.index(suffix))
    card.width_px.setCurrentIndex(card.width_px.findData(width))
    card.speed.setCurrentIndex(card.speed.findData(seconds))
    card.go.click()


def test_a_run_as_gif_has_every_step_at_the_speed_that_was_chosen(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    choose_run(window, ".gif", width=480, seconds=0.2)
    type_name(qtbot, window, "walk")
    assert "walk.gif has been written" in written(qtbot, window)
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


@pytest.mark.parametrize("command", ["export_run", "export_hand"])
def test_steps_that_are_asked_for_first_are_said_to_be_kept_back(
    qtbot: QtBot, window: MainWindow, command: str
) -> None:
    run, card = window.session.run, window.files.exports.writing.card
    run.go(0)
    run.set_ask_first(True)
    trigger(window, command)
    assert window.status.hover.text() == (
        "The steps are kept back while Ask first is on; answer the first one, or switch Ask first off."
    )
    assert not card.isVisible()
    run.set_ask_first(False)
    trigger(window, "export_run")
    assert card.isVisible()


def test_frames_say_exactly_what_they_replace(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    (tmp_path / "walk-003.png").write_bytes(b"mine")
    (tmp_path / "walk-010.png").write_bytes(b"mine too")
    before = names(tmp_path)
    choose_run(window, ".png")
    assert type_name(qtbot, window, "walk") == []
    assert window.messages.text == (
        "2 of the 11 files walk-000.png to walk-010.png already exist, the first of them walk-003.png."
    )
    assert names(tmp_path) == before
    next(each for each in window.messages.buttons() if each.text() == "Replace them").click()
    assert "11 files, walk-000.png to walk-010.png, have been written" in written(qtbot, window)
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
    assert written(qtbot, window).startswith("The picture changed before all its steps were written")
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
    assert written(qtbot, window).startswith("The picture changed before all its steps were written")
    assert window.isVisible()
    assert names(tmp_path) == ["work.gwb"]


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
