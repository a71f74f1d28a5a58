"""What editors over a curve's parameter share: one axis, and a marker at u that can be dragged."""

from collections.abc import Iterable

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QFocusEvent,
    QFont,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import CAPTION_PX, colour, theme, tokens
from workbench.widgets.look.type_faces import scaled
from workbench.widgets.plots.parameter_axis import (
    GRAB_PX,
    LEFT_PX,
    NUDGES,
    RIGHT_PX,
    TICKS_PX,
    number_text,
    ticks,
)


class ParameterBar(QWidget):
    """A strip whose horizontal axis is the parameter u. ``u_dragged`` sends the u that a hand asks for.

    A press or a drag asks for the u under the pointer; so do arrows (Shift: ten times as far), Home and End.
    The u shown changes only by ``set_u``. What does not move with u is painted once and kept.
    """

    u_dragged = Signal(float)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.setMouseTracking(True)
        self._range = (0.0, 1.0)
        self._domain: tuple[float, float] | None = None
        self._u: float | None = None
        self._scrubbing = False
        self._kept: QPixmap | None = None
        theme.changed.connect(self.show_anew)

    # What is shown

    @property
    def empty(self) -> bool:
        """Whether there is nothing to plot."""
        return True

    @property
    def words(self) -> str:
        """What is said while there is nothing to plot."""
        return ""

    @property
    def reading(self) -> str:
        """What a screen reader says of it now."""
        if self.empty:
            return self.words
        return "" if self._u is None else _("u = {u}").format(u=number_text(self._u, 4))

    @property
    def range(self) -> tuple[float, float]:
        """The least and the greatest parameter shown."""
        return self._range

    def set_range(self, low: float, high: float) -> None:
        """Show the parameter from low to high."""
        wanted = (low, high) if high > low else (low - 0.5, low + 0.5)
        if wanted != self._range:
            self._range = wanted
            self.show_anew()

    @property
    def domain(self) -> tuple[float, float]:
        """Where the curve is; u stays in it."""
        return self._range if self._domain is None else self._domain

    def set_domain(self, domain: tuple[float, float] | None) -> None:
        """Where the curve is, when that is less than what is shown; what lies beyond is shaded."""
        if domain != self._domain:
            self._domain = domain
            self.show_anew()

    @property
    def u(self) -> float | None:
        """The marked parameter."""
        return self._u

    def set_u(self, u: float | None) -> None:
        """Mark a parameter; None marks none."""
        if u != self._u:
            self._u = u
            self.tell()
            self.update()

    def show_anew(self) -> None:
        """What is kept has changed: paint it anew."""
        self._kept = None
        self.tell()
        self.update()

    def tell(self) -> None:
        """Tell a screen reader what changed, when it is the one listened to."""
        if self.accessibleDescription() != self.reading:
            self.setAccessibleDescription(self.reading)
            if self.hasFocus():
                QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.DescriptionChanged))

    # Places

    @property
    def area(self) -> QRectF:
        """Where the plot lies in the widget, in logical pixels."""
        return QRectF(LEFT_PX, 6, max(1.0, self.width() - LEFT_PX - RIGHT_PX), max(1.0, self.height() - 12))

    def x_of(self, u: float) -> float:
        """The place of a parameter, in logical pixels of the widget."""
        low, high = self._range
        return self.area.left() + (u - low) / (high - low) * self.area.width()

    def u_at(self, x: float) -> float:
        """The parameter at a place of the widget, wherever it lies."""
        low, high = self._range
        return low + (x - self.area.left()) / self.area.width() * (high - low)

    def u_under(self, place: QPointF) -> float:
        """The parameter that a place of the widget asks for."""
        return self.u_at(place.x())

    def over_u(self, place: QPointF) -> bool:
        """Whether a place of the widget is over the marker at u."""
        return self._u is not None and not self.empty and abs(place.x() - self.x_of(self._u)) <= GRAB_PX

    # The hand

    def ask(self, u: float) -> None:
        """Ask for a parameter, as far as the curve goes."""
        low, high = self.domain
        wanted = min(max(u, low), high)
        if wanted != self._u:
            self.u_dragged.emit(wanted)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Ask for the u under the pointer."""
        if event.button() == Qt.MouseButton.LeftButton and not self.empty:
            self._scrubbing = True
            self.ask(self.u_under(event.position()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on asking; over the marker the pointer shows that it can be dragged."""
        if self._scrubbing:
            self.ask(self.u_under(event.position()))
        elif not event.buttons():
            shapes = Qt.CursorShape
            self.setCursor(shapes.SizeHorCursor if self.over_u(event.position()) else shapes.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Ask no more."""
        self._scrubbing = False

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows, Home and End move u."""
        low, high = self.domain
        far = (high - low) / NUDGES * (10 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1)
        here = low if self._u is None else self._u
        places = {
            Qt.Key.Key_Left: here - far,
            Qt.Key.Key_Right: here + far,
            Qt.Key.Key_Home: low,
            Qt.Key.Key_End: high,
        }
        if self.empty or event.key() not in places or not is_plain(event):
            super().keyPressEvent(event)
        else:
            self.ask(places[Qt.Key(event.key())])

    # Painting

    def sizeHint(self) -> QSize:
        """A thin plot."""
        return QSize(360, 120)

    def paint_kept(self, painter: QPainter) -> None:
        """Paint what does not move with u."""

    def paint_marks(self, painter: QPainter) -> None:
        """Paint what lies over it; the marker at u."""
        if self._u is not None:
            self.paint_u(painter, self._u)

    def paint_u(self, painter: QPainter, u: float) -> None:
        """The marker: a line with a grip at its head, and u beside it."""
        now, area = tokens(), self.area
        x = self.x_of(u)
        painter.setPen(QPen(colour(now.text), 1.5))
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))
        painter.setPen(QPen(colour(now.surface), 1.5))
        painter.setBrush(colour(now.text))
        painter.drawPolygon(
            [QPointF(x - 5.5, area.top() - 4), QPointF(x + 5.5, area.top() - 4), QPointF(x, area.top() + 6)]
        )
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def paint_axis(self, painter: QPainter) -> None:
        """Grid lines at round parameters, and a shade beyond the domain."""
        now, area = tokens(), self.area
        low, high = self._range
        painter.setPen(QPen(colour(now.grid), 1))
        painter.drawLines([QLineF(x, area.top(), x, area.bottom()) for x in self.tick_places()])
        for start, end in ((low, self.domain[0]), (self.domain[1], high)):
            if end > start:
                box = QRectF(self.x_of(start), area.top(), self.x_of(end) - self.x_of(start), area.height())
                painter.fillRect(box, colour(now.grid, 140))

    def tick_places(self) -> Iterable[float]:
        """Where the round parameters are, on whole pixels."""
        return [round(self.x_of(u)) + 0.5 for u in self.tick_values()]

    def tick_values(self) -> list[float]:
        """The round parameters on the axis."""
        return ticks(*self._range, max(2, int(self.area.width() // TICKS_PX)))

    def paintEvent(self, event: QPaintEvent) -> None:
        """What is kept, then what moves."""
        ratio = self.devicePixelRatioF()
        size = self.size() * ratio
        if self._kept is None or self._kept.size() != size:
            self._kept = QPixmap(size)
            self._kept.setDevicePixelRatio(ratio)
            self._kept.fill(colour(tokens().surface))
            painter = QPainter(self._kept)
            self._prepare(painter)
            if self.empty:
                self._say(painter)
            else:
                self.paint_kept(painter)
            painter.end()
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._kept)
        self._prepare(painter)
        if not self.empty:
            self.paint_marks(painter)
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.drawRect(QRectF(self.rect()).adjusted(1, 1, -1, -1))
        painter.end()

    def _prepare(self, painter: QPainter) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        font = QFont(self.font())
        font.setPixelSize(scaled(CAPTION_PX))
        painter.setFont(font)

    def _say(self, painter: QPainter) -> None:
        painter.setPen(colour(tokens().muted))
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        painter.drawText(QRectF(self.rect()).adjusted(12, 4, -12, -4), flags, self.words)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The focus ring appears."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The focus ring goes."""
        super().focusOutEvent(event)
        self.update()

    def changeEvent(self, event: QEvent) -> None:
        """Another font."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self.show_anew()
