"""A card that floats over a canvas, and folds to its title."""

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QComboBox, QFrame, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from workbench.language import _
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import TEXT_PX

WIDTH_PX, NARROW_PX = 248, 640


class FoldingCard(QFrame):
    """``title`` over ``body``, ``width`` pixels wide, with larger type wider; over a narrow canvas it begins
    folded.
    """

    folded = Signal(bool)

    def __init__(self, canvas: QWidget, width: int = WIDTH_PX) -> None:
        super().__init__(canvas)
        self.setObjectName("card")
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._narrow = False
        self._standard = self._wide = width
        self.title = QLabel()
        self.title.setTextFormat(Qt.TextFormat.PlainText)  # names that people give are in it
        self.title.setStyleSheet("font-weight: 600;")
        self._fold = QToolButton()
        self._fold.setFixedSize(22, 22)
        set_icon(self._fold, "caret-up", "muted")
        self._fold.setToolTip(_("Fold this card"))
        self._fold.setAccessibleName(_("Fold this card"))
        head = QHBoxLayout()
        head.addWidget(self.title, 1)
        head.addWidget(self._fold)
        self._body = QWidget()
        self._fold.clicked.connect(lambda: self._set_open(self._body.isHidden()))
        self.body = QVBoxLayout(self._body)
        self.body.setContentsMargins(0, 0, 0, 0)
        self.body.setSpacing(8)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(12, 8, 8, 8)
        whole.setSpacing(4)
        whole.addLayout(head)
        whole.addWidget(self._body)
        self._widen()
        canvas.installEventFilter(self)

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
            self.folded.emit(self._body.isHidden())

    def _set_open(self, open_: bool) -> None:
        set_icon(self._fold, "caret-up" if open_ else "caret-down", "muted")
        self._body.setVisible(open_)
        self._fit()
        self.folded.emit(not open_)

    def _fit(self) -> None:
        """As high as what it holds, whose words wrap at its width."""
        layout = self.layout()
        if layout is not None:
            wraps = layout.hasHeightForWidth()
            height = layout.totalHeightForWidth(self._wide) if wraps else layout.totalSizeHint().height()
            self.resize(self._wide, height)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Over a narrow picture it is folded, until somebody opens it, so that the picture is seen."""
        if isinstance(event, QResizeEvent):
            narrow = event.size().width() < NARROW_PX
            if narrow != self._narrow:
                self._narrow = narrow
                self._set_open(not narrow)
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
