"""What the pages of a timeline share: which frames are seen, and which keys are chosen."""

from collections.abc import Collection

from PySide6.QtCore import QObject, Signal

from workbench.widgets.timeline.scale import Scale, fitting, zoomed


class FrameAxis(QObject):
    """``scaled``: other frames are seen, or wider ones; ``chosen``: other keys are chosen."""

    scaled = Signal()
    chosen = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.scale: Scale = fitting(1, 640)
        self.selected: frozenset[str] = frozenset()
        self._fits = True
        self._frames, self._width = 1, 640.0

    def set_extent(self, frames: int) -> None:
        """There are so many frames to show, from 0."""
        if frames != self._frames:
            self._frames = frames
            self._keep()

    def set_width(self, width: float) -> None:
        """So wide is what shows them."""
        if width != self._width:
            self._width = width
            self._keep()

    def _keep(self) -> None:
        """All frames stay seen, unless somebody has zoomed."""
        if self._fits or self.scale.first >= self._frames:
            self.fit()

    def _set(self, scale: Scale) -> None:
        self._fits = scale == fitting(self._frames, self._width)
        if scale != self.scale:
            self.scale = scale
            self.scaled.emit()

    def fit(self) -> None:
        """Show all frames."""
        self._set(fitting(self._frames, self._width))

    def zoom(self, factor: float, about: int) -> None:
        """Show frames ``factor`` times as wide, one of them where it is."""
        self._set(zoomed(self.scale, factor, about, self._frames, self._width))

    def pan(self, by: int) -> None:
        """Show what lies so many frames later."""
        if not self._fits:
            last = self._frames - int((self.scale.last(self._width) - self.scale.first) / 2)
            self._set(self.scale._replace(first=max(min(self.scale.first + by, last), 0)))

    def reveal(self, frame: int) -> None:
        """Show so many frames later or earlier that this one is seen."""
        scale = self.scale
        if frame < scale.first or scale.x(frame) > self._width:
            self.pan(frame - scale.first)

    def choose(self, keys: Collection[str]) -> None:
        """Choose these keys, by their ids."""
        selected = frozenset(keys)
        if selected != self.selected:
            self.selected = selected
            self.chosen.emit()
