"""The status bar: what is under the pointer, what is run, the zoom, and how ready the program is."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QLabel, QStatusBar

from workbench.language import _
from workbench.widgets.look.elided_label import ElidedLabel

if TYPE_CHECKING:
    from workbench.algorithms.entry import Entry
    from workbench.panels.panel import Panel
    from workbench.session.run import Run

_PASSING_MS = 6000
_ANY_WIDTH = (1 << 24) - 1  # as Qt has it for widgets without a limit
_HOVER, _RUN = 3, 2
"""How the room that zoom and readiness leave is shared."""


class Status(QObject):
    """Four fields: hover text, run, zoom, readiness.

    Panels fill the first and the third (see ``panels.panel.Said``), the run of the session the second.
    """

    def __init__(self, bar: QStatusBar) -> None:
        super().__init__(bar)
        bar.setSizeGripEnabled(False)
        self._zooms: dict[Panel, str] = {}  # what each panel said last
        self.hover = ElidedLabel()
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

    def in_workspace(self, steps: bool, panels: "Iterable[Panel]" = ()) -> None:
        """Run and zoom belong to a workspace that steps, as its panels said it; other places show neither."""
        self._tell("")
        self.zoom.setText("".join(self._zooms.get(panel, "") for panel in panels))
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
            self._zooms[panel] = text
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
