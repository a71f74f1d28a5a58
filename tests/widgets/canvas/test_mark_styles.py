"""What marks name has a look: every weight and size a width, every ink a colour, in both themes."""

from typing import get_args

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from workbench.algorithms import marks
from workbench.widgets.canvas.drawing import Marker, PenStroke, Tint, ink_of
from workbench.widgets.canvas.mark_styles import sized
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.view import centred
from workbench.widgets.look.tokens import DARK, LIGHT

SIDE = np.array([(0.0, 0.0), (9.0, 0.0)])


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
def test_every_ink_is_a_colour_of_its_own(theme):
    colours = [ink_of(theme, ink) for ink in marks.INKS]
    assert all(len(each) == 7 and each.startswith("#") for each in colours)
    assert len(set(colours)) >= len(colours) - 1


def test_what_counts_more_is_wider():
    order = ("hair", "thin", "medium", "bold", "heavy")
    assert {*order, "pixel"} == set(get_args(marks.Weight))
    widths = [sized(marks.Stroke(SIDE, weight=weight), 20).width for weight in order]
    assert widths == sorted(set(widths))
    sizes = [sized(marks.Spot(0, 0, size=size), 20).size for size in ("small", "medium", "large")]
    assert sizes == sorted(set(sizes))
    assert {"small", "medium", "large", "pixel"} == set(get_args(marks.Size))


@pytest.mark.parametrize("cell", [1.0, 3.0, 9.0, 40.0])
def test_what_marks_a_pixel_leaves_some_of_it_to_be_seen(cell):
    assert sized(marks.Stroke(SIDE, weight="pixel"), cell).width <= max(cell / 2, 0.5)
    assert sized(marks.Spot(0, 0, size="pixel"), cell).size <= max(cell / 2, 2.0)


def test_nothing_else_of_a_mark_is_changed():
    stroke = sized(marks.Stroke(SIDE, "data4", "bold", "dot"), 8)
    assert (stroke.ink, stroke.pattern, stroke.haloed) == ("data4", "dot", True)
    assert stroke.points is SIDE
    assert sized(marks.Region(SIDE, "warn"), 8).ink == "warn"
    spot = sized(marks.Spot(1, 2, "error", "cross"), 8)
    assert (spot.x, spot.y, spot.ink, spot.shape) == (1, 2, "error", "cross")
    assert sized(marks.Word("a", 1, 2, "muted", 1, -1, True, True), 8) == marks.Word(
        "a", 1, 2, "muted", 1, -1, True, True
    )
    for each in (PenStroke(SIDE), Tint(SIDE), Marker(0, 0), marks.Word("a", 0, 0)):
        assert sized(each, 8) is each


def test_fine_lines_have_no_halo_that_would_break_what_they_cross():
    assert not sized(marks.Stroke(SIDE, weight="hair"), 8).haloed
    assert not sized(marks.Stroke(SIDE, weight="thin", pattern="dash"), 8).haloed
    assert sized(marks.Stroke(SIDE, weight="thin"), 8).haloed


def test_a_ray_without_a_picture_is_refused():
    with pytest.raises(ValueError, match="edge of a picture"):
        sized(marks.Ray(0, 0, 1, 0), 8)


def test_what_marks_a_pixel_follows_the_zoom(qtbot):
    canvas = PixelCanvas()
    qtbot.addWidget(canvas)
    canvas.resize(240, 170)
    canvas.show()
    canvas.set_picture(np.full((9, 9), 0xFFFFFF, np.uint32), 0xFFFFFF)
    canvas.set_overlay(Overlay(drawn=(marks.Spot(4.0, 4.0, "error", "dot", "pixel"),)))
    counts = []
    for cell in (4, 14):
        canvas._show(centred(canvas.area, 9, 9, cell))
        QApplication.processEvents()
        image = canvas.grab_picture()
        colours = [image.pixelColor(x, y) for x in range(image.width()) for y in range(image.height())]
        counts.append(sum(colour.name().upper() == LIGHT.error for colour in colours))
    assert 0 < counts[0] < counts[1]
