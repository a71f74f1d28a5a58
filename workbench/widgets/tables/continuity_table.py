"""How smoothly a curve passes through each of its joints, in numbers, with commands that smooth one."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QTableView, QVBoxLayout, QWidget

from workbench.algorithms.curves import Continuity
from workbench.exchange.tables import typeset
from workbench.language import _
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.look.type_faces import code_font, keep_code_font
from workbench.widgets.plots.parameter_axis import number_text
from workbench.widgets.tables.table_columns import FittedColumns, WholeRows
from workbench.widgets.tables.table_copies import CopiedTable

Index = QModelIndex | QPersistentModelIndex
_WIDEST_PX = 88
SMOOTHINGS = ("G1", "C1", "G2", "C2")


@dataclass(frozen=True, slots=True)
class Joint:
    """Where two pieces meet: the name of the point there ("P_{3}", or "" for none), its parameter, what was
    measured.
    """

    name: str
    u: float
    continuity: Continuity

    @property
    def text(self) -> str:
        """The joint as it is called in the table."""
        return typeset(self.name) if self.name else f"u = {number_text(self.u, 4)}"


def holds(found: Continuity, kind: str) -> bool:
    """Whether a joint is "C0", "C1", "C2", "G0", "G1" or "G2"."""
    best = found.parametric if kind[0] == "C" else found.geometric
    return bool(best) and best[1] >= kind[1]


def residual(found: Continuity, kind: str) -> float:
    """What is left between the two sides, an angle in degrees; nan where it does not exist."""
    value = float(getattr(found, kind.lower()))
    return math.degrees(value) if kind == "G1" else value


@dataclass(frozen=True, slots=True)
class _Column:
    kinds: tuple[str, ...]
    heading: str
    meaning: str
    unit: str


def _columns() -> tuple[_Column, ...]:
    return (
        _Column(("C0", "G0"), "C0 G0", _("how far apart the ends are"), "px"),
        _Column(("C1",), "C1", _("how much the first derivatives differ"), "px/u"),
        _Column(("C2",), "C2", _("how much the second derivatives differ"), "px/u²"),
        _Column(("G1",), "G1", _("the angle between the tangents"), "°"),
        _Column(("G2",), "G2", _("how much the curvatures differ"), "1/px"),
    )


class ContinuityModel(QAbstractTableModel):
    """Joints as rows."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.joints: tuple[Joint, ...] = ()
        self.columns = _columns()

    def take(self, joints: tuple[Joint, ...]) -> None:
        """Show other joints; as many as before keep their rows and the selection."""
        if joints == self.joints:
            return
        if len(joints) == len(self.joints):
            self.joints = joints
            self.dataChanged.emit(self.index(0, 0), self.index(len(joints) - 1, self.columnCount() - 1))
        else:
            self.beginResetModel()
            self.joints = joints
            self.endResetModel()

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Joints."""
        return 0 if parent.isValid() else len(self.joints)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """The joint, and what is measured."""
        return 0 if parent.isValid() else 1 + len(self.columns)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Headings; what they mean as a tooltip."""
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if not section:
            return _("joint") if role == Qt.ItemDataRole.DisplayRole else None
        column = self.columns[section - 1]
        if role == Qt.ItemDataRole.DisplayRole:
            return column.heading
        if role == Qt.ItemDataRole.ToolTipRole:
            return f"{column.meaning} ({column.unit})"
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """One cell: a sign, and the residual where there is one."""
        joint = self.joints[index.row()]
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.FontRole:
            return code_font(12)
        if not index.column():
            if role == Qt.ItemDataRole.DisplayRole:
                return joint.text
            if role == Qt.ItemDataRole.ToolTipRole:
                return _("{joint}, at u = {u}").format(joint=joint.text, u=number_text(joint.u, 6))
            return None
        column = self.columns[index.column() - 1]
        kind = column.kinds[0]
        kept = holds(joint.continuity, kind)
        left = residual(joint.continuity, kind)
        if role == Qt.ItemDataRole.DisplayRole:
            number = "\N{EN DASH}" if math.isnan(left) else number_text(left, 2)
            return f"\N{CHECK MARK} {number}" if kept else f"\N{MULTIPLICATION SIGN} {number}"
        if role == Qt.ItemDataRole.ForegroundRole:
            return colour(tokens().text if kept else tokens().error)
        if role in (Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleTextRole):
            name = " = ".join(column.kinds)
            said = _("{joint} is {kind}") if kept else _("{joint} is not {kind}")
            number = (
                _("it does not exist here") if math.isnan(left) else f"{number_text(left, 6)} {column.unit}"
            )
            return f"{said.format(joint=joint.text, kind=name)}; {column.meaning}: {number}"
        return None


