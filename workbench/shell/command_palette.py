"""Any command by a few letters of its name (Ctrl+K)."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QModelIndex, QObject, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QKeyEvent, QPainter
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)
from shiboken6 import isValid

from workbench.language import _, legible
from workbench.shell.actions import commands, key_text
from workbench.widgets.look.tokens import colour, tokens

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow

_WIDTH, _HEIGHT, _ROWS = 620, 380, 10
_BESIDE, _WITHIN = 2.0, 2.0
_PADDING_PX, _MARGIN_PX = 5, 10
_OFFER = Qt.ItemDataRole.UserRole
Index = QModelIndex | QPersistentModelIndex


@dataclass(frozen=True, slots=True)
class Offer:
    """One thing that can be done; ``also`` are words it is looked for by, beside its text."""

    text: str
    keys: str
    act: Callable[[], object]
    also: tuple[str, ...] = ()


def match(letters: str, text: str) -> float | None:
    """How well ``letters`` name ``text``, less being better; None when they do not occur in this order, each
    at the beginning of a word or further on in one that was begun.

    A text in which they begin a word as they were typed comes first; letters that begin words or follow each
    other count as near.
    """
    low, typed = text.lower(), letters.strip().lower()
    if _begins_a_word(typed, low):
        return 0.01 * len(text)
    if typed in low:
        return _WITHIN + 0.01 * len(text)
    costs: dict[int, float] | None = None  # of each place where the letter before can stand
    for letter in typed.replace(" ", ""):
        here: dict[int, float] = {}
        for place in (i for i, each in enumerate(low) if each == letter):
            begins = place == 0 or not low[place - 1].isalnum()
            if costs is None:
                ways = [0.5] if begins else []
            else:
                steps = ((cost, _step(low, last, place, begins)) for last, cost in costs.items())
                ways = [cost + step for cost, step in steps if step is not None]
            if ways:
                here[place] = min(ways)
        if not here:
            return None
        costs = here
    return min((costs or {0: 0.0}).values()) + 0.01 * len(text)


def _begins_a_word(typed: str, low: str) -> bool:
    return re.search(rf"(?<!\w){re.escape(typed)}", low) is not None


def _step(low: str, last: int, place: int, begins: bool) -> float | None:
    """What it costs to go on from one letter to another; None where that lies inside of another word."""
    if place == last + 1:
        return 0.0
    if place > last and begins:
        return 0.5
    return 2 + 0.1 * (place - last) if place > last and low[last + 1 : place].isalnum() else None


def _rank(letters: str, offer: Offer) -> float | None:
    """How well the letters name what is offered; words beside its text have to have them as they are, at the
    beginning of a word."""
    cost, typed = match(letters, offer.text), letters.strip().lower()
    if typed and any(_begins_a_word(typed, words.lower()) for words in offer.also):
        cost = min(_BESIDE, _BESIDE if cost is None else cost)
    return cost


def offers(window: "MainWindow") -> list[Offer]:
    """What can be done now: commands, places, docks, the panels' actions, examples, sheets, recent files."""
    made = [
        Offer(
            command.text,
            key_text((*command.keys, command.focused_key)[0]),
            partial(window.do, command),
            (command.tooltip,),
        )
        for command in commands()
        if window.menus.actions[command.id].isEnabled() and command.id != "palette"
    ]
    for slug in window.workspace_slugs:
        title = window.workspace(slug).title
        made.append(Offer(_("Workspace: {title}").format(title=title), "", partial(window.go, slug)))
    made += _pages(window)
    for dock in window.arrangements.docks(window.place):
        bring = partial(window.arrangements.bring_forward, dock.objectName())
        made.append(Offer(_("Show {dock}").format(dock=dock.windowTitle()), "", bring))
    for panel in window.panels(window.place):
        for action in panel.actions():
            if action.isEnabled() and action.text().replace("&", "") not in {offer.text for offer in made}:
                made.append(
                    Offer(
                        action.text().replace("&", ""),
                        action.shortcut().toString(action.shortcut().SequenceFormat.NativeText),
                        action.trigger,
                    )
                )
    for table in window.files.exports.tables():
        made.append(Offer(_("Export a table: {title}").format(title=table.title), "", table.ask))
    if window.session is not None:
        from workbench.document.samples.examples import examples
        from workbench.shell.questions import algorithms_for, questions

        for question in questions():
            if question.workspace in window.workspace_slugs:
                text = _("Question {n}: {text}").format(n=question.number, text=question.text)
                also = (question.topic, *algorithms_for(question.number))
                made.append(Offer(text, "", partial(window.open_question, question), also))
        for example in examples():
            text = _("Example: {title}").format(title=example.title)
            also = (example.description, example.slug)
            made.append(Offer(text, "", partial(window.open_example, example.slug), also))
        sheets = window.session.document.sheets
        for sheet in sheets if len(sheets) > 1 else ():
            text = _("Sheet: {name}").format(name=legible(sheet.name))
            made.append(Offer(text, "", partial(window.files.show_sheet, sheet.id)))
        for path in window.settings.recent():
            text = _("Open {name}").format(name=legible(path.name))
            made.append(Offer(text, "", partial(window.files.open_path, path)))
    return made


def _pages(window: "MainWindow") -> list[Offer]:
    """The pages of the other workspaces; those of this one are among its commands."""
    from workbench.shell.opening import enter_page

    return [
        Offer(
            _("{workspace}: {page}").format(workspace=window.workspace(slug).title, page=row.title),
            "",
            partial(enter_page, window, slug, row.slug),
            (row.tooltip,),
        )
        for slug in window.workspace_slugs
        if slug != window.place
        for row in window.workspace(slug).rows()
    ]


