"""The rulers of a canvas: kept while only the pointer moves, and painted as if they were not."""

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter

from workbench.widgets.canvas import rulers
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.painter import Scene
from workbench.widgets.canvas.rulers import Rulers, paint_rulers, ruler_sizes
from workbench.widgets.canvas.view import Area, CanvasView, label_step
from workbench.widgets.look.tokens import DARK, LIGHT

WIDE, HIGH = 460, 340


@pytest.fixture(scope="module", autouse=True)
def _application(qapp):
    return qapp


def scene_of(cell, left, bottom, unit=1.0, tokens=LIGHT, size=(200, 150)):
    font = QFont("DejaVu Sans", 10)
    ruler_width, ruler_height = ruler_sizes(font, size, unit)
    area = Area(ruler_width, 0, WIDE, HIGH - ruler_height)
    return Scene(area, CanvasView(cell, left, bottom), size, tokens, unit, font, Overlay())


def blank():
    image = QImage(WIDE, HIGH, QImage.Format.Format_RGB32)
    image.fill(QColor("#ff00ff"))
    return image


def by(kept, scene, pointed):
    image = blank()
    painter = QPainter(image)
    kept.paint(painter, scene, pointed)
    painter.end()
    return image


def number_by_number(scene, pointed):
    """Every number written in its place, one after the other, but those too near the emphasised ones."""
    image = blank()
    painter = QPainter(image)
    metrics, unit, cell = QFontMetricsF(scene.caption()), scene.unit, scene.view.cell
    widest = metrics.horizontalAdvance(str(max(scene.size)))
    seen = scene.view.visible(scene.area, *scene.size)
    for k, ruler in enumerate(rulers._rulers(scene)):
        ruler._paint_ground(painter)
        if seen is None:
            continue
        between, room = (
            (widest + 10 * unit, widest + 4 * unit) if k else (metrics.height() + 6 * unit, metrics.height())
        )
        first, last = seen[:2] if k else seen[2:]
        here = pointed[0 if k else 1]
        pointed_at = first <= here <= last
        step = label_step(cell, between)
        for n in range(first, last + 1):
            if n % step == 0 and not (pointed_at and abs(n - here) * cell < room):
                ruler._write(painter, [n])
        if pointed_at:
            ruler._write(painter, [here], strong=True)
    painter.end()
    return image


@settings(max_examples=40, deadline=None)
@given(
    st.sampled_from([0.5, 1, 3, 5, 8, 16, 40]),
    st.integers(-500, 100),
    st.integers(100, 900),
    st.sampled_from([1.0, 1.5, 2.0]),
    st.lists(st.tuples(st.integers(0, 199), st.integers(0, 149)), min_size=1, max_size=6),
)
def test_kept_rulers_are_those_that_are_written_number_by_number(cell, left, bottom, unit, cells):
    scene, kept = scene_of(cell, left, bottom, unit), Rulers()
    for pointed in cells:
        assert by(kept, scene, pointed) == number_by_number(scene, pointed)
    direct = blank()
    painter = QPainter(direct)
    paint_rulers(painter, scene)
    painter.end()
    assert by(kept, scene, None) == direct


def test_the_numbers_are_painted_once_while_only_the_pointer_moves(monkeypatch):
    painted = []
    paint = rulers._Ruler.paint
    monkeypatch.setattr(
        rulers._Ruler, "paint", lambda self, painter: (painted.append(1), paint(self, painter))
    )
    kept, scene = Rulers(), scene_of(5, 40, 330)
    for x in range(20):
        by(kept, replace(scene, overlay=Overlay(right=((x, 1),))), (x, x))
    assert len(painted) == 2
    by(kept, replace(scene, tokens=DARK), (1, 1))
    by(kept, scene_of(6, 40, 330), (1, 1))
    assert len(painted) == 6


def test_a_cell_that_stays_pointed_at_is_emphasised_once(monkeypatch):
    numbers = []
    emphasise = rulers._Ruler.emphasise
    monkeypatch.setattr(
        rulers._Ruler,
        "emphasise",
        lambda self, painter, number: (numbers.append(number), emphasise(self, painter, number)),
    )
    kept, scene = Rulers(), scene_of(5, 40, 330)
    for x in range(20):
        by(kept, replace(scene, overlay=Overlay(right=((x, 1),))), (7, 12))
    assert sorted(numbers) == [7, 12]
    by(kept, scene, (7, 13))
    assert sorted(numbers) == [7, 12, 13]
    by(kept, replace(scene, tokens=DARK), (7, 13))
    assert sorted(numbers) == [7, 7, 12, 13, 13]


def test_how_large_rulers_are_is_measured_once_for_each_font(monkeypatch):
    ruler_sizes.cache_clear()
    measured = []
    monkeypatch.setattr(rulers, "QFontMetricsF", lambda font: (measured.append(1), QFontMetricsF(font))[1])
    for _move in range(5):
        assert ruler_sizes(QFont("DejaVu Sans", 10), (200, 150), 1.0) == ruler_sizes(
            QFont("DejaVu Sans", 10), (200, 150), 1.0
        )
    assert len(measured) == 1
    ruler_sizes(QFont("DejaVu Sans", 14), (200, 150), 1.0)
    ruler_sizes(QFont("DejaVu Sans", 10), (200, 1500), 1.0)
    assert len(measured) == 3
