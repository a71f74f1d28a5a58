"""What plots of a curve share: a parameter u marked in them, asked for by a drag or by keys."""

from typing import Any

from PySide6.QtCore import QEvent, QObject, QPointF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QAccessible, QAccessibleEvent, QMouseEvent, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.widgets.look.tips import plain_tip
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.plots.parameter_axis import NUDGES, RIGHT_PX, ROW_PX, number_text
from workbench.widgets.plots.plot import Plot

LINE_PX = 1.5
_SPOT_PX = 8


class ScrubbedPlot(Plot):
    """``u_dragged`` sends the u that a hand asks for; the u marked changes only by ``set_u``.

    A press or a drag asks for the u under the pointer; so do arrows (Shift: ten times as far), Home and End.
    Shift with a drag pans, as the middle button does.
    """

    u_dragged = Signal(float)
    head_px = ROW_PX  # room above the plot, for the reading
    marked_by_line = True

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(name, parent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._whole = (0.0, 1.0)
        self._domain: tuple[float, float] | None = None
        self._scrubbing = False
        self._spots: Any = None
        self._column.setContentsMargins(0, self.head_px, 0, 0)
        self.caption.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.caption.setContentsMargins(12, 4, 12, 4)
        self._show_whether_empty()

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
        return "" if self.u is None else _("u = {u}").format(u=number_text(self.u, 4))

    @property
    def heading(self) -> str:
        """What stands above the plot."""
        return self.reading

    @property
    def domain(self) -> tuple[float, float]:
        """Where the curve is; u stays in it."""
        return self._whole if self._domain is None else self._domain

    @property
    def reach(self) -> tuple[float, float] | None:
        """The domain."""
        return None if self.empty else self.domain

    @property
    def nudge(self) -> float:
        """A hundredth of the domain."""
        return (self.domain[1] - self.domain[0]) / NUDGES

    @property
    def u(self) -> float | None:
        """The marked parameter."""
        return self._cursor_x

    def set_u(self, u: float | None) -> None:
        """Mark a parameter; None marks none."""
        if u != self.u:
            self.place_cursor(u)
            self._mark()
            self.tell()

    def place_cursor(self, x: float | None) -> None:
        """The line at u, where a line marks it."""
        super().place_cursor(x)
        if self._cursor_line is not None and not self.marked_by_line:
            self._cursor_line.hide()

    def tell(self) -> None:
        """Say what changed above the plot, and to a screen reader when it is the one listened to."""
        if self.accessibleDescription() != self.reading:
            self.setAccessibleDescription(self.reading)
            if self.hasFocus():
                QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.DescriptionChanged))
        self.update(0, 0, self.width(), self.head_px)

    def show_anew(self) -> None:
        """What is plotted has changed."""
        self._show_whether_empty()
        if self._plot is not None:
            self._plot.setVisible(not self.empty)
            if not self.empty:
                self._draw()
                self._mark()
                self._plot.scene().prepareForPaint()  # else the painting does, and is repeated for it
        self.tell()

    def _show_whether_empty(self) -> None:
        self.caption.setVisible(self.empty)
        if self.empty:
            self.caption.setText(self.words)
            self.caption.setToolTip(plain_tip(self.words))

    def _draw(self) -> None:
        """Plot it all; the plot is there and there is something to plot."""

    def _mark(self) -> None:
        """Mark what is at u, beside the line; there may be no plot yet."""

    def _begin(self) -> None:
        import pyqtgraph

        item = self._plot.getPlotItem()
        item.layout.setContentsMargins(0, 0, RIGHT_PX, 0)
        item.layout.setSpacing(0)
        for side in ("left", "bottom"):
            self._plot.getAxis(side).setStyle(hideOverlappingLabels=False)  # those at the very ends
        self._cursor_line.addMarker("v", 0.96, 10)
        self._spots = pyqtgraph.ScatterPlotItem(size=_SPOT_PX)
        self._spots.setZValue(2)
        self._lay(self._spots)
        self._plot.viewport().installEventFilter(self)

    def _restyle(self) -> None:
        self.show_anew()

    # Places

    @property
    def area(self) -> QRectF:
        """Where the plot lies in the widget, in logical pixels."""
        raise NotImplementedError

    def u_under(self, place: QPointF) -> float:
        """The parameter that a place of the widget asks for."""
        raise NotImplementedError

    def over_u(self, place: QPointF) -> bool:
        """Whether a place of the widget is over what marks u."""
        raise NotImplementedError

    # The hand

    def _chosen(self, x: float) -> None:
        if x != self.u:
            self.u_dragged.emit(x)

    def _point_at(self, place: QPointF | None) -> None:
        """The pointer is there, with no button down; None: it has left."""
        if place is not None:
            shapes = Qt.CursorShape
            self._plot.viewport().setCursor(
                shapes.SizeHorCursor if self.over_u(place) else shapes.ArrowCursor
            )

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A plain left drag over the plot asks for u; whatever else is done there is the library's."""
        if event.type() == QEvent.Type.Leave:
            self._point_at(None)
        return isinstance(event, QMouseEvent) and self._scrub(event)

    def _scrub(self, event: QMouseEvent) -> bool:
        kinds, left = QEvent.Type, Qt.MouseButton.LeftButton
        place = event.position() + QPointF(self._plot.pos())
        if event.type() == kinds.MouseMove and self._scrubbing:
            self._choose(self.u_under(place))
            return True
        if event.type() == kinds.MouseMove and not event.buttons():
            self._point_at(place)
            return False
        if event.button() != left or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            return False
        self._scrubbing = event.type() == kinds.MouseButtonPress
        if self._scrubbing:
            self.setFocus(Qt.FocusReason.MouseFocusReason)
            self._choose(self.u_under(place))
        elif event.type() == kinds.MouseButtonDblClick:
            self.show_all()
        return True

    # Painting

    def resizeEvent(self, event: QResizeEvent) -> None:
        """What is placed by pixels is placed anew."""
        super().resizeEvent(event)
        self.show_anew()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The heading, above the plot."""
        super().paintEvent(event)
        if self.heading and not self.empty:
            painter = QPainter(self)
            painter.setFont(self._font())
            painter.setPen(colour(tokens().muted))
            box = QRect(6, 0, self.width() - 6 - RIGHT_PX, self.head_px)
            said = painter.fontMetrics().elidedText(self.heading, Qt.TextElideMode.ElideRight, box.width())
            painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, said)
            painter.end()
