"""The viewing pipeline as a strip of small live pictures; two of its stages are open."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QFont, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QHBoxLayout, QSizePolicy, QWidget

from workbench.language import _
from workbench.panels.viewing.stages import Geometry, Stage, plane_of
from workbench.widgets.canvas.plane import Plane, paint_plane, scene_of
from workbench.widgets.canvas.view import Area
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import RADIUS, theme_changed, tokens

HIGH_PX, LOW_PX = 98, 30
_CAPTION_PX = 24
LEISURE_MS = 40
PIXELS = "device"
_ARROW_PX = 16


class StageTile(QAbstractButton):
    """A stage, small. ``chosen`` sends whether it is to be opened at the right, else at the left."""

    chosen = Signal(bool)

    def __init__(self, stage: Stage, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stage = stage
        self._plane = Plane()
        self._open = False
        self.setText(stage.title)
        self.setAccessibleName(stage.heading)
        self.setToolTip(
            _("{heading}: click to open it at the left, Shift+click at the right").format(
                heading=stage.heading
            )
        )
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        theme_changed.connect(self.update)

    @property
    def plane(self) -> Plane:
        """What it shows."""
        return self._plane

    def set_plane(self, plane: Plane) -> None:
        """What it shows."""
        self._plane = plane
        self.update()

    def set_open(self, is_open: bool) -> None:
        """Frame it, or not."""
        if is_open != self._open:
            self._open = is_open
            self.setAccessibleDescription(_("open") if is_open else "")
            self.update()

    @property
    def is_open(self) -> bool:
        """Whether it is one of the two that are open."""
        return self._open

    def sizeHint(self) -> QSize:
        """As the target has it, or narrower."""
        return QSize(110, HIGH_PX)

    def minimumSizeHint(self) -> QSize:
        """Its name."""
        return QSize(self.fontMetrics().horizontalAdvance(self.text()) + 8, LOW_PX)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A click opens it."""
        inside = self.isDown() and self.rect().contains(event.position().toPoint())
        super().mouseReleaseEvent(event)
        if inside:
            self.chosen.emit(bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter and Space open it."""
        if is_plain(event) and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self.chosen.emit(bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The picture in a frame, where there is room for one, and its name, underlined when open."""
        now, unit = tokens(), self.devicePixelRatioF()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        high = self.height() - _CAPTION_PX
        if high >= LOW_PX:
            self._paint_picture(painter, QRectF(1, 1, self.width() - 2, high - 2), unit)
        font = QFont(self.font())
        font.setBold(self._open)
        painter.setFont(font)
        painter.setPen(QColor(now.text if self._open else now.muted))
        caption = QRectF(0, self.height() - _CAPTION_PX, self.width(), _CAPTION_PX - 3)
        painter.drawText(caption, Qt.AlignmentFlag.AlignCenter, self.text())
        if self._open:
            wide = painter.fontMetrics().horizontalAdvance(self.text())
            line = QRectF((self.width() - wide) / 2, self.height() - 3, wide, 3)
            painter.fillRect(line, QColor(now.accent))
        if self.hasFocus():
            painter.setPen(QPen(QColor(now.accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(caption.adjusted(2, 1, -2, -1), 3, 3)
        painter.end()

    def _paint_picture(self, painter: QPainter, box: QRectF, unit: float) -> None:
        now = tokens()
        painter.save()
        painter.scale(1 / unit, 1 / unit)
        inner = box.adjusted(2, 2, -2, -2)
        left, top, right, bottom = (
            round(side * unit) for side in (inner.left(), inner.top(), inner.right(), inner.bottom())
        )
        # Scene areas begin at the origin of the painter, so that its clip is right.
        scene = scene_of(self._plane, Area(left, top, right, bottom), now, unit, self.font(), small=True)
        painter.fillRect(QRectF(box.left() * unit, box.top() * unit, box.width() * unit, box.height() * unit),
                         QColor(scene.tokens.canvas))  # fmt: skip
        paint_plane(painter, self._plane, scene, small=True)
        painter.restore()
        painter.setPen(QPen(QColor(now.accent if self._open else now.line), 2 if self._open else 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(box, RADIUS / 2, RADIUS / 2)


class _Arrow(QWidget):
    """From one stage to the next."""

    def __init__(self) -> None:
        super().__init__()
        self.setFixedWidth(_ARROW_PX)

    def paintEvent(self, event: QPaintEvent) -> None:
        """A thin arrow at the middle of the pictures."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        painter.setPen(QPen(QColor(tokens().muted), 1.25))
        high = self.height() - _CAPTION_PX
        y = high / 2 if high >= LOW_PX else self.height() / 2
        tip = QPointF(self.width() - 2, y)
        painter.drawLine(QPointF(1, y), tip)
        painter.drawLine(tip, tip + QPointF(-4, -3))
        painter.drawLine(tip, tip + QPointF(-4, 3))
        painter.end()


class StageStrip(QWidget):
    """``opened`` sends the slug of a stage and whether it goes to the right."""

    opened = Signal(str, bool)

    def __init__(self, stages: Sequence[Stage], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.tiles = {stage.slug: StageTile(stage) for stage in stages}
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 6, 8, 2)
        row.setSpacing(3)
        for number, tile in enumerate(self.tiles.values()):
            if number:
                row.addWidget(_Arrow())
            row.addWidget(tile, 1)
            tile.chosen.connect(lambda right, slug=tile.stage.slug: self.opened.emit(slug, right))
        self._geometry: Geometry | None = None
        self._old: list[StageTile] = []
        self._next = QTimer(self)
        self._next.setInterval(LEISURE_MS)
        self._next.timeout.connect(self._show_one)
        self.set_low(False)

    def show_geometry(self, geometry: Geometry, at_leisure: bool) -> None:
        """Show the stages of it: now, or while something is dragged one after the other."""
        self._geometry = geometry
        if not self.pictured:
            return
        # Scan conversion takes longer than a frame has: while something is dragged its picture waits.
        due = [tile for tile in self.tiles.values() if not (at_leisure and tile.stage.slug == PIXELS)]
        self._old += [tile for tile in due if tile not in self._old]
        if at_leisure:
            self._next.start()
            return
        while self._old:
            self._show_one()

    def _show_one(self) -> None:
        """Bring the picture that is shown longest up to date."""
        if not self._old or self._geometry is None:
            self._next.stop()
            return
        tile = self._old.pop(0)
        tile.set_plane(plane_of(tile.stage, self._geometry, small=True))

    def set_low(self, low: bool) -> None:
        """Names only, or pictures too."""
        self.setFixedHeight(LOW_PX if low else HIGH_PX)

    @property
    def pictured(self) -> bool:
        """Whether there is room for the pictures."""
        return self.height() > LOW_PX

    def show_open(self, slugs: Sequence[str]) -> None:
        """Frame the stages that are open."""
        for slug, tile in self.tiles.items():
            tile.set_open(slug in slugs)
