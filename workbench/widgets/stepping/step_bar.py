"""First, back, play, forward, last; speed; a slider; jump to a step; step or detail; ask first."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup, QFontMetrics, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from workbench.language import _
from workbench.session.run import SPEEDS, Run
from workbench.widgets.fields.number_field import EntryLine
from workbench.widgets.fields.option_buttons import OptionButtons
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.type_faces import code_font, keep_code_font, type_scale
from workbench.widgets.stepping.sentence_view import SentenceView
from workbench.widgets.stepping.step_slider import StepSlider

HEIGHT, _NARROW_PX = 44, 700
_DIGITS = 6  # for which there is room in any case
_FRAME = 20  # around the digits
_WORDS = Qt.ToolButtonStyle.ToolButtonTextOnly


def stepping_key(run: Run, event: QKeyEvent) -> Callable[[], object] | None:
    """What a key does that plays a run, steps it or goes to its ends; None for any other, and with Ctrl."""
    if event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
        return None
    keys: dict[int, Callable[[], object]] = {
        Qt.Key.Key_Space: run.toggle_play,
        Qt.Key.Key_Right: run.forward,
        Qt.Key.Key_Left: run.back,
        Qt.Key.Key_Home: run.first,
        Qt.Key.Key_End: run.last,
    }
    return keys.get(event.key())


class StepBar(QWidget):
    """Drives a run. Its actions carry no keys: the shell's table of commands has them."""

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self.setFixedHeight(HEIGHT)
        self.setAccessibleName(_("Step bar"))
        self.first = self._action(_("First step"), _("Go to the start of the run"), "skip-back", run.first)
        self.back = self._action(_("Step back"), _("Go one step back"), "caret-left", run.back)
        self.play = self._action(_("Play"), _("Play the run, or pause"), "play", run.toggle_play)
        self.forward = self._action(_("Step forward"), _("Go one step forward"), "caret-right", run.forward)
        self.last = self._action(_("Last step"), _("Go to the end of the run"), "skip-forward", run.last)
        self.ask = self._action(
            _("Ask first"), _("Choose the next pixel yourself before it is shown"), "", None
        )
        self.ask.setCheckable(True)
        self.ask.toggled.connect(run.set_ask_first)
        self.try_again = self._action(
            _("Try again"), _("Clear the wrong answer and answer again"), "", run.try_again
        )
        self.show_answer = self._action(
            _("Show it"), _("Show the step that was asked for"), "", run.show_answer
        )
        self.slider = StepSlider(run)
        self.jump = EntryLine()
        keep_code_font(self.jump)
        self.jump.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.jump.setAccessibleName(_("Go to step"))
        self.jump.setToolTip(_("Type a step and press Enter to go there"))
        self.jump.editingFinished.connect(self._jump)
        self.total = QLabel()
        keep_code_font(self.total)
        type_scale.changed.connect(self._fit_numbers)
        self._fit_numbers()
        self.total.setProperty("role", "muted")
        self.total.setToolTip(_("How many steps the run has; with +, as far as it is recorded"))
        self.step = self._action(
            _("Step"), _("Count rows of the hand table"), "", lambda: run.set_detail(False)
        )
        self.detail = self._action(
            _("Detail"), _("Count every line that runs"), "", lambda: run.set_detail(True)
        )
        either = QActionGroup(self)
        for action in (self.step, self.detail):
            action.setCheckable(True)
            either.addAction(action)
        self.speed = QComboBox()
        self.speed.addItems([_("{speed:g} / s").format(speed=speed) for speed in SPEEDS])
        self.speed.setAccessibleName(_("Speed"))
        self.speed.setToolTip(_("Steps per second while playing"))
        self.speed.setCurrentIndex(SPEEDS.index(run.speed))
        self.speed.activated.connect(lambda index: run.set_speed(SPEEDS[index]))
        self.stretch_start = self._action(
            _("Detail from the start"), _("Record the start of the run"), "", lambda: run.go_to_number(0)
        )
        self.stretch_next = self._action(
            "", _("Record what comes next"), "", lambda: run.go_to_number(run.passed + run.last_position + 1)
        )
        self.stretch = QToolButton()
        self.stretch.setToolTip(
            _("The run is too long to record whole. Choose a stretch, type a step, or drag the slider")
        )
        self.stretch.setAccessibleName(_("Stretch that is recorded"))
        self.stretch.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.stretch.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.stretch.addActions([self.stretch_start, self.stretch_next])
        self.stretch.hide()
        self._place()
        run.changed.connect(self.refresh)
        for signal in (run.moved, run.grown, run.asked):
            signal.connect(self.refresh)
        run.played.connect(self._played)
        self.refresh()

    def _action(self, text: str, tip: str, icon: str, do: Callable[[], object] | None) -> QAction:
        action = QAction(text, self)
        action.setToolTip(tip)
        if icon:
            set_icon(action, icon)
        if do is not None:
            action.triggered.connect(lambda: do())
        return action

    def _place(self) -> None:
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 0, 8, 0)
        row.setSpacing(2)
        moving = [ActionButton(each) for each in (self.first, self.back, self.play, self.forward, self.last)]
        for button in moving:
            row.addWidget(button)
        self._to_the_ends = moving[0], moving[-1]
        row.addSpacing(8)
        row.addWidget(self.slider, 1)
        row.addSpacing(8)
        row.addWidget(self.jump)
        row.addWidget(self.total)
        row.addWidget(self.stretch)
        row.addSpacing(12)
        row.addWidget(ActionButton(self.step, style=_WORDS))
        row.addWidget(ActionButton(self.detail, style=_WORDS))
        row.addSpacing(8)
        row.addWidget(self.speed)
        row.addSpacing(4)
        row.addWidget(ActionButton(self.ask, style=_WORDS))
        self.after_wrong = [
            ActionButton(action, style=_WORDS) for action in (self.try_again, self.show_answer)
        ]
        for button in self.after_wrong:
            row.addWidget(button)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """In a very narrow window the ends are reached by the slider, and by their keys."""
        super().resizeEvent(event)
        for button in self._to_the_ends:
            button.setVisible(event.size().width() >= _NARROW_PX)

    @property
    def commands(self) -> dict[str, QAction]:
        """The actions by name, for menus and keys."""
        moving = ("first", "back", "play", "forward", "last")
        names = (*moving, "step", "detail", "ask", "try_again", "show_answer")
        return {name: getattr(self, name) for name in names}

    def refresh(self) -> None:
        """Follow the run."""
        run = self._run
        there = run.entry is not None
        for action in (self.first, self.back):
            action.setEnabled(there and run.number > 0)
        further = run.position < run.last_position or (run.goes_on and not run.detail)
        for action in (self.forward, self.last):
            action.setEnabled(there and not run.waiting and further)
        for control in (self.play, self.step, self.detail, self.ask, self.jump, self.speed):
            control.setEnabled(there)
        (self.detail if run.detail else self.step).setChecked(True)
        if self.ask.isChecked() != run.ask_first:
            self.ask.setChecked(run.ask_first)
        for action, button in zip((self.try_again, self.show_answer), self.after_wrong, strict=True):
            button.setVisible(run.ask_first)  # in its place beforehand, so that no answer moves the bar
            action.setEnabled(run.refused)
        self._fit_jump()
        if not (self.jump.hasFocus() and self.jump.isModified()):
            self.jump.setText(str(run.number) if there else "")
        self.total.setText(f"/ {run.total_text}" if there else "")
        self._offer_stretches()

    def _fit_numbers(self) -> None:
        """The bar keeps its shape while the number grows."""
        self.total.setMinimumWidth(QFontMetrics(code_font()).horizontalAdvance("/ 1000000+"))
        self._fit_jump()

    def _fit_jump(self) -> None:
        """Let every step of the run have room in the field."""
        run = self._run
        digits = max(_DIGITS, len(run.total_text.rstrip("+")), len(str(run.number)))
        self.jump.setFixedWidth(QFontMetrics(code_font()).horizontalAdvance("0" * digits) + _FRAME)

    def _offer_stretches(self) -> None:
        """Where a run is too long to be recorded whole, offer what comes before and behind."""
        run = self._run
        self.stretch.setVisible(run.entry is not None and run.in_stretches)
        # In a narrow window there is no room for both, and what is asked is not played.
        self.speed.setVisible(self.stretch.isHidden() or not run.ask_first)
        if self.stretch.isHidden() or run.steps is None:
            return
        first, last = run.passed + 1, run.passed + len(run.steps)
        self.stretch.setText(_("Detail from step {n:,}").format(n=first if run.passed else 0))
        self.stretch_start.setEnabled(run.passed > 0)
        self.stretch_next.setText(_("Detail from step {n:,}").format(n=last))
        self.stretch_next.setEnabled(run.goes_on)

    def _played(self, playing: bool) -> None:
        self.play.setText(_("Pause") if playing else _("Play"))
        set_icon(self.play, "pause" if playing else "play")

    def _jump(self) -> None:
        if not self.jump.isModified():
            return
        self.jump.setModified(False)
        text = self.jump.text().strip()
        if text.isdigit():
            self._run.stay_at(int(text))
        self.refresh()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Space plays, arrows step, Home and End go to the ends, wherever the bar has the focus."""
        do = stepping_key(self._run, event)
        if do is None:
            super().keyPressEvent(event)
        else:
            do()


class Steps(QWidget):
    """The step bar and, under it, the two lines of the sentence, with the choices where one is asked for."""

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("stepsAndSentence")
        self.bar = StepBar(run)
        self.sentence = SentenceView(run)
        self.options = OptionButtons(run)
        told = QHBoxLayout()
        told.setSpacing(0)
        told.addWidget(self.sentence, 1)
        told.addWidget(self.options)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.bar)
        column.addLayout(told)

    def show_buttons(self, on: bool) -> None:
        """Show the buttons over the sentence, or leave the room that they take to what stands above."""
        self.bar.setVisible(on)
