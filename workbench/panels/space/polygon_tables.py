"""The polygon tables of the chosen object: vertices, edges, faces, and the plane of each face."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import (
    QAbstractTableModel,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtWidgets import QComboBox, QTableView, QVBoxLayout, QWidget

from workbench.algorithms.numerals import with_minus
from workbench.algorithms.solids.tables import PolygonTables, polygon_tables
from workbench.document.scene.model import Object
from workbench.exchange.tables import Table
from workbench.geometry.meshes import Mesh
from workbench.language import _
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.type_faces import keep_code_font

Index = QModelIndex | QPersistentModelIndex
_NOWHERE = QModelIndex()


def table_names() -> tuple[str, ...]:
    """What the tables are called."""
    return _("Vertices"), _("Edges"), _("Faces"), _("Planes, in the world")


_VERTICES, _EDGES = 0, 1


def _ends(tables: PolygonTables, kind: int, row: int) -> NDArray[np.int64]:
    """The vertices (n, 2) at the ends of what a row is of: a vertex twice, an edge, the sides of a face."""
    if kind == _VERTICES:
        return np.array([[row, row]])
    if kind == _EDGES:
        return tables.edges[row : row + 1]
    corners = np.asarray(tables.faces[row])
    return np.stack([corners, np.roll(corners, -1)], axis=1)


class _Rows(QAbstractTableModel):
    """One of the tables; its rows are made when they are looked at."""

    def __init__(self) -> None:
        super().__init__()
        self._tables: PolygonTables | None = None
        self._kind = 0

    @property
    def tables(self) -> PolygonTables | None:
        """Those whose rows are shown."""
        return self._tables

    def take(self, tables: PolygonTables | None, kind: int) -> None:
        """Show another one."""
        self.beginResetModel()
        self._tables, self._kind = tables, kind
        self.endResetModel()

    @property
    def columns(self) -> tuple[str, ...]:
        """Their headings."""
        return (
            (_("vertex"), "x", "y", "z"),
            (_("edge"), _("from"), _("to"), _("left face"), _("right face")),
            (_("face"), _("vertices"), _("edges")),
            (_("face"), "A", "B", "C", "D"),
        )[self._kind]

    def row(self, number: int) -> tuple[object, ...]:
        """One row, numbers as they are."""
        tables = self._tables
        assert tables is not None
        match self._kind:
            case 0:
                return (number, *tables.vertices[number].tolist())
            case 1:
                sides = ["–" if face < 0 else face for face in tables.edge_faces[number].tolist()]
                return (number, *tables.edges[number].tolist(), *sides)
            case 2:
                start, end = tables.faces.starts[number], tables.faces.ends[number]
                sides = tables.sides[start:end].tolist()
                return number, " ".join(map(str, tables.faces[number])), " ".join(map(str, sides))
        return (number, *tables.planes[number].tolist())

    def rowCount(self, _parent: Index = _NOWHERE) -> int:
        """As many as there are of what the table is of."""
        tables = self._tables
        if tables is None:
            return 0
        return (len(tables.vertices), len(tables.edges), len(tables.faces), len(tables.faces))[self._kind]

    def columnCount(self, _parent: Index = _NOWHERE) -> int:
        """As many as there are headings."""
        return len(self.columns)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """A cell, to four decimals."""
        if role == Qt.ItemDataRole.DisplayRole:
            value = self.row(index.row())[index.column()]
            text = f"{value + 0.0:.4g}" if isinstance(value, float) else str(value)
            return with_minus(text)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        return None

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The headings."""
        if role == Qt.ItemDataRole.DisplayRole and orientation == Qt.Orientation.Horizontal:
            return self.columns[section]
        return None


