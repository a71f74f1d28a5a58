"""Cells are crisp at every scale of the screen, wherever in a window the canvas lies."""

import os
import subprocess
import sys

import pytest

SCRIPT = """
import numpy as np
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget
application = QApplication([])
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.tokens import tokens
window = QWidget()
column = QVBoxLayout(window)
column.setContentsMargins(5, 7, 3, 9)
canvas = PixelCanvas()
column.addWidget(canvas)
window.resize(523, 401)
picture = np.zeros((28, 40), np.uint32)
picture[::3, ::2] = 0x0072B2
canvas.set_picture(picture, 0)
window.show()
application.processEvents()
image = window.grab().toImage()
unit = canvas.devicePixelRatioF()
left, top, side = canvas.view.cell_box(0, 27)
x0, y0 = round(canvas.x() * unit) + left, round(canvas.y() * unit) + top
width, height = 40 * round(canvas.view.cell), 28 * round(canvas.view.cell)
places = [(x0 + 1 + i, y0 + 1 + j) for i in range(width - 2) for j in range(height - 2)]
seen = {image.pixelColor(x, y).name().upper() for x, y in places}
now = tokens()
assert canvas.view.cell == round(canvas.view.cell) >= 8
assert seen == {now.canvas, now.grid, now.grid_strong, "#0072B2"}, seen
sides = set()
for j in range(height - 2):
    if image.pixelColor(x0 + side // 2, y0 + 1 + j).name().upper() == "#0072B2":
        sides.add(j // side)
assert len(sides) == 10, sides
"""


@pytest.mark.parametrize("scale", ["1", "1.25", "1.5", "2"])
def test_no_blended_colour_inside_the_picture(scale):
    environment = {**os.environ, "QT_SCALE_FACTOR": scale, "QT_QPA_PLATFORM": "offscreen"}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