class _WithKeys(QStyledItemDelegate):
    """Paints the keys of a command at the right of its name; a widget for each row would take far longer."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        """High enough to be hit."""
        return QSize(0, option.fontMetrics.height() + 2 * _PADDING_PX)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """The name as ever, then the keys."""
        super().paint(painter, option, index)
        painter.setPen(colour(tokens().muted))
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(option.rect.adjusted(0, 0, -_MARGIN_PX, 0), right, index.data(_OFFER).keys)


def _afloat(window: QWidget) -> QWidget | None:
    """The window of its own that floats over ``window`` and has the focus."""
    active = QApplication.activeWindow()
    above = None if active is None else active.parentWidget()
    while above is not None and above is not window:
        above = above.parentWidget()
    return active if above is not None else None


def _over(active: QWidget) -> QRect:
    """Where it stands over a window that may be smaller, on the screen."""
    screen, there = active.screen().availableGeometry(), active.frameGeometry()
    width, height = min(_WIDTH, screen.width() - 32), min(_HEIGHT, screen.height() - 96)
    left = there.center().x() - width // 2
    return QRect(
        max(screen.left(), min(left, screen.right() - width)),
        max(screen.top(), min(there.top(), screen.bottom() - height)),
        width,
        height,
    )


class CommandPalette(QFrame):
    """A field and a list over the upper part of the window; Esc or a click elsewhere closes it.

    While another window of the program has the focus, as a dock that floats, it is a popup over that one:
    within the main window it would lie behind it, and be typed past.
    """

    def __init__(self, window: "MainWindow") -> None:
        active = _afloat(window)
        super().__init__(active or window, Qt.WindowType.Popup if active else Qt.WindowType.Widget)
        self.setObjectName("palette")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._window = window
        self._back_to = QApplication.focusWidget() or window.focusWidget()
        application = QApplication.instance()
        assert application is not None
        self._application = application
        self.field = QLineEdit()
        self.field.setPlaceholderText(_("Type a few letters of a command"))
        self.field.setAccessibleName(_("Find a command"))
        self.list = QListWidget()
        self.list.setItemDelegate(_WithKeys(self.list))
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setAccessibleName(_("Commands"))
        self._nothing = QLabel(_("Nothing has that name; try another word."))
        self._nothing.setProperty("role", "muted")
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        for part in (self.field, self.list, self._nothing):
            column.addWidget(part)
        self.field.textChanged.connect(self._search)
        self.list.itemClicked.connect(self._run)
        self._application.installEventFilter(self)
        self._search("")
        if window.session is None:
            window.when_ready(self._search_again)
        if active is not None:
            self.setGeometry(_over(active))
        else:
            width = min(_WIDTH, window.width() - 32)
            self.setGeometry((window.width() - width) // 2, 64, width, min(_HEIGHT, window.height() - 96))

    @classmethod
    def open_over(cls, window: "MainWindow") -> "CommandPalette":
        """Show it, in place of one that is there."""
        for earlier in window.findChildren(cls):
            earlier.leave()
        made = cls(window)
        made.show()
        made.raise_()
        made.field.setFocus(Qt.FocusReason.ShortcutFocusReason)
        return made

    def _search_again(self) -> None:
        """More can be done once a session is there."""
        if isValid(self):
            self._search(self.field.text())

    def _search(self, letters: str) -> None:
        ranked = []
        for place, offer in enumerate(offers(self._window)):
            cost = _rank(letters, offer)
            if cost is not None:
                ranked.append((cost if letters else 0.0, place, offer))
        ranked.sort(key=lambda each: each[:2])
        self.list.clear()
        for _cost, _place, offer in ranked:
            item = QListWidgetItem(offer.text, self.list)
            item.setData(_OFFER, offer)
        self.list.setVisible(bool(ranked))
        self._nothing.setVisible(not ranked)
        self.list.setCurrentRow(0)

    def _run(self, item: QListWidgetItem | None) -> None:
        if item is None:
            return
        text = item.data(_OFFER).text
        self.leave()
        # What could be done when this was opened may have gone since.
        offer = next((each for each in offers(self._window) if each.text == text), None)
        if offer is None:
            self._window.say_status(_("{command} can no longer be done here.").format(command=text))
        else:
            offer.act()

    def leave(self) -> None:
        """Close, and give the focus back."""
        self._application.removeEventFilter(self)
        self.close()
        if self._back_to is not None and isValid(self._back_to):
            self._back_to.setFocus()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.MouseButtonPress and isinstance(watched, QWidget):
            # Much that is clicked, as the tabs of docks, takes no focus from the field.
            if watched is not self and not self.isAncestorOf(watched):
                self.leave()
        elif watched is not self.field:
            return False
        elif event.type() == QEvent.Type.FocusOut:
            self.leave()
        elif isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            moves = {
                Qt.Key.Key_Down: 1,
                Qt.Key.Key_Up: -1,
                Qt.Key.Key_PageDown: _ROWS,
                Qt.Key.Key_PageUp: -_ROWS,
            }
            key = Qt.Key(event.key())
            if key in moves:
                last = self.list.count() - 1
                self.list.setCurrentRow(max(0, min(last, self.list.currentRow() + moves[key])))
                return True
            if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                self._run(self.list.currentItem())
                return True
            if key == Qt.Key.Key_Escape:
                self.leave()
                return True
        return super().eventFilter(watched, event)
