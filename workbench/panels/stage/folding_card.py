"""A card that floats over a canvas, and folds to its title."""

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from workbench.language import _
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import TEXT_PX

WIDTH_PX, NARROW_PX = 248, 640
_BELOW_PX = 8


class FoldingCard(QFrame):
    """``title`` over ``body``, ``width`` pixels wide, with larger type wider; over a narrow canvas it begins
    folded. It ends within the canvas: a body that is higher scrolls, beside its bar.
    """

    folded = Signal(bool)

    def __init__(self, canvas: CanvasSurface, width: int = WIDTH_PX) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self.setObjectName("card")
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._narrow = False
        self._standard = self._wide = width
        self.title = QLabel()
        self.title.setTextFormat(Qt.TextFormat.PlainText)  # names that people give are in it
        self.title.setStyleSheet("font-weight: 600;")
        self._fold = QToolButton()
        self._fold.setFixedSize(22, 22)
        self._say_fold(True)
        head = QHBoxLayout()
        head.addWidget(self.title, 1)
        head.addWidget(self._fold)
        self._body = QWidget()
        self._body.setMinimumWidth(1)  # it keeps to the card's width, whatever it asks for
        self._area = QScrollArea()
        self._area.setFrameShape(QFrame.Shape.NoFrame)
        self._area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._area.setWidgetResizable(True)
        self._area.setWidget(self._body)
        self._area.setFixedHeight(0)
        for ground in (self._area.viewport(), self._body):
            ground.setAutoFillBackground(False)
        self._fold.clicked.connect(lambda: self._set_open(self._area.isHidden()))
        self.body = QVBoxLayout(self._body)
        self.body.setContentsMargins(0, 0, 0, 0)
        self.body.setSpacing(8)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(12, 8, 8, 8)
        whole.setSpacing(4)
        whole.addLayout(head)
        whole.addWidget(self._area)
        self._widen()
        canvas.installEventFilter(self)
        self._body.installEventFilter(self)

    def _widen(self) -> None:
        """As wide as its type asks for."""
        self._wide = max(self._standard, round(self._standard * self.fontInfo().pixelSize() / TEXT_PX))
        self.setFixedWidth(self._wide)

    def changeEvent(self, event: QEvent) -> None:
        """Larger type has as many letters in a line as before."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and self.layout() is not None:
            self._widen()
            self._fit()
            self.folded.emit(self._area.isHidden())

    def _say_fold(self, open_: bool) -> None:
        words = _("Fold this card") if open_ else _("Unfold this card")
        set_icon(self._fold, "caret-up" if open_ else "caret-down", "muted")
        self._fold.setToolTip(words)
        self._fold.setAccessibleName(words)

    def _set_open(self, open_: bool) -> None:
        self._say_fold(open_)
        self._area.setVisible(open_)
        self._fit()
        self.folded.emit(not open_)

    def _fit(self) -> None:
        """As high as what it holds, whose words wrap at its width, or as the canvas leaves room for."""
        layout = self.layout()
        if layout is None:
            return
        margins = layout.contentsMargins()
        wide, body = self._wide - margins.left() - margins.right(), self.body
        needed = body.totalHeightForWidth(wide) if body.hasHeightForWidth() else body.totalSizeHint().height()
        hidden = self._area.isHidden()
        around = layout.totalSizeHint().height() - (0 if hidden else self._area.minimumHeight())
        room = max(self._ends_at() - self.y() - _BELOW_PX - around, 0)
        scrolls = needed > room and not hidden
        self._area.setFixedHeight(min(needed, room))
        width = self._wide + (self._area.verticalScrollBar().sizeHint().width() if scrolls else 0)
        changed = width != self.width()
        self.setFixedWidth(width)
        self.resize(width, layout.totalSizeHint().height())
        if changed:
            self.folded.emit(hidden)

    def _ends_at(self) -> int:
        """Where the picture ends, above the numbers of its axis."""
        return int(self._canvas.area.bottom / self._canvas.devicePixelRatioF())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Over a narrow picture it is folded, until somebody opens it, so that the picture is seen."""
        if watched is self._body:
            if event.type() == QEvent.Type.LayoutRequest:
                self._fit()
        elif isinstance(event, QResizeEvent):
            narrow = event.size().width() < NARROW_PX
            if narrow != self._narrow:
                self._narrow = narrow
                self._set_open(not narrow)
            else:
                self._fit()
        return False

    def event(self, event: QEvent) -> bool:
        """As large as what it holds."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self._fit()
        return done


def fill_choices(box: QComboBox, choices: Sequence[tuple[Any, str]], now: object) -> None:
    """Let ``box`` offer these, values and their titles, with ``now`` chosen; hidden where there is none."""
    held = [(box.itemData(k), box.itemText(k)) for k in range(box.count())]
    if held != list(choices):
        box.clear()
        for value, title in choices:
            box.addItem(title, value)
    box.setVisible(bool(choices))
    box.setCurrentIndex(max(0, box.findData(now)))
