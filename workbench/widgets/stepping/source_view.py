"""The text of the algorithm, exactly as it runs, with the lines of this step marked."""

import inspect
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QSize, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QVBoxLayout, QWidget

from workbench.language import _
from workbench.session.run import Run
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.in_sight import InSight, dock_around
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.stepping.source_text import SourceText

_LINES = 20


class SourceView(QWidget):
    """The entry of a run and all that it calls, one at a time; the function of the current line comes up.
    Behind other tabs it waits until it comes in sight.

    ``refused``: a sentence, when the run does not come to the clicked line again.
    """

    refused = Signal(str)
    example_wanted = Signal()

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self._shown: Callable[..., Any] | None = None
        self._late = False
        self._sight = InSight(self)
        self._sight.changed.connect(self._come_in_sight)
        self._lines = range(0)
        self.text = SourceText()
        self.chooser = QComboBox()
        self.chooser.setAccessibleName(_("Function shown"))
        self.chooser.setToolTip(_("Show the algorithm, or a function that it calls"))
        tell_choice(self.chooser)
        self.chooser.activated.connect(lambda index: self._show(self.chooser.itemText(index)))
        self._head = QWidget()
        head = QHBoxLayout(self._head)
        head.setContentsMargins(8, 4, 8, 4)
        head.addWidget(self.chooser, 1)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._head)
        column.addWidget(self.text, 1)
        self.state = EmptyView(body, _("Draw a figure to see the algorithm that draws it."))
        self.state.wanted.connect(self.example_wanted)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.addWidget(self.state)
        self.setFocusProxy(self.text)
        self.text.line_clicked.connect(self._run_to)
        run.changed.connect(self._take_run)
        run.moved.connect(self.refresh)
        run.grown.connect(self.refresh)
        self._take_run()

    def sizeHint(self) -> QSize:
        """As high as twenty lines of code."""
        lines = _LINES * self.text.fontMetrics().lineSpacing() + 2 * self.text.frameWidth()
        head = 0 if self._head.isHidden() else self._head.sizeHint().height()
        return QSize(super().sizeHint().width(), lines + head)

    @property
    def _waits(self) -> bool:
        """Whether it lies behind other tabs; from then on what it shows is late."""
        self._late = dock_around(self) is not None and not self._sight.now
        return self._late

    def _come_in_sight(self, seen: bool) -> None:
        if seen and self._late:
            self._take_run()

    def _take_run(self) -> None:
        if self._waits:
            return
        recording = self._run.recording
        self.state.set_empty(recording is None)
        names = list(recording.functions) if recording is not None else []
        if names != [self.chooser.itemText(i) for i in range(self.chooser.count())]:
            self.chooser.clear()
            self.chooser.addItems(names)
        self._head.setVisible(len(names) > 1)
        if names and (self._run.entry is None or self._shown is not self._run.entry.function):
            self._show(names[0])
        self.refresh()

    def _show(self, name: str) -> None:
        recording = self._run.recording
        if recording is None or name not in recording.functions:
            return
        function = recording.functions[name]
        if function is not self._shown:
            self._shown = function
            source, first = inspect.getsourcelines(function)
            self._lines = range(first, first + len(source))
            self.text.show_source("".join(source), first)
        self.chooser.setCurrentText(name)
        self.refresh()

    def refresh(self) -> None:
        """Mark the lines of the current step."""
        if self._waits:
            return
        moment = self._run.moment
        if moment is None or self._shown is None:
            self.text.mark(frozenset(), None)
            return
        if self._run.detail and moment.function != self._shown.__name__:
            self._show(moment.function)
            return
        name = self._shown.__name__
        lines = frozenset(line for function, line in self._run.lines_run if function == name)
        here = moment.line if self._run.detail and moment.function == name and not self._run.ended else None
        self.text.mark(lines, here)

    def _run_to(self, line: int) -> None:
        if self._shown is not None and not self._run.run_to_line(line, self._shown.__name__):
            self.refused.emit(_("Line {line} does not run again after this step.").format(line=line))
