"""The status bar: what is under the pointer, what is run, the zoom, and how ready the program is."""

from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QStatusBar

from workbench.language import _

if TYPE_CHECKING:
    from workbench.algorithms.entry import Entry
    from workbench.panels.panel import Panel
    from workbench.session.run import Run

_PASSING_MS = 6000
_ANY_WIDTH = (1 << 24) - 1  # as Qt has it for widgets without a limit
_HOVER, _RUN = 3, 2
"""How the room that zoom and readiness leave is shared."""


class _Words(QLabel):
    """A line of plain text as wide as there is room: its end is cut visibly, and said when pointed at."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.setTextFormat(Qt.TextFormat.PlainText)

    @property
    def wide(self) -> int:
        """The logical pixels that the whole text takes."""
        return self.fontMetrics().horizontalAdvance(self.text()) + 2 * self.margin()

    def setText(self, text: str) -> None:
        """Show another text."""
        super().setText(text)
        self._say_whole()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """More or less of the text is seen."""
        super().resizeEvent(event)
        self._say_whole()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The text, or its beginning."""
        room = self.contentsRect()
        seen = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, room.width())
        painter = QPainter(self)
        self.style().drawItemText(
            painter, room, self.alignment(), self.palette(), self.isEnabled(), seen, self.foregroundRole()
        )
        painter.end()

    def _say_whole(self) -> None:
        whole = self.wide <= self.contentsRect().width()
        self.setToolTip("" if whole else f"<qt>{escape(self.text())}</qt>")


class Status(QObject):
    """Four fields: hover text, run, zoom, readiness.

    Panels fill the first and the third (see ``panels.panel.Said``), the run of the session the second.
    """

    def __init__(self, bar: QStatusBar) -> None:
        super().__init__(bar)
        bar.setSizeGripEnabled(False)
        self.hover = _Words()
        self.run, self.zoom, self.ready = (QLabel() for _field in range(3))
        bar.addWidget(self.hover, _HOVER)
        bar.addWidget(self.run, _RUN)
        bar.addPermanentWidget(self.zoom)
        bar.addPermanentWidget(self.ready)
        for field, name in (
            (self.hover, _("Under the pointer")),
            (self.run, _("Run")),
            (self.zoom, _("Zoom")),
            (self.ready, _("Readiness")),
        ):
            field.setAccessibleName(name)
        self._passing = QTimer(self)
        self._passing.setSingleShot(True)
        self._passing.timeout.connect(lambda: self._tell(""))

    def say(self, text: str) -> None:
        """Say something in passing."""
        self._tell(text)
        self._passing.start(_PASSING_MS)

    def show_hover(self, text: str) -> None:
        """Show what is under the pointer."""
        self._passing.stop()
        self._tell(text)

    def _tell(self, text: str) -> None:
        """A text that does not fit takes the room of the run, too, as long as it is there."""
        self.hover.setText(text)
        own = (self.hover.width() + self.run.width()) * _HOVER / (_HOVER + _RUN)
        self.run.setMaximumWidth(0 if self.hover.wide > own else _ANY_WIDTH)

    def in_workspace(self, steps: bool) -> None:
        """Run and zoom belong to a workspace that steps; other places show neither."""
        self._tell("")
        for field in (self.run, self.zoom):
            field.setVisible(steps)

    def preparing(self, text: str, reason: str = "") -> None:
        """Say what is being prepared, and how far; "" means ready. The reason is said when pointed at."""
        self.ready.setText(text or _("ready"))
        self.ready.setToolTip(reason)
        self.ready.setAccessibleDescription(reason)

    def listen(self, panel: "Panel") -> None:
        """Show what a panel says."""
        said = panel.said()

        def show_zoom(text: str) -> None:
            if panel.center.isVisible():  # a hidden canvas is resized too
                self.zoom.setText(text)

        for signal, slot in ((said.hover, self.show_hover), (said.zoom, show_zoom)):
            if signal is not None:
                signal.connect(slot)

    def follow(self, run: "Run") -> None:
        """Name the run that is stepped, and where it stands."""

        from workbench.rendering.subjects.registry import kind_of

        def tell() -> None:
            self.run.setText("" if run.entry is None else self._run_text(run, run.entry))
            title = "" if run.subject is None else kind_of(run.subject).title
            self.run.setToolTip(title)
            self.run.setAccessibleDescription(title)

        for signal in (run.moved, run.grown):
            signal.connect(tell)
        tell()

    def tell_unfolding(self, ready: int, total: int) -> None:
        """Say how much of a large picture is drawn."""
        if ready < total:
            self.say(_("Drawing figure {n:,} of {total:,}").format(n=ready, total=total))
        else:
            self.say("")

    @staticmethod
    def _run_text(run: "Run", entry: "Entry") -> str:
        text = _("{title}, line {n} of {total}") if run.detail else _("{title}, step {n} of {total}")
        return text.format(title=_(entry.title), n=run.number, total=run.total_text)
