"""Formulas in Qt's type: how wide their runs are, and how what was laid out is painted."""

from collections.abc import Callable, Iterable
from functools import lru_cache

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from workbench.exchange.formulas.layout import Area, Disc, Glyphs, Line, Primitive, Style, Typesetter
from workbench.widgets.canvas.drawing import PATTERNS
from workbench.widgets.look.tokens import colour
from workbench.widgets.look.type_faces import code_font

_KEPT = 4096


class QtMetrics:
    """The type of a widget: its own face for words, the system's fixed-width one for numbers."""

    def __init__(self, font: QFont) -> None:
        self._font = QFont(font)
        self._fonts: dict[tuple[float, Style], tuple[QFont, QFontMetricsF]] = {}
        self._widths: dict[tuple[str, float, Style], float] = {}

    def font(self, size: float, style: Style) -> QFont:
        """The font of runs of one size, logical pixels, and style; not to be changed."""
        return self._at(size, style)[0]

    def _at(self, size: float, style: Style) -> tuple[QFont, QFontMetricsF]:
        key = size, style
        if key not in self._fonts:
            pixels = max(1, round(size))
            font = code_font(pixels) if style == "figures" else QFont(self._font)
            font.setPixelSize(pixels)
            font.setHintingPreference(self._font.hintingPreference())
            font.setItalic("italic" in style)
            font.setWeight(QFont.Weight.DemiBold if "bold" in style else QFont.Weight.Normal)
            self._fonts[key] = font, QFontMetricsF(font)
        return self._fonts[key]

    def width(self, text: str, size: float, style: Style) -> float:
        """How far a run goes."""
        key = text, size, style
        width = self._widths.get(key)
        if width is None:
            if len(self._widths) > _KEPT:
                self._widths.clear()
            width = self._widths[key] = self._at(size, style)[1].horizontalAdvance(text)
        return width

    def ascent(self, size: float) -> float:
        """How far letters go up from the base line."""
        return self._at(size, "upright")[1].ascent()

    def descent(self, size: float) -> float:
        """How far letters go down from the base line."""
        return self._at(size, "upright")[1].descent()


@lru_cache(maxsize=8)
def _set_in(description: str) -> Typesetter:
    font = QFont()
    font.fromString(description)
    return Typesetter(QtMetrics(font))


def typesetter_of(font: QFont) -> Typesetter:
    """The typesetter of a font; widgets of one font share it, and what it has laid out."""
    return _set_in(font.toString())


def paint_primitives(
    painter: QPainter, primitives: Iterable[Primitive], metrics: QtMetrics, colour_of: Callable[[str], str]
) -> None:
    """Paint what was laid out with ``metrics``, in the order given; ``colour_of`` an ink is "#RRGGBB"."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    inks: dict[str, QColor] = {}
    font: QFont | None = None
    for each in primitives:
        ink = inks.get(each.ink)
        if ink is None:
            ink = inks[each.ink] = QColor(colour_of(each.ink))
        match each:
            case Glyphs():
                other = metrics.font(each.size, each.style)
                if other is not font:
                    painter.setFont(other)
                    font = other
                painter.setPen(ink)
                painter.drawText(QPointF(each.x, each.y), each.text)
            case Line():
                pen = QPen(ink, each.width, PATTERNS[each.pattern], Qt.PenCapStyle.FlatCap)
                pen.setJoinStyle(Qt.PenJoinStyle.MiterJoin)
                painter.setPen(pen)
                painter.drawPolyline(QPolygonF([QPointF(x, y) for x, y in each.points]))
            case Area():
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(colour(ink.name(), round(255 * each.share)))
                painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in each.points]))
                painter.setBrush(Qt.BrushStyle.NoBrush)
            case Disc():
                painter.setPen(QPen(ink, 0.35 * each.radius))
                painter.setBrush(QColor(colour_of("canvas")) if each.hollow else ink)
                painter.drawEllipse(QPointF(each.x, each.y), each.radius, each.radius)
                painter.setBrush(Qt.BrushStyle.NoBrush)
