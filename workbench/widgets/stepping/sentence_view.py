"""What this step does, in the height of two lines; the numbers in it are links."""

import re
from html import escape

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAccessible, QAccessibleEvent, QFont, QFontMetrics, QResizeEvent
from PySide6.QtWidgets import QLabel, QWidget

from workbench.engine.sentences import Part
from workbench.language import _
from workbench.session.asking import Answer
from workbench.session.run import Run
from workbench.widgets.look.tokens import CAPTION_PX, TITLE_PX, theme, tokens
from workbench.widgets.look.type_faces import scaled, type_scale

# One letter with one below it, as in r_x; two_dy is a name of the program.
_SUBSCRIPT = re.compile(r"(?<![A-Za-z_])([A-Za-z])_([a-z0-9])(?![A-Za-z0-9_])")
# One letter raised over what it is the exponent of, as in (1 - x)^n.
_POWER = re.compile(r"(?<=[)\w])\^(\w)(?!\w)")


class SentenceView(QLabel):
    """The sentence of the run's cursor. A link to a variable or pixel was pressed, or pointed at ("" and
    None when no longer).
    """

    variable_chosen = Signal(str)
    pixel_chosen = Signal(int, int)
    variable_pointed = Signal(str)
    pixel_pointed = Signal(object)

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self._plain = ""
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setContentsMargins(12, 2, 12, 4)
        self.linkActivated.connect(self._activated)
        self.linkHovered.connect(self._hovered)
        for signal in (run.changed, run.moved, run.grown, run.asked):
            signal.connect(self.refresh)
        theme.changed.connect(self._write)
        type_scale.changed.connect(self._take_type)
        self._parts: tuple[Part, ...] = ()
        self._take_type()
        self.refresh()

    def _take_type(self) -> None:
        """Two lines of the type as large as it is now."""
        font = self.font()
        font.setPixelSize(scaled(TITLE_PX))
        self.setFont(font)
        self.setStyleSheet(f"font-size: {scaled(TITLE_PX)}px")
        self.setFixedHeight(2 * self.fontMetrics().lineSpacing() + 8)
        self._write()

    def refresh(self) -> None:
        """Say what the cursor's step does, and announce it when it is new."""
        self._parts = self._words()
        plain = "".join(part.text for part in self._parts)
        if plain == self._plain:
            return
        self._plain = plain
        self._write()
        self.setAccessibleName(plain)
        self.setToolTip(plain)
        self._announce(plain)

    @property
    def plain(self) -> str:
        """The sentence as it is read aloud."""
        return self._plain

    def _words(self) -> tuple[Part, ...]:
        run = self._run
        answered = run.answered
        if answered is not None and answered.verdict != "right":
            return (Part(_not_right(answered), None), Part(" ", None), self._score())
        right = (Part(_("Right. "), None),) if answered is not None else ()
        ends = run.ask_first and run.ended and bool(run.right + run.wrong)
        score = (Part(" ", None), self._score()) if (right or ends) and not run.waiting else ()
        return (*right, *self._told(), *score)

    def _score(self) -> Part:
        score = _("First tries: {right} right, {wrong} wrong.").format(
            right=self._run.right, wrong=self._run.wrong
        )
        return Part(score, None)

    def _told(self) -> tuple[Part, ...]:
        """What the run says, and what it asks."""
        run = self._run
        if run.entry is None:
            return (Part(run.before() or run.invitation, None),)
        if run.waiting:
            score = _("Which pixel comes next? Click it. First tries: {right} right, {wrong} wrong.")
            if run.options:
                score = _("What comes next? First tries: {right} right, {wrong} wrong.")
            asked = Part(score.format(right=run.right, wrong=run.wrong), None)
            return (*run.sentence, Part(" ", None), asked) if run.position else (asked,)
        parts = run.sentence
        if run.message and run.done and (run.position >= run.last_position or not parts):
            parts = (
                (*parts, Part(" ", None), Part(run.message, None)) if parts else (Part(run.message, None),)
            )
        if not parts and run.recording is not None and not len(run.recording):
            return (Part(_("Recording the run ..."), None),)
        if not parts and not run.position and run.last_position:
            begin = _("{summary} Press the right arrow key for the first step.")
            return (Part(begin.format(summary=_(run.entry.summary)), None),)
        return parts

    def _write(self) -> None:
        accent = tokens().accent
        pieces = []
        for number, part in enumerate(self._parts):
            text = _SUBSCRIPT.sub(r"\1<sub>\2</sub>", escape(part.text))
            text = _POWER.sub(r"<sup>\1</sup>", text)
            if part.link is None:
                pieces.append(text)
            else:
                style = f"color:{accent}; text-decoration:none; font-weight:600"
                pieces.append(f'<a href="{number}" style="{style}">{text}</a>')
        self.setText(f'<span style="font-size:{self._fitting_px()}px">{"".join(pieces)}</span>')

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Write a long sentence as large as it fits."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._write()

    def _fitting_px(self) -> int:
        """The largest type in which the whole sentence fits, its numbers being bold."""
        room = self.contentsRect()
        font = QFont(self.font())
        font.setBold(any(part.link is not None for part in self._parts))
        for size in range(scaled(TITLE_PX), scaled(CAPTION_PX), -1):
            font.setPixelSize(size)
            box = QFontMetrics(font).boundingRect(
                0, 0, room.width(), room.height(), Qt.TextFlag.TextWordWrap, self._plain
            )
            if box.height() <= room.height():
                return size
        return scaled(CAPTION_PX)

    def _announce(self, text: str) -> None:
        if not QAccessible.isActive() or not text:
            return
        try:
            from PySide6.QtGui import QAccessibleAnnouncementEvent
        except ImportError:
            QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.NameChanged))
            return
        QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, text))

    def _link(self, target: str) -> Part | None:
        return self._parts[int(target)] if target.isdigit() and int(target) < len(self._parts) else None

    def _activated(self, target: str) -> None:
        part = self._link(target)
        if part is None or part.link is None:
            return
        if part.link[0] == "variable":
            self.variable_chosen.emit(part.link[1])
        else:
            self.pixel_chosen.emit(*part.link[1])

    def _hovered(self, target: str) -> None:
        part = self._link(target)
        link = part.link if part is not None else None
        self.variable_pointed.emit(link[1] if link is not None and link[0] == "variable" else "")
        self.pixel_pointed.emit(link[1] if link is not None and link[0] == "pixel" else None)


def _not_right(answered: Answer) -> str:
    """What is said of an answer that does not show the step."""
    if answered.verdict == "far":
        far = _("({x}, {y}) is far from the pixels in question, so it does not count. Click one near them.")
        return far.format(x=answered.given[0], y=answered.given[1])
    if answered.cell is None:
        said = _("No: “{choice}” is not what comes next. Try again, or have it shown.")
        return said.format(choice=_(str(answered.given)))
    said = _("No: ({x}, {y}) does not come next. Try again, or have it shown.")
    return said.format(x=answered.cell[0], y=answered.cell[1])
