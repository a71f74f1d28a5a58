"""What is said over a canvas on which there is nothing yet."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QFrame, QLabel, QPushButton, QVBoxLayout, QWidget

from workbench.language import _

_BESIDE_PX, _GAP_PX = 16, 8
_UNDER_PX = 40
"""Axes and the names of corners stand there."""


class Invitation(QFrame):
    """One sentence and one button in the middle of ``canvas``, or, where there is something to see, ``low``;
    the pointer passes through the sentence.
    """

    def __init__(
        self,
        canvas: QWidget,
        sentence: str,
        act: Callable[[], object],
        button: str = "",
        tip: str = "",
    ) -> None:
        super().__init__(canvas)
        self.setObjectName("card")
        self._usual = sentence
        self.sentence = QLabel(sentence)
        self.sentence.setWordWrap(True)
        self.sentence.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.button = QPushButton(button or _("Show an example"))
        self.button.setToolTip(tip or _("Open a picture that is already drawn"))
        self.button.clicked.connect(lambda: act())
        column = QVBoxLayout(self)
        column.setContentsMargins(_BESIDE_PX, 12, _BESIDE_PX, 12)
        column.setSpacing(8)
        column.addWidget(self.sentence)
        column.addWidget(self.button, 0, Qt.AlignmentFlag.AlignHCenter)
        canvas.installEventFilter(self)
        self.low = False
        self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay in the middle."""
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Show):
            self._centre()
        return False

    def say(self, sentence: str) -> None:
        """Say this, or where it is empty the usual sentence."""
        said = sentence or self._usual
        if said != self.sentence.text():
            self.sentence.setText(said)
            self._centre()

    def setVisible(self, visible: bool) -> None:
        """Shown in the middle."""
        super().setVisible(visible)
        if visible:
            self._centre()

    def _centre(self) -> None:
        canvas = self.parentWidget()
        if canvas is None:
            return
        # A narrow canvas has the sentence in several lines
        least = self.sentence.fontMetrics().horizontalAdvance(self.sentence.text()) + 2
        self.sentence.setFixedWidth(max(1, min(least, canvas.width() - 2 * (_BESIDE_PX + _GAP_PX))))
        self.adjustSize()
        below = canvas.height() - self.height() - _UNDER_PX
        top = below if self.low else min(round(canvas.height() * 0.6), below)
        self.move((canvas.width() - self.width()) // 2, max(0, top))
