"""A cathode-ray tube cut open: its parts can be chosen, its beam be dragged where it meets the screen."""

from collections.abc import Collection

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from workbench.algorithms.numerals import with_minus
from workbench.algorithms.scanning.electron_optics import FACE_MM
from workbench.display.cutaway import (
    Box,
    Label,
    Part,
    PlacedLabel,
    Points,
    Shape,
    Span,
    beam_outline,
    clear_labels,
    ends_on_face,
    labels,
    near_labels,
    parts_of,
    shapes,
    spans,
    tangent,
    window_of,
)
from workbench.display.exposure import srgb_encoded
from workbench.display.gun import Gun, Place
from workbench.language import _
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import CAPTION_PX, RADIUS, colour, theme, tokens
from workbench.widgets.look.type_faces import scaled
from workbench.widgets.tube.gun_painting import draw_lowered, is_at, paint_height, paint_length, paint_shape

_PADDING_PX, _GAP_PX = 6.0, 6.0
_WORDINGS = ("whole", "brief", "names", "short")  # as they are tried
_NEAR_PX, _SPOT_PX = 14.0, 5.0
_LEAST_HEIGHT_PX, _BEFORE_MM = 12.0, 9.0
_FAINTEST, _STRONGEST = 50, 235
_STEP_MM, _FAR_MM = 1.0, 10.0


