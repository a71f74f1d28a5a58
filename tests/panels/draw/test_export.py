"""What leaves the Draw panel is read back: PNG, PDF with vectors, CSV, clipboard."""

import csv
import re
import zlib

import pytest
from PIL import Image
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import keep_until_the_end
from workbench.document.samples.examples import example_document
from workbench.document.storage.saving import SavingError
from workbench.exchange.tables import Table
from workbench.exchange.writing import format_for, write
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.stage.pages import formats_of
from workbench.panels.stage.picture import pixel_rows
from workbench.session.session import Session


@pytest.fixture
def panel(qtbot):
    session = Session(document=example_document())
    made = DrawPanel(session)
    keep_until_the_end(qtbot, made)
    made.resize(850, 600)
    made.show()
    session.update_state(active="f1")
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=5000)
    QApplication.processEvents()
    return made


def put(panel, kind, path):
    pages = panel.exporter.this_step() if kind == "step" else panel.exporter.this_run()
    write(format_for(formats_of(kind), path), pages, path)


def test_the_pixels_are_a_table_in_the_order_of_painting(panel, tmp_path):
    target = tmp_path / "pixels.csv"
    rows = pixel_rows(panel.session.sheet, panel.session.active_figure)
    write(format_for(formats_of("table"), target), Table(("k", "x", "y"), rows), target)
    rows = list(csv.reader(target.read_text(encoding="utf-8").splitlines()))
    assert rows[0] == ["k", "x", "y"]
    assert rows[1] == ["0", "20", "10"]
    assert rows[-1] == ["10", "30", "18"]
    assert len(rows) == 12


def test_a_run_is_one_page_per_step_with_vectors_and_no_image(panel, tmp_path):
    target = tmp_path / "run.pdf"
    put(panel, "run", target)
    data = target.read_bytes()
    assert data.startswith(b"%PDF")
    assert len(re.findall(rb"/Type\s*/Page\b", data)) == 11
    assert b"/Subtype /Image" not in data
    streams = [zlib.decompress(part) for part in re.findall(rb"stream\r?\n(.*?)\r?\nendstream", data, re.S)
               if part[:1] == b"x"]  # fmt: skip
    assert any(b" re" in stream for stream in streams)


def test_a_step_is_a_picture_of_that_step(panel, tmp_path):
    panel.session.run.go(3)
    QApplication.processEvents()
    first = tmp_path / "three.png"
    put(panel, "step", first)
    panel.session.run.last()
    QApplication.processEvents()
    last = tmp_path / "last.png"
    put(panel, "step", last)
    blue = (0x00, 0x72, 0xB2)

    def share(path):
        with Image.open(path) as image:
            colours = {value: count for count, value in image.convert("RGB").getcolors(1 << 20)}
        return colours.get(blue, 0)

    assert 0 < 2 * share(first) < share(last)


def test_a_folder_that_cannot_be_written_is_said(panel, tmp_path):
    with pytest.raises(SavingError, match=r"no folder .*missing"):
        put(panel, "run", tmp_path / "missing" / "run.pdf")


def test_the_picture_is_copied(panel):
    panel.exporter.copy_picture()
    image = QGuiApplication.clipboard().image()
    assert image.width() >= 600
