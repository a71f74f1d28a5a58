"""How tables look: columns as wide as headings and a few rows need, rows selected as wholes."""

from PySide6.QtCore import QEvent, QModelIndex, QObject, QPersistentModelIndex, Qt, QTimer
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QHeaderView, QStyle, QStyledItemDelegate, QStyleOptionViewItem, QTableView

from workbench.session.going_first import go_first

_SAMPLED = 12
PADDING_PX = 20
ROOM_FOR = Qt.ItemDataRole.UserRole
"""Of a heading: the longest that stands below it, where the first rows do not tell."""

_SLACK_PX, _CLOSER_PX = 12, 3
DECORATION_PX = 24


class FittedColumns(QObject):
    """Keeps every column of ``view`` wide enough to read, also in a narrow window, by looking at few rows."""

    def __init__(self, view: QTableView) -> None:
        super().__init__(view)
        self._view = view
        header = view.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header.setHighlightSections(False)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        view.setHorizontalScrollMode(QTableView.ScrollMode.ScrollPerPixel)
        view.viewport().installEventFilter(self)
        view.model().modelReset.connect(self._reset)
        view.model().rowsInserted.connect(self._grown)
        view.model().dataChanged.connect(self._forget)
        self._needed: list[int] | None = None  # by the columns, until what stands in them changes
        self._fitted_rows = self._fitted_columns = 0
        # Measuring takes as long as laying out the rest of a window: it has a turn of its own.
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.fit)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Share again when the view's width changes, fit when its type does."""
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._forget()
        elif event.type() == QEvent.Type.Resize:
            self._share(self._widths() if self._needed is None else self._needed)
        return False

    def _forget(self, *_what: object) -> None:
        self._needed = None

    def _reset(self) -> None:
        """Columns that are there already keep their widths for a moment."""
        self._forget()
        if self._view.model().columnCount() == self._fitted_columns:
            self._soon.start(0)
        else:
            self.fit()

    def _grown(self) -> None:
        """Numbers grow longer as a table grows, but slowly."""
        if self._view.model().rowCount() > 2 * self._fitted_rows:
            self._soon.start(0)

    def widen(self) -> None:
        """Fit again once a value in its place has outgrown its column; otherwise let nothing move."""
        widths = self._widths()
        if any(width - _SLACK_PX > self._view.columnWidth(k) for k, width in enumerate(widths)):
            self.fit()

    def fit(self) -> None:
        """Make every column as wide as it needs now."""
        self._share(self._widths())

    def _share(self, needed: list[int]) -> None:
        """Share the width of the view among the columns; where it is too narrow, they stand closer."""
        go_first()
        self._needed = needed
        view, widths = self._view, needed
        self._fitted_rows, self._fitted_columns = view.model().rowCount(), len(widths)
        missing = sum(widths) - view.viewport().width()
        if missing > 0:
            closer = min(-(-missing // len(widths)), _CLOSER_PX)
            widths = [width - closer for width in widths]
        spare = max(view.viewport().width() - sum(widths), 0)
        for column, width in enumerate(widths):
            share = spare // len(widths) + (column < spare % len(widths))
            if view.columnWidth(column) != width + share:
                view.setColumnWidth(column, width + share)

    def _widths(self) -> list[int]:
        """What each column needs, by its heading and a few rows."""
        view, model = self._view, self._view.model()
        columns, rows = model.columnCount(), model.rowCount()
        sampled = sorted({*range(min(rows, _SAMPLED)), *range(max(rows - 2, 0), rows)})
        heading = QFontMetrics(view.horizontalHeader().font())
        across = Qt.Orientation.Horizontal
        widths = []
        for column in range(columns):
            title = str(model.headerData(column, across, Qt.ItemDataRole.DisplayRole) or "")
            widest = heading.horizontalAdvance(title)
            if model.headerData(column, across, Qt.ItemDataRole.DecorationRole) is not None:
                widest += DECORATION_PX
            if longest := model.headerData(column, across, ROOM_FOR):
                widest = max(widest, heading.horizontalAdvance(str(longest)))
            for row in sampled:
                index = model.index(row, column)
                font = index.data(Qt.ItemDataRole.FontRole)
                metrics = QFontMetrics(font) if font is not None else heading
                beside = DECORATION_PX if index.data(Qt.ItemDataRole.DecorationRole) is not None else 0
                widest = max(widest, beside + metrics.horizontalAdvance(str(index.data() or "")))
            widths.append(widest + PADDING_PX)
        return widths


class WholeRows(QStyledItemDelegate):
    """Shows a selected row or column as one: none of its cells bears a frame of its own."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        """As ever, without the frame."""
        super().initStyleOption(option, index)
        option.state &= ~QStyle.StateFlag.State_HasFocus
