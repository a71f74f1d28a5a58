"""One link of a chain as a card: its numbers, its switch, and the matrices that it unfolds into."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from workbench.document.fields import numbers_of
from workbench.document.scene.links import Affine3D, Scale3D
from workbench.document.transforms.chains import is_singular
from workbench.document.transforms.links import Affine, Link, Reflect, Scale
from workbench.language import _
from workbench.panels.transform.chain_edits import StageWords
from workbench.panels.transform.scene import ink_of_stage
from workbench.panels.transform.stage_row import Badge, StageRow
from workbench.panels.transform.told import ICONS, title
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.plain_keys import is_plain

_STEPS = {"angle": 1.0, "sx": 0.1, "sy": 0.1, "sh_x": 0.1, "sh_y": 0.1}


def fields_of(link: Link) -> list[str]:
    """The numbers of a link that its card shows."""
    names = list(numbers_of(type(link)))
    if isinstance(link, Reflect) and link.mirror == "point":
        names.remove("angle")
    first = [name for name in names if not name.endswith(("_pivot", "_ref"))]
    return [*first, *(name for name in names if name not in first)]


def complaint_of(link: Link) -> str:
    """What a link that cannot be undone does, and what to do; empty for all others."""
    if not link.on or not is_singular(link.matrix):
        return ""
    if isinstance(link, Scale | Scale3D):
        return _("A factor of 0 flattens the figure, so no handle can bring it back. Type another factor.")
    return _("This link flattens the figure, so no handle can bring it back. Type other numbers.")


class Grip(QToolButton):
    """What a card is dragged by; with the focus, Up and Down move it. ``moved`` sends by how many cards."""

    moved = Signal(int)
    dragged = Signal(QPoint)
    dropped = Signal()

    def __init__(self) -> None:
        super().__init__()
        set_icon(self, "dots-six-vertical", "muted")
        self.setFixedSize(20, 24)
        self.setCursor(Qt.CursorShape.OpenHandCursor)
        self.setAutoRaise(True)
        self.setToolTip(_("Drag this link to another place in the chain; Up and Down move it"))
        self._held = False

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold."""
        self._held = event.button() == Qt.MouseButton.LeftButton
        self.setFocus()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag."""
        if self._held:
            self.dragged.emit(event.globalPosition().toPoint())

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """Let go."""
        if self._held:
            self._held = False
            self.dropped.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Up and Down."""
        if is_plain(event) and event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self.moved.emit(-1 if event.key() == Qt.Key.Key_Up else 1)
        else:
            super().keyPressEvent(event)


