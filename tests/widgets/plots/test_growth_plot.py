"""Curves of growth: both scales logarithmic, the powers told."""

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPixmap
from pytestqt.qtbot import QtBot

from workbench.widgets.plots.growth_plot import GrowthCurve, GrowthPlot

CURVES = [
    GrowthCurve("Painter's algorithm", [(10, 1e-4), (100, 1e-3)], 1.0),
    GrowthCurve("A-buffer", [(10, 1e-1), (100, 1e-3)], -2.0),
    GrowthCurve("Back faces", [(10, 1e-5)], None),
]


def test_lines_are_laid_over_logarithms_and_the_one_spoken_of_is_told_first(qtbot: QtBot) -> None:
    plot = GrowthPlot()
    qtbot.addWidget(plot)
    plot.resize(400, 240)
    plot.show()
    assert "Measure the times" in plot.caption.text()
    plot.show_curves(CURVES, "n pixels", "Painter's algorithm")
    qtbot.waitUntil(lambda: plot._plot is not None, timeout=20_000)
    x, y = plot._lines[0].getData()
    assert np.allclose(x, [1.0, 2.0])
    assert np.allclose(y, [-1.0, 0.0])  # milliseconds
    assert plot.accessibleDescription() == "Painter's algorithm n^1.00; A-buffer n^−2.00; Back faces"
    numbers = plot.numbers()
    assert numbers is not None
    assert numbers.rows[0] == ("Painter's algorithm", 10, "0.1")


def test_a_low_plot_is_numbered_by_powers_of_ten_and_no_number_covers_another(qtbot: QtBot) -> None:
    plot = GrowthPlot()
    qtbot.addWidget(plot)
    plot.resize(440, 130)
    plot.show()
    points = [(n, n * 1e-7) for n in (1536, 6144, 38400, 153600)]
    plot.show_curves([GrowthCurve("Depth buffer", points, 1.0)], "n pixels", "Depth buffer")
    qtbot.waitUntil(lambda: plot._plot is not None, timeout=20_000)
    numbers: list[tuple[QRectF, str]] = []

    def are_laid() -> bool:
        picture = QPixmap(440, 130)
        painter = QPainter(picture)
        specs = plot._plot.getAxis("bottom").generateDrawSpecs(painter)
        painter.end()
        numbers[:] = [(QRectF(rect), text) for rect, _flags, text in specs[2]] if specs else []
        return [text for _rect, text in numbers] == ["10⁴", "10⁵"]

    qtbot.waitUntil(are_laid)
    assert not numbers[0][0].intersects(numbers[1][0])
    assert "●</span>&nbsp;Depth&nbsp;buffer&nbsp;n<sup>" in plot.caption.text()


def test_every_line_has_its_name_and_a_look_of_its_own_and_decades_have_numbers(qtbot: QtBot) -> None:
    plot = GrowthPlot()
    qtbot.addWidget(plot)
    plot.resize(460, 260)
    plot.show()
    curves = [
        GrowthCurve(f"Method {k}", [(6000, 3e-4 * (k + 1)), (40000, 7e-4 * (k + 1))], None) for k in range(10)
    ]
    plot.show_curves(curves, "n pixels", "Method 3")
    qtbot.waitUntil(lambda: plot._plot is not None, timeout=20_000)
    looks = set()
    for line in plot._lines:
        pen, symbol = line.opts["pen"], line.opts["symbol"]
        looks.add((pen.color().name(), pen.style()))
        looks.add(symbol)
    assert len(looks) == 20
    assert all(curve.name.replace(" ", "&nbsp;") in plot.caption.text() for curve in curves)

    def numbers() -> list[str]:
        picture = QPixmap(460, 260)
        painter = QPainter(picture)
        specs = plot._plot.getAxis("left").generateDrawSpecs(painter)
        painter.end()
        return [text for _rect, _flags, text in specs[2]] if specs else []

    qtbot.waitUntil(lambda: len(numbers()) >= 2)
    assert numbers() == ["0.1", "1", "10¹"]
