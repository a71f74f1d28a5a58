"""The four sides of one rectangle of a view in fields, under its name and its line."""

from msgspec.structs import replace
from PySide6.QtCore import QSize, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from workbench.document.fields import numbers_of
from workbench.document.model import Rectangle
from workbench.language import _
from workbench.panels.viewing.rectangles import SIDES, Named
from workbench.widgets.canvas.drawing import PATTERNS, ink_of
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.tokens import theme_changed, tokens

_FIELD_PX = 48


class _Line(QWidget):
    """The line with which a rectangle is drawn."""

    def __init__(self, named: Named) -> None:
        super().__init__()
        self._named = named
        self.setFixedSize(QSize(18, 14))
        theme_changed.connect(self.update)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Solid for the window, dashed for the others."""
        painter = QPainter(self)
        pattern = "solid" if self._named.slug == "window" else "dash"
        painter.setPen(QPen(QColor(ink_of(tokens(), self._named.ink)), 2, PATTERNS[pattern]))
        painter.drawLine(1, 7, 17, 7)
        painter.end()


class RectangleFields(QWidget):
    """``changed`` sends the rectangle that was asked for, which may have no area, and how it is merged;
    ``ended`` follows a drag of a label.
    """

    changed = Signal(object, str)
    ended = Signal()

    def __init__(self, named: Named, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rectangle = Rectangle(0.0, 0.0, 1.0, 1.0)
        self.fields: dict[str, NumberField] = {}
        title = QLabel(named.title[:1].upper() + named.title[1:])
        bold = title.font()
        bold.setBold(True)
        title.setFont(bold)
        self.heading = QHBoxLayout()
        self.heading.setSpacing(8)
        self.heading.addWidget(_Line(named))
        self.heading.addWidget(title)
        self.heading.addStretch(1)
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(6)
        self._grid.setVerticalSpacing(2)
        for side in SIDES:
            symbol = numbers_of(Rectangle)[side].symbol
            field = NumberField(
                symbol, meaning=_("{side} of the {name}").format(side=symbol, name=named.title)
            )
            field.field.setFixedWidth(_FIELD_PX)
            field.edited.connect(lambda value, side=side: self._set(side, value, ""))
            field.scrubbed.connect(lambda value, side=side: self._set(side, value, f"scrub {named.slug}"))
            field.scrub_ended.connect(self.ended)
            self.fields[side] = field
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addLayout(self.heading)
        column.addLayout(self._grid)
        self._narrow: bool | None = None
        self.set_narrow(False)

    def set_narrow(self, narrow: bool) -> None:
        """The fields in two rows, or in one."""
        if narrow == self._narrow:
            return
        self._narrow = narrow
        columns = 2 if narrow else len(SIDES)
        for number, field in enumerate(self.fields.values()):
            self._grid.removeWidget(field)
            self._grid.addWidget(field, number // columns, number % columns)

    def show_rectangle(self, view: str, rectangle: Rectangle, lit: frozenset[str]) -> None:
        """Show its sides in a view (an id); those in ``lit`` are the ones that a drag changes now."""
        self._rectangle = rectangle
        for side, field in self.fields.items():
            field.belong_to(view)
            field.set_value(round(getattr(rectangle, side), 6))
            if field.property("lit") != (side in lit):
                field.setProperty("lit", side in lit)
                field.label.setStyleSheet(
                    f"color: {tokens().accent}; font-weight: bold" if side in lit else ""
                )

    def _set(self, side: str, value: float, merge: str) -> None:
        self.changed.emit(replace(self._rectangle, **{side: value}), merge)

    def mark_wrong(self, asked: Rectangle | None) -> None:
        """Edge the sides in error in which what was ``asked`` for is another; with None none any longer."""
        for side, field in self.fields.items():
            wrong = asked is not None and getattr(asked, side) != getattr(self._rectangle, side)
            if field.field.property("wrong") != wrong:
                field.field.setProperty("wrong", wrong)
                field.field.style().polish(field.field)