class GunView(QWidget):
    """``part_chosen``: a part was clicked or gone to. ``lifted``: the beam was dragged to so many millimetres
    above the axis, or moved there by a key; ``held`` tells whether it is being dragged.
    """

    part_chosen = Signal(str)
    lifted = Signal(float)
    held = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._gun = Gun()
        self._way: tuple[Place, ...] = self._gun.way()
        self._seconds: float | None = None
        self._lit: tuple[Part, ...] = ()
        self._chosen: Part | None = None
        self._labelled = True
        self._dragging = False
        self._shapes: tuple[Shape, ...] = shapes(self._gun)
        self._scale, self._cathode = 1.0, QPointF()
        self._placed: tuple[PlacedLabel, ...] = ()
        self.wording = _WORDINGS[0]
        self._asked: object = None
        self._spans: tuple[Span, ...] = ()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setMinimumSize(300, 110)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(_("Cut-away drawing of the tube"))
        theme.changed.connect(self.update)
        self._describe()

    def sizeHint(self) -> QSize:
        """The tube of the course, well seen."""
        return QSize(620, 300)

    # What is shown

    def show_gun(
        self, gun: Gun, way: tuple[Place, ...], lit: Collection[Part] = (), seconds: float | None = None
    ) -> None:
        """Show a tube and the way of its beam at a time; ``lit`` are the parts that the step is about."""
        if gun != self._gun:
            self._gun, self._shapes = gun, shapes(gun)
            self._fit()
        self._way, self._lit, self._seconds = way, tuple(lit), seconds
        if self._chosen is not None and self._chosen not in parts_of(gun):
            self._chosen = None
        self._describe()
        self.update()

    def choose(self, part: str) -> None:
        """Mark a part as the one that is spoken of."""
        chosen = next((each for each in parts_of(self._gun) if each == part), None)
        if chosen != self._chosen:
            self._chosen = chosen
            self._describe()
            self.update()

    def set_labelled(self, on: bool) -> None:
        """Name the parts, or leave the drawing bare."""
        self._labelled = on
        self.update()

    @property
    def chosen(self) -> Part | None:
        """The part that is spoken of."""
        return self._chosen

    def _describe(self) -> None:
        told = next((label for label in labels(self._gun, self._seconds) if label.part == self._chosen), None)
        words = "" if told is None else f"{told.title} {told.value}".strip()
        self.setAccessibleDescription(words)

    # Places

    def _fit(self) -> None:
        """The whole window of the tube in the middle of the widget, the same scale both ways."""
        left, low, right, high = window_of(self._gun)
        self._scale = scale = min(self.width() / (right - left), self.height() / (high - low))
        middle = QPointF(self.width(), self.height()) / 2.0
        self._cathode = middle - QPointF(left + right, -(low + high)) * (scale / 2.0)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the tube anew."""
        super().resizeEvent(event)
        self._fit()

    def place_px(self, z: float, y: float) -> QPointF:
        """Where a place (mm) is drawn."""
        return self._cathode + QPointF(z * self._scale, -y * self._scale)

    def _place_mm(self, at: QPointF) -> tuple[float, float]:
        away = (at - self._cathode) / self._scale
        return away.x(), -away.y()

    def _polygon(self, points: Points) -> QPolygonF:
        placed = points * (self._scale, -self._scale) + (self._cathode.x(), self._cathode.y())
        return QPolygonF([QPointF(x, y) for x, y in placed.tolist()])

    @property
    def spot_px(self) -> QPointF | None:
        """Where the beam meets the screen; None where it does not get so far."""
        z, _x, y, _r = self._way[-1]
        return self.place_px(z, y) if z >= self._gun.screen else None

    def part_at(self, at: QPointF) -> Part | None:
        """The part that is drawn, or named, at a place of the widget."""
        z, y = self._place_mm(at)
        if self._labelled:
            for placed in self._placed:
                left, low, right, high = placed.box
                if left <= z <= right and low <= y <= high:
                    return placed.label.part
        near = 4.0 / self._scale
        for shape in reversed(self._shapes):
            part = shape.part
            if part and is_at(shape, z, y, near):
                return part
        outline = beam_outline(self._way)
        if len(outline) and self._polygon(outline).containsPoint(at, Qt.FillRule.OddEvenFill):
            return "beam"
        return None

    # The hand

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of the spot, or choose a part."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        spot = self.spot_px
        if spot is not None and (event.position() - spot).manhattanLength() < _NEAR_PX:
            self._dragging = True
            self.held.emit(True)
            return
        part = self.part_at(event.position())
        if part is not None:
            self.choose(part)
            self.part_chosen.emit(part)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the spot along the screen."""
        spot = self.spot_px
        if self._dragging:
            self.lifted.emit(self._bounded(self._place_mm(event.position())[1]))
            return
        near = spot is not None and (event.position() - spot).manhattanLength() < _NEAR_PX
        over = near or self.part_at(event.position()) is not None
        shape = Qt.CursorShape.SizeVerCursor if near else Qt.CursorShape.PointingHandCursor
        self.setCursor(shape if over else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go of the spot."""
        if self._dragging:
            self._dragging = False
            self.held.emit(False)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Left and right go from part to part, up and down move the spot, with Shift farther."""
        along = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(Qt.Key(event.key()))
        up = {Qt.Key.Key_Up: 1.0, Qt.Key.Key_Down: -1.0}.get(Qt.Key(event.key()))
        if not is_plain(event):
            super().keyPressEvent(event)
        elif along is not None:
            self._go(along)
        elif up is not None and self.spot_px is not None:
            far = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self.lifted.emit(self._bounded(self._way[-1][2] + up * (_FAR_MM if far else _STEP_MM)))
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self._chosen is not None:
            self.part_chosen.emit(self._chosen)
        else:
            super().keyPressEvent(event)

    def _go(self, along: int) -> None:
        parts = parts_of(self._gun)
        number = parts.index(self._chosen) + along if self._chosen is not None else (0 if along > 0 else -1)
        part = parts[number % len(parts)]
        self.choose(part)
        self.part_chosen.emit(part)

    def _bounded(self, y: float) -> float:
        return min(max(y, -FACE_MM[1] / 2.0), FACE_MM[1] / 2.0)

    def event(self, event: QEvent) -> bool:
        """The tooltip names the part under the pointer."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            part = self.part_at(QPointF(event.pos()))
            told = next((label for label in labels(self._gun, self._seconds) if label.part == part), None)
            words = _("Click a part to learn what it is for; drag the spot on the screen.")
            QToolTip.showText(
                event.globalPos(), words if told is None else f"{told.title} {told.value}", self
            )
            return True
        return super().event(event)

    # Painting

    def paintEvent(self, event: QPaintEvent) -> None:
        """Glass, parts, beam, lengths, labels."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        font = QFont(self.font())
        font.setPixelSize(scaled(CAPTION_PX))
        painter.setFont(font)
        glow = self._glow()
        for shape in self._shapes:
            outline = self._polygon(shape.points)
            paint_shape(painter, outline, shape, self._is_lit(shape.part), glow, tokens())
        self._paint_beam(painter)
        if self._labelled:
            for span in spans(self._gun):
                start, end = self.place_px(span.start, span.y), self.place_px(span.end, span.y)
                paint_length(painter, start, end, span.name, tokens())
            self._paint_height(painter)
            self._paint_labels(painter, QFontMetricsF(font))
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(1, 1, -1, -1), RADIUS, RADIUS)

    def _is_lit(self, part: str) -> bool:
        return part == self._chosen or part in self._lit

    def _glow(self) -> QColor:
        """The phosphor's colour, of several layers that which lasts."""
        linear = np.max([gun.colours[-1][1] for gun in self._gun.phosphors], axis=0)
        red, green, blue = (round(255 * float(value)) for value in srgb_encoded(linear))
        shown = QColor(red, green, blue)
        return shown if tokens().dark else shown.darker(150)

    def _paint_beam(self, painter: QPainter) -> None:
        outline = beam_outline(self._way)
        if not len(outline):
            return
        share = min(self._gun.beam_current / max(self._gun.current, 1e-9), 1.0)
        strong = round(_FAINTEST + (_STRONGEST - _FAINTEST) * share**0.5)
        ink = ink_of(tokens(), "accent" if self._is_lit("beam") else "data5")
        painter.setPen(QPen(colour(ink, strong), 1.0))
        painter.setBrush(colour(ink, strong))
        painter.drawPolygon(self._polygon(outline))
        line = tangent(self._gun, self._way)
        if len(line) and self._labelled:
            painter.setPen(QPen(colour(tokens().text, 150), 1, Qt.PenStyle.DashLine))
            painter.drawPolyline(self._polygon(line))
        spot = self.spot_px
        if spot is not None and ends_on_face(self._gun, self._way):
            painter.setPen(QPen(colour(tokens().text), 1.4))
            painter.setBrush(self._glow())
            painter.drawEllipse(spot, _SPOT_PX, _SPOT_PX)
        else:
            painter.setPen(QPen(colour(tokens().error), 2))
            at = self.place_px(self._way[-1][0], self._way[-1][2])
            painter.drawLine(at + QPointF(-4, -4), at + QPointF(4, 4))
            painter.drawLine(at + QPointF(-4, 4), at + QPointF(4, -4))

    def _paint_height(self, painter: QPainter) -> None:
        """y, from the axis to the spot."""
        z, _x, y, _r = self._way[-1]
        if z >= self._gun.screen and abs(y) * self._scale >= _LEAST_HEIGHT_PX:
            foot, tip = self.place_px(z - _BEFORE_MM, 0.0), self.place_px(z - _BEFORE_MM, y)
            paint_height(painter, foot, tip, with_minus(f"y = {y:.1f} mm"), tokens())

    def _size_of(self, metrics: QFontMetricsF, label: Label, wording: str) -> tuple[float, float]:
        """Width and height of a label's box in millimetres, in one of ``_WORDINGS``."""
        lines = lines_of(label, wording)
        wide = max(map(metrics.horizontalAdvance, lines)) + 2 * _PADDING_PX
        return wide / self._scale, (len(lines) * metrics.height() + _PADDING_PX) / self._scale

    def _room(self) -> Box:
        """The whole widget in millimetres of the drawing, but for the lines around its outermost labels."""
        left, top = (1.0 - self._cathode.x()) / self._scale, (self._cathode.y() - 1.0) / self._scale
        wide, tall = ((extent - 2.0) / self._scale for extent in (self.width(), self.height()))
        return left, top - tall, left + wide, top

    def _place_labels(self, metrics: QFontMetricsF) -> None:
        """With names and what parts are set to, or where that is too much shorter names, or names alone."""
        told, gap, room = labels(self._gun, self._seconds), _GAP_PX / self._scale, self._room()
        gun = self._gun
        sizes = {
            wording: {label: self._size_of(metrics, label, wording) for label in told}
            for wording in _WORDINGS
        }
        asked = self._scale, self.size(), gun.coils, gun.gap, [[*each.values()] for each in sizes.values()]
        if asked == self._asked:  # as large as they were, they stay where they are
            of_part = {label.part: label for label in told}
            self._placed = tuple(each._replace(label=of_part[each.label.part]) for each in self._placed)
            return
        self._asked = asked
        for place in (clear_labels, near_labels):
            for wording in _WORDINGS:
                self._placed = place(told, gun, sizes[wording].__getitem__, gap, room)
                self.wording = wording
                if len(self._placed) == len(told):
                    return

    def _paint_labels(self, painter: QPainter, metrics: QFontMetricsF) -> None:
        now = tokens()
        self._place_labels(metrics)
        for placed in self._placed:
            lit = self._is_lit(placed.label.part)
            painter.setPen(QPen(colour(now.accent if lit else now.muted), 1))
            start, end = placed.leader
            painter.drawLine(self.place_px(*start), self.place_px(*end))
        for placed in self._placed:
            lit = self._is_lit(placed.label.part)
            left, low, right, high = placed.box
            box = QRectF(self.place_px(left, high), self.place_px(right, low))
            painter.setPen(QPen(colour(now.accent if lit else now.line), 1))
            painter.setBrush(colour(now.selected if lit else now.raised))
            painter.drawRoundedRect(box, 4, 4)
            at = box.adjusted(_PADDING_PX, _PADDING_PX / 2, 0, 0)
            for number, line in enumerate(lines_of(placed.label, self.wording)):
                painter.setPen(colour(now.muted if number else now.text))
                base = at.top() + number * metrics.height() + metrics.ascent()
                draw_lowered(painter, QPointF(at.left(), base), line)


def lines_of(label: Label, wording: str) -> list[str]:
    """What a label says in one of the wordings: its name or a short one, and what its part is set to."""
    name = label.title if wording in ("whole", "names") else label.short
    value = label.value if wording in ("whole", "brief") else ""
    return [line for line in (name, value) if line]
