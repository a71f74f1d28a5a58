"""The architecture of a raster-scan system on screen: a part lights up when it works."""

from collections.abc import Collection

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.display.scan import Scan
from workbench.language import _
from workbench.panels.display.raster.system import (
    BUS_NAME,
    HEIGHT,
    WIDTH,
    Numbers,
    Part,
    Wire,
    parts,
    told,
    wires,
)
from workbench.widgets.look.tokens import CAPTION_PX, RADIUS, colour, theme, tokens
from workbench.widgets.look.type_faces import code_font

_HEAD_PX = 5.0
_LEAST_PX = 9


class SystemView(QWidget):
    """Parts, wires and numbers, as large as there is room."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.scan: Scan | None = None
        self.now: Numbers = {}
        self.changed: frozenset[str] = frozenset()
        self.setMinimumSize(230, 190)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(_("Raster-scan system"))
        self.setToolTip(_("How a pixel comes from memory to the screen; what has just worked is lit."))
        theme.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """As it is drawn."""
        return QSize(int(WIDTH), int(HEIGHT))

    def show_numbers(self, scan: Scan | None, now: Numbers, changed: Collection[str]) -> None:
        """Show the numbers of a moment; ``changed`` are the variables that it has changed."""
        names = [name for part in parts() for name in (*part.holds, "colour") if name in now]
        state = scan, {name: now[name] for name in names}, frozenset(changed)
        if state == (self.scan, self.now, self.changed):
            return
        self.scan, self.now, self.changed = state
        said = [
            f"{part.title}: {', '.join(filter(None, told(part, scan, now)))}"
            for part in parts()
            if part.holds
        ]
        self.setAccessibleDescription("; ".join(said))
        self.update()

    def _scale(self) -> float:
        return min(self.width() / WIDTH, self.height() / HEIGHT)

    def _point(self, x: float, y: float) -> QPointF:
        scale = self._scale()
        left, top = (self.width() - WIDTH * scale) / 2, (self.height() - HEIGHT * scale) / 2
        return QPointF(left + x * scale, top + (HEIGHT - y) * scale)

    def _box(self, part: Part) -> QRectF:
        left, bottom, right, top = part.box
        return QRectF(self._point(left, top), self._point(right, bottom))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Boxes, wires, words."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        lit = {part.key for part in parts() if part.lit(self.changed)}
        for part in parts():
            self._paint_part(painter, part, part.key in lit)
        for wire in wires():
            self._paint_wire(painter, wire, wire.of in lit)
        painter.setFont(self._font(False))
        painter.setPen(colour(tokens().muted))
        painter.drawText(self._point(*BUS_NAME), _("system bus"))

    def _font(self, of_numbers: bool) -> QFont:
        pixels = max(_LEAST_PX, min(CAPTION_PX + 2, round(CAPTION_PX * self._scale())))
        font = code_font(pixels) if of_numbers else QFont(self.font())
        font.setPixelSize(pixels)
        font.setBold(of_numbers)
        return font

    def _paint_part(self, painter: QPainter, part: Part, lit: bool) -> None:
        box, theme_now = self._box(part), tokens()
        painter.setPen(QPen(colour(theme_now.accent if lit else theme_now.field_edge), 2 if lit else 1))
        painter.setBrush(colour(theme_now.selected if lit else theme_now.surface))
        painter.drawRoundedRect(box, RADIUS, RADIUS)
        lines = tuple(filter(None, told(part, self.scan, self.now)))
        plain, numbers = self._font(False), self._font(True)
        heights = [QFontMetricsF(plain).height(), *(QFontMetricsF(numbers).height() for _line in lines)]
        y = box.top() + 3 if part.encloses else box.center().y() - sum(heights) / 2
        for number, (line, height) in enumerate(zip((part.title, *lines), heights, strict=True)):
            font = numbers if number else plain
            painter.setFont(font)
            painter.setPen(colour(theme_now.text if number or lit else theme_now.muted))
            words = QFontMetricsF(font).elidedText(line, Qt.TextElideMode.ElideRight, box.width() - 6)
            row = QRectF(box.left() + 3, y, box.width() - 6, height)
            painter.drawText(row, Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignVCenter, words)
            y += height

    def _paint_wire(self, painter: QPainter, wire: Wire, lit: bool) -> None:
        ink = colour(tokens().accent if lit else tokens().field_edge)
        way = [self._point(*place) for place in wire.way]
        painter.setPen(QPen(ink, 2.4 if lit else 1.4))
        painter.drawPolyline(QPolygonF(way))
        if not wire.arrow:
            return
        tip, before = way[-1], way[-2]
        along = tip - before
        length = max((along.x() ** 2 + along.y() ** 2) ** 0.5, 1e-9)
        unit = along / length * _HEAD_PX
        across = QPointF(-unit.y(), unit.x()) * 0.6
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(ink)
        painter.drawPolygon(QPolygonF([tip, tip - unit * 1.6 + across, tip - unit * 1.6 - across]))
