"""The bar over a timeline: frame, playing, how it goes on, rate and length, auto-key, ghosts, zoom."""

from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QWidget

from workbench.document.motion.model import MAX_FRAMES
from workbench.language import _
from workbench.session.frames import Frames, Mode
from workbench.session.session import Session
from workbench.widgets.fields.number_field import EntryLine
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.type_faces import keep_code_font

HEIGHT = 44
_FIELD_PX = 52
_WORDS = Qt.ToolButtonStyle.ToolButtonTextBesideIcon
_SPEEDS = (0.25, 0.5, 1.0, 2.0)


class _Form(NamedTuple):
    """What of the bar is there beside its buttons and the frame."""

    words: bool
    zoom: bool
    rates: bool
    mode: bool


_FORMS = (
    _Form(words=True, zoom=True, rates=True, mode=True),
    _Form(words=False, zoom=True, rates=True, mode=True),
    _Form(words=False, zoom=False, rates=True, mode=True),
    _Form(words=False, zoom=True, rates=False, mode=True),
    _Form(words=False, zoom=True, rates=False, mode=False),
    _Form(words=False, zoom=False, rates=False, mode=False),
)
"""From the widest to the narrowest; the first that fits is taken."""


class Transport(QWidget):
    """Drives the frames of a session. ``said`` sends what was wrong with what was typed.

    ``length_wanted`` and ``rate_wanted`` send what was typed, ``ghosts_toggled`` and ``zoom_wanted`` are for
    the timeline, ``leaving_wanted``: a run is to be stepped no longer.
    """

    said = Signal(str)
    length_wanted = Signal(int)
    rate_wanted = Signal(float)
    ghosts_toggled = Signal(bool)
    zoom_wanted = Signal(float)
    leaving_wanted = Signal()

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._stepping = False
        frames = session.frames
        self.setFixedHeight(HEIGHT)
        self.setAccessibleName(_("Frames"))
        self.leave = self._action(_("Back to the frames"), "arrow-u-up-left", self.leaving_wanted.emit)
        self.first = self._action(_("First frame"), "skip-back", lambda: frames.show(0))
        self.back = self._action(_("Previous frame"), "caret-left", lambda: frames.show(frames.number - 1))
        self.play = self._action(_("Play the frames"), "play", frames.toggle)
        self.forward = self._action(_("Next frame"), "caret-right", lambda: frames.show(frames.number + 1))
        self.last = self._action(_("Last frame"), "skip-forward", lambda: frames.show(frames.count - 1))
        self.frame = self._field(_("Frame"), _("Type a frame and press Enter to go there"), self._go)
        self.length = self._field(
            _("Last frame"),
            _("The number of the last frame; the first is 0"),
            lambda: self._send(self.length),
        )
        self.rate = self._field(
            _("Frames per second"), _("How many frames are shown per second"), lambda: self._send(self.rate)
        )
        self.mode = QComboBox()
        for title, mode in ((_("Loop"), "loop"), (_("Once"), "once"), (_("Back and forth"), "ping_pong")):
            self.mode.addItem(title, mode)
        self.mode.setAccessibleName(_("After the last frame"))
        self.mode.setToolTip(_("What comes after the last frame"))
        self.mode.activated.connect(lambda _index: self._choose_mode(self.mode.currentData()))
        self.speed = QComboBox()
        for speed in _SPEEDS:
            self.speed.addItem(_("{speed:g} ×").format(speed=speed), speed)
        self.speed.setCurrentIndex(_SPEEDS.index(frames.speed))
        self.speed.setAccessibleName(_("Playing speed"))
        self.speed.setToolTip(_("How many times as fast it plays"))
        self.speed.activated.connect(lambda _index: frames.set_speed(self.speed.currentData()))
        self.auto_key = self._action(_("Auto-key"), "record", None)
        self.auto_key.setCheckable(True)
        self.auto_key.setToolTip(_("Whatever you change gets a key in the frame that is shown"))
        self.auto_key.toggled.connect(lambda on: session.update_state(auto_key=on))
        self.curves = self._action(_("Curves"), "chart-line", None)
        self.curves.setCheckable(True)
        self.curves.setToolTip(
            _("The values of the chosen track as a curve, or all tracks (C on the timeline)")
        )
        self.ghosts = self._action(_("Ghosts"), "stack", None)
        self.ghosts.setCheckable(True)
        self.ghosts.setChecked(True)
        self.ghosts.setToolTip(_("Show the frames before and after; drag their reach on the ruler"))
        self.ghosts.toggled.connect(self.ghosts_toggled)
        self.zoom_out = self._action(_("Narrower frames"), "magnifying-glass-minus", self._narrower)
        self.zoom_in = self._action(_("Wider frames"), "magnifying-glass-plus", self._wider)
        self._place()
        frames.played.connect(self._played)

    def _action(self, text: str, icon: str, do: Callable[[], object] | None) -> QAction:
        action = QAction(text, self)
        action.setToolTip(text)
        set_icon(action, icon)
        if do is not None:
            action.triggered.connect(lambda: do())
        return action

    def _field(self, name: str, tip: str, done: Callable[[], object]) -> EntryLine:
        field = EntryLine()
        keep_code_font(field)
        field.setAlignment(Qt.AlignmentFlag.AlignRight)
        field.setFixedWidth(_FIELD_PX)
        field.setAccessibleName(name)
        field.setToolTip(tip)
        field.editingFinished.connect(lambda: done())
        return field

    def _place(self) -> None:
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 0, 8, 0)
        row.setSpacing(2)
        moves = (self.first, self.back, self.play, self.forward, self.last)
        self._leaving = ActionButton(self.leave, style=_WORDS)
        self._moving: list[QWidget] = [ActionButton(action) for action in moves]
        for button in (self._leaving, *self._moving):
            row.addWidget(button)
        row.addSpacing(8)
        self._of, self._a_second = QLabel(_("of")), QLabel(_("per second"))
        self._of.setProperty("role", "muted")
        self._a_second.setProperty("role", "muted")
        fields = (self.frame, self._of, self.length, self.mode, self.speed, self.rate, self._a_second)
        for widget in fields:
            row.addWidget(widget)
            row.addSpacing(12 if widget is self.length else 4)
        self._moving += [self.frame, self._of, self.length]
        row.addStretch(1)
        worded = (self.curves, self.auto_key, self.ghosts)
        self._worded = [ActionButton(action, style=_WORDS) for action in worded]
        for button in self._worded:
            row.addWidget(button)
            row.addSpacing(4)
        row.addSpacing(8)
        self._zooming = [ActionButton(action) for action in (self.zoom_out, self.zoom_in)]
        for button in self._zooming:
            row.addWidget(button)

    def _narrower(self) -> None:
        self.zoom_wanted.emit(0.8)

    def _wider(self) -> None:
        self.zoom_wanted.emit(1.25)

    def _choose_mode(self, mode: Mode) -> None:
        self._session.frames.mode = mode

    def _go(self) -> None:
        if self.frame.isModified():
            self.frame.setModified(False)
            if self.frame.text().strip().isdecimal():
                self._session.frames.show(int(self.frame.text()))
            else:
                self.said.emit(_("A frame is a whole number from 0; type one."))
            self.refresh()

    def _send(self, field: EntryLine) -> None:
        if not field.isModified():
            return
        field.setModified(False)
        try:
            value = float(field.text().replace(",", "."))
        except ValueError:
            self.said.emit(_("“{text}” is not a number; type one such as 24.").format(text=field.text()))
        else:
            if field is self.rate:
                self.rate_wanted.emit(value)
            elif value.is_integer() and 0 <= value < MAX_FRAMES:
                self.length_wanted.emit(int(value) + 1)
            else:
                sentence = _("The last frame cannot be {value:.15g}; give a whole number from 0 to {most}.")
                self.said.emit(sentence.format(value=value, most=MAX_FRAMES - 1))
        self.refresh()

    def refresh(self) -> None:
        """Show the session as it is now."""
        frames: Frames = self._session.frames
        texts = (
            (self.frame, frames.number),
            (self.length, frames.count - 1),
            (self.rate, frames.motion.rate),
        )
        for field, value in texts:
            if not (field.hasFocus() and field.isModified()):
                field.setText(f"{value:g}")
        self.auto_key.setChecked(self._session.state.auto_key)
        set_icon(self.auto_key, "record", "error" if self._session.state.auto_key else "text")

    def minimumSizeHint(self) -> QSize:
        """Narrower than all of it: what has no room goes, and the docks beside it keep theirs."""
        return QSize(0, HEIGHT)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """What has no room goes."""
        super().resizeEvent(event)
        self._fit()

    def set_stepping(self, on: bool) -> None:
        """While a run is stepped elsewhere, nothing here moves the frame; one button leads back."""
        self._stepping = on
        self._fit()

    def _fit(self) -> None:
        layout = self.layout()
        assert layout is not None
        for form in _FORMS:
            self._take_form(form)
            layout.invalidate()
            if layout.minimumSize().width() <= self.width():
                break

    def _take_form(self, form: _Form) -> None:
        plays = not self._stepping
        self._leaving.setVisible(self._stepping)
        for widget in self._moving:
            widget.setVisible(plays)
        for widget in (self.rate, self.speed):
            widget.setVisible(plays and form.rates)
        self._a_second.setVisible(plays and form.rates and form.words)
        self.mode.setVisible(plays and form.mode)
        for button in self._worded:
            button.setToolButtonStyle(_WORDS if form.words else Qt.ToolButtonStyle.ToolButtonIconOnly)
        for button in self._zooming:
            button.setVisible(form.zoom)

    def _played(self, on: bool) -> None:
        words = _("Stop the frames") if on else _("Play the frames")
        set_icon(self.play, "pause" if on else "play")
        self.play.setText(words)
        self.play.setToolTip(words)
