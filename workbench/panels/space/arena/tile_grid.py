"""The tiles of all methods in rows, as many beside each other as there is room for."""

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QPixmap, QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget

from workbench.language import _
from workbench.panels.space.arena.tile import AIR_PX, HEAD_PX, LEAST_PX, LINE_PX, LINES, MethodTile
from workbench.rendering.scene.viewpoint import Size
from workbench.widgets.canvas.overlay import Cell

_GAP_PX = 4


class TileGrid(QScrollArea):
    """``chosen`` and ``stepped`` send a slug, ``pointed`` the pixel under the pointer, None when none is;
    ``asked`` the one that was clicked. ``pointed_cell`` is the one that ``pointed`` sent last."""

    chosen = Signal(str)
    stepped = Signal(str)
    pointed = Signal(object)
    asked = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setAccessibleName(_("Methods"))
        self._inner = QWidget()
        self.setWidget(self._inner)
        self.tiles: dict[str, MethodTile] = {}
        self._size: Size = (3, 2)
        self.pointed_cell: Cell | None = None
        self._kept: Cell | None = None

    def show_methods(self, methods: tuple[str, ...], size: Size) -> None:
        """A tile for each method, whose pictures are of this size."""
        if tuple(self.tiles) != methods:
            for tile in self.tiles.values():
                tile.hide()  # else it is seen below the new ones until it goes
                tile.deleteLater()
            self.tiles = {method: self._tile(method) for method in methods}
            self.setFocusProxy(next(iter(self.tiles.values()), self._inner))
        self._size = size
        self._lay_out()

    def _tile(self, method: str) -> MethodTile:
        tile = MethodTile(method, self._inner)
        tile.chosen.connect(self.chosen)
        tile.stepped.connect(self.stepped)
        tile.pointed.connect(self.point_at)
        tile.asked.connect(self.asked)
        tile.moved.connect(self._move)
        tile.show()
        return tile

    def choose(self, method: str) -> None:
        """Ring the one that is spoken of."""
        for slug, tile in self.tiles.items():
            tile.choose(slug == method)

    def point_at(self, cell: Cell | None) -> None:
        """Ring the same pixel in all, and tell of it; None rings the one that is kept."""
        self.pointed_cell = cell
        self._ring()
        self.pointed.emit(cell)

    def keep(self, cell: Cell | None) -> None:
        """Ring a pixel wherever none is pointed at, if the pictures have it."""
        inside = cell is not None and cell[0] < self._size[0] and cell[1] < self._size[1]
        self._kept = cell if inside else None
        self._ring()

    def _ring(self) -> None:
        for tile in self.tiles.values():
            tile.point_at(self.pointed_cell or self._kept)

    def tiles_grabbed(self) -> QPixmap:
        """A picture of all tiles, those out of sight too."""
        return self._inner.grab()

    @property
    def columns(self) -> int:
        """How many are beside each other: as many as fit, but no row is left with few."""
        most = max(1, (self.viewport().width() - _GAP_PX) // (LEAST_PX.width() + _GAP_PX))
        rows = -(-len(self.tiles) // most) or 1
        return -(-len(self.tiles) // rows) or 1

    def _move(self, columns: int, rows: int) -> None:
        """Go on by the keys."""
        order = list(self.tiles)
        here = next((k for k, slug in enumerate(order) if self.tiles[slug].hasFocus()), 0)
        there = here + columns + rows * self.columns
        if 0 <= there < len(order):
            tile = self.tiles[order[there]]
            tile.setFocus(Qt.FocusReason.OtherFocusReason)
            self.ensureWidgetVisible(tile)
            self.chosen.emit(order[there])

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay the tiles out anew."""
        super().resizeEvent(event)
        self._lay_out()

    def _lay_out(self) -> None:
        columns, view = self.columns, self.viewport().size()
        rows = -(-len(self.tiles) // columns)
        width = (view.width() - _GAP_PX * (columns + 1)) // columns
        share = self._size[1] / self._size[0]
        most = round((width - 2 * AIR_PX) * share) + HEAD_PX + (LINES + 1) * LINE_PX + 2 * AIR_PX
        fitting = (view.height() - _GAP_PX * (rows + 1)) // max(rows, 1)
        height = max(LEAST_PX.height(), min(most, fitting))
        for k, tile in enumerate(self.tiles.values()):
            x, y = k % columns, k // columns
            tile.setGeometry(_GAP_PX + x * (width + _GAP_PX), _GAP_PX + y * (height + _GAP_PX), width, height)
        self._inner.setMinimumHeight(rows * (height + _GAP_PX) + _GAP_PX)

    def minimumSizeHint(self) -> QSize:
        """One row."""
        return LEAST_PX
