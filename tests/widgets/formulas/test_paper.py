"""The PDF of a derivation, and the type that it and the screen share."""

import re
import zlib

import numpy as np
import pytest
from PySide6.QtGui import QColor, QFont, QImage, QPainter

from workbench.algorithms.marks import INKS, Spot, Stroke, along
from workbench.exchange.diagrams import Axes, Derivation, Drawing, Formulas, Heading, lay_out_derivation
from workbench.exchange.formulas.layout import Glyphs, Typesetter
from workbench.exchange.formulas.terms import matrix
from workbench.exchange.writing import of_kind, write
from workbench.panels.stage.pages import ROWS
from workbench.widgets.formulas.paper import paper_inks, write_pdf
from workbench.widgets.formulas.typesetting import QtMetrics, paint_primitives

DERIVATION = Derivation(
    "Turn",
    (
        Heading("Turn by $theta$"),
        Drawing((0, 0, 4, 2), [Axes(), Stroke(along((0, 0), (3, 2)), "data2", "bold"), Spot(2, 1, "data1")]),
        Formulas((matrix([[0.5, -1], [1, 0.5]], name="R(theta)"),)),
    ),
    paper_inks(),
)


@pytest.mark.usefixtures("qapp")
def test_the_pdf_is_one_page_as_large_as_what_is_on_it():
    data = write_pdf(DERIVATION)
    assert data.startswith(b"%PDF-")
    assert len(re.findall(rb"/Type /Page\b", data)) == 1
    box = re.search(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)", data)
    laid = lay_out_derivation(DERIVATION, Typesetter(QtMetrics(QFont())))
    assert float(box[1]) == pytest.approx(laid.width, abs=1)
    assert float(box[2]) == pytest.approx(laid.height, abs=1)


@pytest.mark.usefixtures("qapp")
def test_the_pdf_holds_the_colours_as_shapes_not_as_an_image():
    data = write_pdf(DERIVATION)
    assert b"/Subtype /Image" not in data
    pages = []
    for start in re.finditer(rb"stream\r?\n", data):
        try:
            pages.append(zlib.decompressobj().decompress(data[start.end() :]))
        except zlib.error:
            continue
    set_inks = re.findall(rb"([\d.]+) ([\d.]+) ([\d.]+) (?:SCN|scn|RG|rg)\b", b" ".join(pages))
    used = np.array(set_inks, float)
    for ink in ("data1", "data2", "muted", "text"):
        colour = QColor(DERIVATION.ink(ink))
        away = np.abs(used - [colour.redF(), colour.greenF(), colour.blueF()]).max(axis=1)
        assert away.min() < 1e-3, ink


@pytest.mark.usefixtures("qapp")
def test_what_is_painted_covers_its_place_in_its_ink():
    metrics = QtMetrics(QFont())
    laid = lay_out_derivation(DERIVATION, Typesetter(metrics))
    image = QImage(round(laid.width), round(laid.height) + 1, QImage.Format.Format_RGB32)
    image.fill(QColor("white"))
    painter = QPainter(image)
    paint_primitives(painter, laid.primitives, metrics, DERIVATION.ink)
    painter.end()
    pixels = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1, 4)[..., :3]
    for glyphs in (each for each in laid.primitives if isinstance(each, Glyphs) and each.text.strip()):
        top, left = int(glyphs.y - glyphs.size), int(glyphs.x)
        part = pixels[top : int(glyphs.y) + 3, left : int(glyphs.x + glyphs.width) + 1]
        assert part.min() < 150, glyphs.text


def test_paper_has_a_colour_for_every_ink():
    assert set(paper_inks()) == set(INKS)


@pytest.mark.usefixtures("qapp")
def test_a_derivation_is_written_as_either(tmp_path):
    assert [row.suffix for row in of_kind(ROWS, "derivation")] == [".svg", ".pdf"]
    for row in of_kind(ROWS, "derivation"):
        (path,) = write(row, DERIVATION, tmp_path / f"turn{row.suffix}")
        assert path.stat().st_size > 1000