class LinkCard(QFrame):
    """``changed`` sends attribute, value and whether it is scrubbed; ``scrub_ended`` follows."""

    changed = Signal(str, float, bool)
    scrub_ended = Signal()
    switched = Signal(bool)
    removed = Signal()
    stage_pointed = Signal(object)

    def __init__(self, link: Link) -> None:
        super().__init__()
        self.setObjectName("card")
        self.identity, self.kind = link.id, type(link)
        self.shape = tuple(fields_of(link))
        self._on = link.on
        self.grip = Grip()
        symbol = QToolButton()
        symbol.setAutoRaise(True)
        symbol.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        symbol.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        set_icon(symbol, ICONS[type(link).__name__.removesuffix("3D")])
        self.title = QLabel()
        self.title.setStyleSheet("font-weight: 600;")
        self.eye = QToolButton()
        self.eye.setAutoRaise(True)
        self.eye.clicked.connect(lambda: self.switched.emit(not self._on))
        self.bin = QToolButton()
        self.bin.setAutoRaise(True)
        set_icon(self.bin, "trash", "muted")
        self.bin.setToolTip(_("Remove this link"))
        self.bin.clicked.connect(lambda: self.removed.emit())
        head = QHBoxLayout()
        head.setSpacing(4)
        head.addWidget(self.grip)
        head.addWidget(symbol)
        head.addWidget(self.title, 1)
        head.addWidget(self.eye)
        head.addWidget(self.bin)
        self.body = QWidget()
        inner = QVBoxLayout(self.body)
        inner.setContentsMargins(2, 0, 2, 0)
        inner.setSpacing(2)
        self.fields = self._make_fields(inner)
        self.complaint = QLabel()
        self.complaint.setWordWrap(True)
        self.complaint.setProperty("role", "error")
        inner.addWidget(self.complaint)
        self.rows: list[StageRow] = []
        self._rows_at = inner
        self._counted: tuple[int, ...] = ()
        whole = QVBoxLayout(self)
        whole.setContentsMargins(6, 4, 6, 6)
        whole.setSpacing(2)
        whole.addLayout(head)
        whole.addWidget(self.body)

    def _make_fields(self, column: QVBoxLayout) -> dict[str, NumberField]:
        grid = QGridLayout()
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(2)
        made: dict[str, NumberField] = {}
        numbers = numbers_of(self.kind)
        across = {Affine: 3, Affine3D: 4}.get(self.kind, 2 if len(self.shape) in (2, 4) else 3)
        alone = len(self.shape) % across == 1  # an angle, before an axis and a pivot
        for k, name in enumerate(self.shape):
            number = numbers[name]
            unit = number.unit if number.unit == "°" else ""
            mirror = name == "angle" and self.kind is Reflect  # as its matrix has it
            field = NumberField(
                "φ" if mirror else number.symbol,
                unit,
                low=number.low,
                high=number.high,
                step=_STEPS.get(name, 0.5),
                meaning=number.label.capitalize(),
            )
            field.edited.connect(lambda value, name=name: self.changed.emit(name, value, False))
            field.scrubbed.connect(lambda value, name=name: self.changed.emit(name, value, True))
            field.scrub_ended.connect(self.scrub_ended)
            made[name] = field
            at = k + across - 1 if alone and k else k
            grid.addWidget(field, at // across, at % across)
        column.addLayout(grid)
        return made

    def fits(self, link: Link) -> bool:
        """Whether this card can show a link as it is now."""
        return (self.identity, self.kind, self.shape) == (link.id, type(link), tuple(fields_of(link)))

    def show_link(self, link: Link, own: Sequence[StageWords], count: int, lit: int | None) -> None:
        """Bring it up to date; ``own`` are its matrices among ``count`` of the chain."""
        self.title.setText(title(link) if link.on else _("{title}, switched off").format(title=title(link)))
        self.title.setEnabled(link.on)
        self.grip.setAccessibleName(_("Move {title}").format(title=title(link)))
        self.bin.setAccessibleName(_("Remove {title}").format(title=title(link)))
        self._on = link.on
        set_icon(self.eye, "eye" if link.on else "eye-slash", "muted")
        said = _("Switch this link off") if link.on else _("Switch this link on")
        self.eye.setToolTip(said)
        self.eye.setAccessibleName(f"{said}: {title(link)}")
        for name, field in self.fields.items():
            field.set_value(round(getattr(link, name), 6))
        sentence = complaint_of(link)
        self.complaint.setText(sentence)
        self.complaint.setVisible(bool(sentence))
        self.body.setVisible(link.on)
        self._show_stages(own, count)
        for row in self.rows:
            row.set_lit(row.number == lit)

    def _show_stages(self, own: Sequence[StageWords], count: int) -> None:
        numbers = (count, *(stage.number for stage in own)) if len(own) > 1 else ()
        if numbers != self._counted:
            self._counted = numbers
            for row in self.rows:
                row.blockSignals(True)
                row.hide()
                row.deleteLater()
            self.rows = []
            for stage in own if numbers else ():
                badge = Badge(stage.number, *ink_of_stage(stage.number, count))
                row = StageRow(stage.number, badge, "", "", "")
                row.pointed.connect(self.stage_pointed)
                self._rows_at.addWidget(row)
                self.rows.append(row)
        for row, stage in zip(self.rows, own, strict=False):
            row.tell(stage.name, stage.numbers, stage.words)
