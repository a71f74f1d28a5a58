"""The glass of a tube: its faint shades have no steps that an eye could see."""

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from workbench.widgets.tube.glass import cabinet_pixmap, fitted, reflection_pixmap


def alphas(ratio: float = 1.0) -> tuple[np.ndarray, QRectF]:
    _cabinet, glass = fitted(400, 340, 0.75, 22)
    image = reflection_pixmap(400, 340, ratio, glass).toImage()
    image = image.convertToFormat(QImage.Format.Format_ARGB32)
    rows = np.frombuffer(image.constBits(), np.uint32).reshape(image.height(), image.bytesPerLine() // 4)
    return (rows >> 24).astype(int), glass


def test_the_shades_of_the_glass_are_dithered(qapp: QApplication) -> None:
    for ratio in (1.0, 2.0):
        alpha, glass = alphas(ratio)
        row = alpha[round((glass.top() + 0.25 * glass.height()) * ratio)]
        sheen = row[round((glass.left() + 20) * ratio) : round((glass.left() + 100) * ratio)]
        steps = np.diff(sheen)
        assert (steps > 0).sum() > 5  # it falls, but by no stairs
        assert (steps < 0).sum() > (steps > 0).sum()
        assert np.abs(steps).max() <= 4


def test_the_rim_is_darker_and_the_middle_is_clear(qapp: QApplication) -> None:
    alpha, glass = alphas()
    middle = alpha[round(glass.center().y()), round(glass.center().x() + 0.2 * glass.width())]
    corner = alpha[round(glass.bottom() - 14), round(glass.right() - 14)]
    assert middle == 0
    assert corner > 60
    assert alpha[2, 2] == 0


def test_tubes_of_one_size_share_their_glass_and_others_have_their_own(qapp: QApplication) -> None:
    cabinet, glass = fitted(400, 340, 0.75, 22)
    moved = glass.translated(0, 1)
    for paint in (
        lambda place, ratio=1.0: reflection_pixmap(400, 340, ratio, place),
        lambda place, ratio=1.0: cabinet_pixmap(400, 340, ratio, cabinet, place),
    ):
        one = paint(glass).cacheKey()
        assert paint(QRectF(glass)).cacheKey() == one
        assert len({one, paint(moved).cacheKey(), paint(glass, 2.0).cacheKey()}) == 3
