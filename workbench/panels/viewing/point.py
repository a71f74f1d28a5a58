"""The point that is sent through: its way there, back, and by normalised coordinates, with the arithmetic."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QScrollArea, QVBoxLayout, QWidget

from workbench.algorithms.viewing import normalised_to_viewport, window_to_normalised
from workbench.document.model import View
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.viewing.card import factors_of
from workbench.rendering.mapping import box, view_map
from workbench.rendering.subjects.window import Point, landing
from workbench.widgets.fields.number_field import NumberField

NARROW_PX = 380
Arithmetic = tuple[tuple[str, tuple[str, ...]], ...]


def arithmetic(view: View, point: Point) -> Arithmetic:
    """The way of a point (world) to the device, back, and by normalised coordinates: rich text, by title."""
    window, viewport = box(view.window_world), landing(view)
    there, factors = view_map(view).point(*point), factors_of(view)
    onward: list[str] = []
    back: list[str] = []
    into: list[str] = []
    out: list[str] = []
    for k, name in enumerate("xy"):
        low, start, factor = window[k], viewport[k], factors[k]
        unit = float(window_to_normalised(window)[k] @ (*point, 1.0))
        value = float(normalised_to_viewport(viewport)[k] @ (unit, unit, 1.0))
        onward.append(_line(name, "v", start, f"{_less(point[k], low)} · {displayed(factor)}", there[k]))
        back.append(_line(name, "w", low, f"{_less(there[k], start)} / {displayed(factor)}", point[k]))
        share = f"{_less(point[k], low)} / {_less(window[k + 2], low)}"
        into.append(f"{name}<sub>n</sub> = {share} = {displayed(unit)}")
        out.append(_line(name, "v", start, f"{_bracketed(unit)} · {_less(viewport[k + 2], start)}", value))
    return (
        (_("there"), tuple(onward)),
        (_("back"), tuple(back)),
        (_("by the unit square"), (*into, *out)),
    )


def _line(name: str, frame: str, start: float, term: str, value: float) -> str:
    """x_v = start + term = value."""
    return f"{name}<sub>{frame}</sub> = {displayed(start)} + {term} = {displayed(value)}"


def _less(value: float, other: float) -> str:
    """(value − other)."""
    return f"({displayed(value)} − {_bracketed(other)})"


def _bracketed(value: float) -> str:
    """A number that may follow an operator: negative ones in brackets."""
    return f"({displayed(value)})" if value < 0 else displayed(value)


class PointCard(QScrollArea):
    """``sent`` sends a point (world) that was typed; ``figure_wanted``: step those of the figure again."""

    sent = Signal(float, float)
    figure_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        body = QWidget()
        body.setObjectName("pageBody")
        column = QVBoxLayout(body)
        column.setContentsMargins(12, 8, 12, 8)
        column.setSpacing(6)
        self.setWidget(body)
        self.missing = QLabel(_("Click in one of the pictures to send a point through."))
        self.missing.setWordWrap(True)
        self.missing.setProperty("role", "muted")
        column.addWidget(self.missing)
        self.inputs = QWidget()
        grid = QGridLayout(self.inputs)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(12)
        self.fields: dict[str, NumberField] = {}
        meanings = {
            "x_w": _("x in the world"),
            "y_w": _("y in the world"),
            "x_v": _("x on the device"),
            "y_v": _("y on the device"),
        }
        for number, (name, meaning) in enumerate(meanings.items()):
            field = NumberField(name, meaning=meaning)
            field.edited.connect(lambda value, name=name: self._typed(name, value))
            field.scrubbed.connect(lambda value, name=name: self._typed(name, value))
            self.fields[name] = field
            grid.addWidget(field, number // 2, number % 2)
        column.addWidget(self.inputs)
        self.way = QLabel()
        self.way.setTextFormat(Qt.TextFormat.RichText)
        self.way.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.way.setAccessibleName(_("The path of the point"))
        column.addWidget(self.way)
        self.figure = QPushButton(_("Step the points of the figure"))
        self.figure.setToolTip(_("Send the points of the active figure through instead of this point"))
        self.figure.clicked.connect(self.figure_wanted)
        column.addWidget(self.figure, 0, Qt.AlignmentFlag.AlignLeft)
        column.addStretch(1)
        self._view: View | None = None
        self._point: Point = (0.0, 0.0)
        self._clicked = False

    def show_point(self, view: View, point: Point | None, clicked: bool) -> None:
        """Show the way of a point; None asks for one. Only a ``clicked`` one can be let go."""
        self._view, self._clicked = view, clicked
        for field in self.fields.values():
            field.belong_to(view.id)
        self.missing.setVisible(point is None)
        self.inputs.setVisible(point is not None)
        self.way.setVisible(point is not None)
        self.figure.setVisible(clicked)
        if point is None:
            return
        self._point = point
        there = view_map(view).point(*point)
        for name, value in zip(self.fields, (*point, *there), strict=True):
            self.fields[name].set_value(round(value, 6))
        if self.width() < NARROW_PX:
            ways = ("<br>".join((f"<b>{title}</b>", *lines)) for title, lines in arithmetic(view, point))
            self.way.setText("<br>".join(ways))
            return
        rows = "".join(
            f"<tr><td style='padding-right:12px'>{title if not k else ''}</td><td>{line}</td></tr>"
            for title, lines in arithmetic(view, point)
            for k, line in enumerate(lines)
        )
        self.way.setText(f"<table cellspacing='0'>{rows}</table>")

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Narrow, the titles stand above their lines."""
        super().resizeEvent(event)
        if self._view is not None and not self.way.isHidden():
            self.show_point(self._view, self._point, self._clicked)

    def _typed(self, name: str, value: float) -> None:
        if self._view is None:
            return
        axis = 0 if name.startswith("x") else 1
        if name.endswith("v"):
            there = list(view_map(self._view).point(*self._point))
            there[axis] = value
            point = view_map(self._view).world_point(*there)
        else:
            own = list(self._point)
            own[axis] = value
            point = own[0], own[1]
        self.sent.emit(*point)
