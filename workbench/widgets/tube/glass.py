"""The cabinet of a tube: dark bezel, bulging glass, reflection. Painted once per size and kept."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import (
    QBrush,
    QColor,
    QImage,
    QLinearGradient,
    QPainter,
    QPainterPath,
    QPen,
    QPixmap,
    QPixmapCache,
)

from workbench.display.setup import area_mm, face_mm

# The cabinet is dark in both themes: light around a picture would grey the glass.
_CABINET_TOP, _CABINET_BOTTOM = QColor("#2B2F34"), QColor("#16181B")
_LIP, _GLASS = QColor("#050607"), QColor("#080B0A")
_EDGE = QColor("#3A4047")
LETTERING = QColor("#98A1AB")

CORNER = 0.06
_BEZEL = 0.045
_BULGE = 0.018
_RIM, _SHEEN = 150.0, (22.0, 7.0, 0.0)
"""How dark the rim is, and how light the window from its corner to the middle, 0 to 255."""


def nearest_pixel(x: int, y: int, picture_px: tuple[int, int]) -> tuple[int, int]:
    """The pixel of a picture of so many pixels that is nearest to the pixel (x, y)."""
    width, height = picture_px
    return min(max(x, 0), width - 1), min(max(y, 0), height - 1)


def lit_near_the_middle(image: NDArray[np.uint32]) -> tuple[int, int] | None:
    """The lit pixel (x, y) of a picture (h, w) that is nearest to its middle; None where all are dark."""
    rows, columns = np.nonzero(image)
    if len(rows) == 0:
        return None
    height, width = image.shape
    nearest = int(np.argmin((columns - width / 2) ** 2 + (rows - height / 2) ** 2))
    return int(columns[nearest]), int(rows[nearest])


def pixel_at(place: QPointF, glass: QRectF, picture: tuple[int, int]) -> tuple[int, int] | None:
    """The pixel of a ``picture`` (width, height) that is shown at a place of the glass, if there is one."""
    width, height = face_mm(picture)
    left, bottom, right, top = area_mm(picture)
    x_mm = (place.x() - glass.left()) / glass.width() * width
    y_mm = (glass.bottom() - place.y()) / glass.height() * height
    x = int((x_mm - left) / (right - left) * picture[0] // 1)
    y = int((y_mm - bottom) / (top - bottom) * picture[1] // 1)
    return (x, y) if 0 <= x < picture[0] and 0 <= y < picture[1] else None


def fitted(width: float, height: float, aspect: float, plate: float) -> tuple[QRectF, QRectF]:
    """The cabinet and the glass inside it, centred, for a face ``aspect`` times as high as wide.

    ``plate`` is the height of the strip for lettering below the glass, in pixels.
    """
    glass_width = min((width - 4) / (1 + 2 * _BEZEL), (height - 4 - plate) / (aspect + 2 * _BEZEL))
    glass_width = max(glass_width, 16.0)
    bezel, glass_height = _BEZEL * glass_width, aspect * glass_width
    left = (width - glass_width) / 2
    top = (height - glass_height - plate - 2 * bezel) / 2 + bezel
    glass = QRectF(round(left), round(top), round(glass_width), round(glass_height))
    cabinet = glass.adjusted(-bezel, -bezel, bezel, bezel + plate)
    return cabinet, glass


def glass_path(glass: QRectF) -> QPainterPath:
    """The outline of the glass: four sides that bulge, four round corners."""
    x0, y0, x1, y1 = glass.left(), glass.top(), glass.right(), glass.bottom()
    bulge_x, bulge_y = _BULGE * glass.width(), _BULGE * glass.height()
    corner = 0.075 * glass.width()
    inner = QRectF(x0 + bulge_x, y0 + bulge_y, glass.width() - 2 * bulge_x, glass.height() - 2 * bulge_y)
    left, top, right, bottom = inner.left(), inner.top(), inner.right(), inner.bottom()
    path = QPainterPath(QPointF(left + corner, top))
    path.quadTo(QPointF((left + right) / 2, y0 - bulge_y), QPointF(right - corner, top))
    path.quadTo(QPointF(right, top), QPointF(right, top + corner))
    path.quadTo(QPointF(x1 + bulge_x, (top + bottom) / 2), QPointF(right, bottom - corner))
    path.quadTo(QPointF(right, bottom), QPointF(right - corner, bottom))
    path.quadTo(QPointF((left + right) / 2, y1 + bulge_y), QPointF(left + corner, bottom))
    path.quadTo(QPointF(left, bottom), QPointF(left, bottom - corner))
    path.quadTo(QPointF(x0 - bulge_x, (top + bottom) / 2), QPointF(left, top + corner))
    path.quadTo(QPointF(left, top), QPointF(left + corner, top))
    return path


def _blank(width: int, height: int, ratio: float) -> QPixmap:
    pixmap = QPixmap(max(1, round(width * ratio)), max(1, round(height * ratio)))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    return pixmap


def _kept(key: str, paint: Callable[[], QPixmap]) -> QPixmap:
    """What was painted under this key before, by a tube of the same size, or else is now."""
    pixmap = QPixmap()
    if not QPixmapCache.find(key, pixmap):
        pixmap = paint()
        QPixmapCache.insert(key, pixmap)
    return pixmap


def cabinet_pixmap(width: int, height: int, ratio: float, cabinet: QRectF, glass: QRectF) -> QPixmap:
    """What lies behind the picture: the cabinet and the unlit glass."""
    key = f"cabinet {width} {height} {ratio} {cabinet.getRect()} {glass.getRect()}"
    return _kept(key, lambda: _painted_cabinet(width, height, ratio, cabinet, glass))


def reflection_pixmap(width: int, height: int, ratio: float, glass: QRectF) -> QPixmap:
    """What lies over the picture: darker towards the rim, a soft window at the upper left."""
    key = f"reflection {width} {height} {ratio} {glass.getRect()}"
    return _kept(key, lambda: _painted_reflection(width, height, ratio, glass))


def _painted_cabinet(width: int, height: int, ratio: float, cabinet: QRectF, glass: QRectF) -> QPixmap:
    pixmap = _blank(width, height, ratio)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    shade = QLinearGradient(cabinet.topLeft(), cabinet.bottomLeft())
    shade.setColorAt(0.0, _CABINET_TOP)
    shade.setColorAt(1.0, _CABINET_BOTTOM)
    painter.setPen(QPen(_EDGE, 1))
    painter.setBrush(QBrush(shade))
    radius = CORNER * cabinet.width()
    painter.drawRoundedRect(cabinet.adjusted(0.5, 0.5, -0.5, -0.5), radius, radius)
    outline = glass_path(glass)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for width_px, alpha in ((9.0, 60), (6.0, 110), (3.0, 255)):
        lip = QColor(_LIP)
        lip.setAlpha(alpha)
        painter.setPen(QPen(lip, width_px))
        painter.drawPath(outline)
    below = QLinearGradient(glass.topLeft(), glass.bottomLeft())
    below.setColorAt(0.0, QColor(255, 255, 255, 0))
    below.setColorAt(0.7, QColor(255, 255, 255, 10))
    below.setColorAt(1.0, QColor(255, 255, 255, 46))
    painter.setPen(QPen(QBrush(below), 1.2))
    painter.drawPath(glass_path(glass.adjusted(-2.6, -2.6, 2.6, 2.6)))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(_GLASS)
    painter.drawPath(outline)
    painter.end()
    return pixmap


def _painted_reflection(width: int, height: int, ratio: float, glass: QRectF) -> QPixmap:
    """Rim and window are so faint that eight bits would show their steps, and so they are dithered."""
    pixmap = _blank(width, height, ratio)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    outline = glass_path(glass)
    painter.setClipPath(outline)
    around = outline.boundingRect()
    rows, columns = (max(1, round(side * ratio)) for side in (around.height(), around.width()))
    x = (np.arange(columns) + 0.5) / ratio + around.left()
    y = ((np.arange(rows) + 0.5) / ratio + around.top())[:, None]
    away = np.hypot(x - glass.center().x(), y - glass.center().y()) / (0.72 * glass.width())
    rim = np.clip((away - 0.62) / 0.38, 0.0, 1.0) * _RIM
    painter.drawImage(around, _layer(rim, 0))
    along = (x - glass.left()) * glass.width() + (y - glass.top()) * glass.height()
    share = along * 2.0 / (glass.width() ** 2 + glass.height() ** 2)
    light = np.interp(share, (0.0, 0.55, 1.0), _SHEEN)
    sheen = QPainterPath()
    sheen.moveTo(glass.topLeft())
    sheen.lineTo(glass.left() + 0.78 * glass.width(), glass.top())
    sheen.quadTo(
        QPointF(glass.left() + 0.34 * glass.width(), glass.top() + 0.2 * glass.height()),
        QPointF(glass.left(), glass.top() + 0.66 * glass.height()),
    )
    sheen.closeSubpath()
    painter.setClipPath(sheen, Qt.ClipOperation.IntersectClip)
    painter.drawImage(around, _layer(light, 255))
    painter.setClipping(False)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(QColor(0, 0, 0, 170), 2))
    painter.drawPath(outline)
    painter.end()
    return pixmap


def _layer(strength: NDArray[np.float64], grey: int) -> QImage:
    """One grey (0 or 255) as strong as these alphas (h, w), 0 to 255, dithered to whole steps."""
    noise = np.random.default_rng(1897).random(strength.shape)
    alpha = np.minimum(np.floor(strength + noise), 255).astype(np.uint32)
    packed = np.ascontiguousarray(alpha << 24 | (alpha * (grey // 255)) * 0x010101)
    rows, columns = packed.shape
    image = QImage(packed.data, columns, rows, 4 * columns, QImage.Format.Format_ARGB32_Premultiplied)
    return image.copy()