class PolygonTablesView(QWidget):
    """Which table, and the table. ``marked`` sends what its current or hovered row is of, as segments (n, 2,
    3) of the world, and ``show_part`` brings a vertex or a face of the picture forward in it."""

    marked = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.choice = QComboBox()
        self.choice.addItems(table_names())
        self.choice.setAccessibleName(_("Table"))
        self.choice.setToolTip(_("Which of the polygon tables is shown"))
        self.choice.currentIndexChanged.connect(self._show)
        self.table = QTableView()
        self._rows = _Rows()
        self.table.setModel(self._rows)
        keep_code_font(self.table, 12)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(20)
        self.table.horizontalHeader().setDefaultSectionSize(78)
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.setAccessibleName(_("Polygon table"))
        self.table.setToolTip(_("Point at a row to see it in the scene; point at the scene to see its row"))
        self.table.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        self.table.setSelectionMode(QTableView.SelectionMode.SingleSelection)
        self.table.setTabKeyNavigation(False)
        self.table.setMouseTracking(True)
        self.table.entered.connect(lambda index: self._mark(index.row()))
        self.table.viewport().installEventFilter(self)
        self.table.selectionModel().currentRowChanged.connect(lambda index, _old: self._mark(index.row()))
        self.in_sight = InSight(self)
        self.in_sight.changed.connect(self._come_in_sight)
        self._thing: Object | None = None
        self._mesh: Mesh | None = None
        inner = QWidget()
        column = QVBoxLayout(inner)
        column.setContentsMargins(8, 6, 8, 6)
        column.addWidget(self.choice)
        column.addWidget(self.table, 1)
        self.empty = EmptyView(inner, _("Choose an object, and its vertices, edges and faces are listed."))
        self.empty.button.hide()
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(self.empty)
        self.empty.set_empty(True)

    def show_object(self, thing: Object | None) -> None:
        """Show the tables of an object, in the world."""
        if thing == self._thing:
            return
        self._thing = thing
        self.empty.set_empty(thing is None)
        self._show()

    def _tables(self) -> PolygonTables | None:
        thing = self._thing
        if thing is None:
            return None
        vertices, faces = thing.mesh
        if thing.matrix is not None:
            vertices = vertices @ thing.matrix[:3, :3].T + thing.matrix[:3, 3]
            if np.linalg.det(thing.matrix[:3, :3]) < 0:
                faces = faces.reversed()
        return polygon_tables(Mesh(vertices, faces))

    def _show(self, *_index: object) -> None:
        self._rows.take(self._tables() if self.in_sight.now else None, self.choice.currentIndex())
        self._mark(-1)

    def _come_in_sight(self, _seen: bool) -> None:
        """Make them when they are looked at."""
        self._show()

    # Linked with the picture

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Where the pointer has left, the current row is shown again."""
        if event.type() == QEvent.Type.Leave:
            self._mark(self.table.currentIndex().row())
        return False

    def _mark(self, row: int) -> None:
        tables = self._rows.tables
        if tables is None or row < 0:
            self.marked.emit(np.zeros((0, 2, 3)))
        else:
            self.marked.emit(tables.vertices[_ends(tables, self.choice.currentIndex(), row)])

    def show_part(self, vertex: int, face: int) -> None:
        """Bring a vertex, or with -1 for that a face, forward where the table shown lists such."""
        kind, tables = self.choice.currentIndex(), self._rows.tables
        row = {_VERTICES: vertex, _EDGES: -1}.get(kind, face)
        if tables is None or not 0 <= row < self._rows.rowCount():
            self.table.clearSelection()
            self._mark(-1)
            return
        self.table.selectRow(row)
        self.table.scrollTo(self._rows.index(row, 0))
        self._mark(row)

    def content(self) -> list[tuple[str, Table]]:
        """Title and content of each table, for export."""
        rows, listed = _Rows(), []
        for kind, title in enumerate(table_names()):
            rows.take(self._tables(), kind)
            if rows.rowCount():
                listed.append((title, Table(rows.columns, [rows.row(k) for k in range(rows.rowCount())])))
        return listed
