"""What is said of the cell that is pointed at, also when it changes under the pointer."""

from collections.abc import Callable

from PySide6.QtCore import QObject, SignalInstance

from workbench.widgets.canvas.pixel_canvas import PixelCanvas


class Pointed(QObject):
    """``said`` sends what ``describe`` says of the cell under pointer or cursor, "" when it is left."""

    def __init__(
        self, canvas: PixelCanvas, describe: Callable[[int, int], str], said: SignalInstance
    ) -> None:
        super().__init__(canvas)
        self.said = said
        self._describe = describe
        self._cell: tuple[int, int] | None = None
        self._text = ""
        for moved in (canvas.hovered, canvas.cursor_moved):
            moved.connect(self._point)
        canvas.hover_left.connect(self._leave)

    def _point(self, x: int, y: int) -> None:
        self._cell, self._text = (x, y), self._describe(x, y)
        self.said.emit(self._text)

    def _leave(self) -> None:
        self._cell = None
        self.said.emit("")

    def refresh(self) -> None:
        """Say it again if it is otherwise now."""
        if self._cell is not None and self._describe(*self._cell) != self._text:
            self._point(*self._cell)