class ContinuityTable(QWidget):
    """A row for each joint. ``joint_selected`` sends its number or -1, ``joint_activated`` that of a double
    click or Enter, ``smoothing_wanted`` the number and "G1", "C1", "G2" or "C2" of a button pressed.
    """

    joint_selected = Signal(int)
    joint_activated = Signal(int)
    smoothing_wanted = Signal(int, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = ContinuityModel(self)
        self.view = CopiedTable()
        self.view.setModel(self.model)
        self.view.setAccessibleName(_("Continuity at each joint"))
        self.view.setToolTip(_("How smooth each joint is; Enter or a double click goes there"))
        self.view.setShowGrid(False)
        self.view.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        self.view.setSelectionMode(QTableView.SelectionMode.SingleSelection)
        self.view.setEditTriggers(QTableView.EditTrigger.NoEditTriggers)
        self.view.setTabKeyNavigation(False)
        self.view.verticalHeader().hide()
        self.view.verticalHeader().setDefaultSectionSize(22)
        keep_code_font(self.view.horizontalHeader(), 12)
        self.view.setItemDelegate(WholeRows(self.view))
        self.model.dataChanged.connect(FittedColumns(self.view).widen)
        self.words = QLabel(_("The joints of a curve of several pieces are shown here."))
        self.words.setProperty("role", "caption")
        self.words.setWordWrap(True)
        self.words.setContentsMargins(8, 6, 8, 6)
        self.buttons = {kind: self._button(kind) for kind in SMOOTHINGS}
        row = QHBoxLayout()
        row.setContentsMargins(8, 2, 6, 6)
        row.setSpacing(4)
        lead = QLabel(_("Make it"))
        lead.setProperty("role", "caption")
        row.addWidget(lead)
        for button in self.buttons.values():
            row.addWidget(button, 1)
        row.addStretch()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.view, 1)
        column.addWidget(self.words)
        column.addLayout(row)
        self.setFocusProxy(self.view)
        # Not the current row: a table that gets the focus makes its first row that.
        self.view.selectionModel().selectionChanged.connect(self._select)
        self.view.activated.connect(lambda index: self.joint_activated.emit(index.row()))
        self.model.modelReset.connect(self._select)
        theme.changed.connect(self._restyle)
        self.say("")

    def _button(self, kind: str) -> QPushButton:
        button = QPushButton(kind)
        button.setToolTip(_("Move as few points as needed so that the joint is {kind}").format(kind=kind))
        button.setMaximumWidth(_WIDEST_PX)
        button.setAccessibleName(_("Make it {kind}").format(kind=kind))
        button.clicked.connect(lambda: self.smoothing_wanted.emit(self.selected, kind))
        return button

    @property
    def selected(self) -> int:
        """The number of the joint selected, or -1."""
        return next((index.row() for index in self.view.selectionModel().selectedRows()), -1)

    def set_joints(self, joints: Sequence[Joint]) -> None:
        """Show these joints. A sentence that was said stays while they are as many and the same is chosen."""
        before = self.model.rowCount()
        self.model.take(tuple(joints))
        if self.model.rowCount() != before:
            self.say("")
        self._enable()

    def say(self, text: str) -> None:
        """A sentence beneath, such as which points a command moved; "" removes it."""
        if not text and not self.model.joints:
            text = _("The joints of a curve of several pieces are shown here.")
        elif not text and self.selected < 0:
            text = _("Choose a joint to make it smoother.")
        self.words.setText(text)
        self.words.setVisible(bool(text))

    def _select(self) -> None:
        self.say("")
        self._enable()
        self.joint_selected.emit(self.selected)

    def _enable(self) -> None:
        chosen = self.selected
        for kind, button in self.buttons.items():
            button.setEnabled(chosen >= 0 and not holds(self.model.joints[chosen].continuity, kind))

    def _restyle(self) -> None:
        self.view.viewport().update()
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The ground of a panel."""
        QPainter(self).fillRect(event.rect(), colour(tokens().surface))
