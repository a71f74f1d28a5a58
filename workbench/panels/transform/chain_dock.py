"""The chain of the figure that is worked on, as cards: added, changed, moved, switched and removed."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Protocol

import numpy as np
from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
)

from workbench.algorithms.transforms import Matrix
from workbench.document.building import Edit
from workbench.document.edits import set_attribute
from workbench.document.errors import DocumentError
from workbench.document.transforms.chains import is_singular
from workbench.document.transforms.links import Link
from workbench.document.transforms.names import undo_names
from workbench.language import _
from workbench.panels.transform.chain_edits import ChainEdits, FigureChain, Pivot
from workbench.panels.transform.ground import Ground
from workbench.panels.transform.link_card import LinkCard, complaint_of
from workbench.session.session import Session
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import tokens


class Chained(Protocol):
    """A figure, or an object of a scene."""

    @property
    def id(self) -> str:
        """Its id."""

    @property
    def transforms(self) -> tuple[Any, ...]:
        """The links of its chain."""

    @property
    def matrix(self) -> Matrix | None:
        """That of its chain; None where nothing is transformed."""


class ChainDock(Ground):
    """Shows and edits the chain of a thing: of a figure, or by other ``edits`` of something else.
    ``stage_pointed`` sends a stage or None, ``said`` a sentence.
    """

    stage_pointed = Signal(object)
    said = Signal(str)

    def __init__(self, session: Session, edits: ChainEdits | None = None) -> None:
        super().__init__()
        self._session = session
        self._edits: ChainEdits = edits or FigureChain()
        self._thing: Chained | None = None
        self.pivot: Callable[[], Pivot] = lambda: (0.0, 0.0)
        self.cards: list[LinkCard] = []
        self.heading = QLabel()
        self.heading.setTextFormat(Qt.TextFormat.RichText)
        self.add = QToolButton()
        self.add.setText(_("Add a link"))
        self.add.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.add.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.add.setToolTip(_("Put another transform at the end of the chain"))
        set_icon(self.add, "plus")
        self.menu = QMenu(self.add)
        for title, make in self._edits.offers():
            self.menu.addAction(title, partial(self.append, make))
        self.add.setMenu(self.menu)
        head = QHBoxLayout()
        head.addWidget(self.heading, 1)
        head.addWidget(self.add)
        self.sentence = QLabel()
        self.sentence.setWordWrap(True)
        self.sentence.setProperty("role", "muted")
        self.first = QPushButton(_("Add a rotation"))
        self.first.setToolTip(self._edits.offers()[1][0])
        self.first.clicked.connect(partial(self.append, self._edits.offers()[1][1]))
        self.trouble = QLabel()
        self.trouble.setWordWrap(True)
        self.trouble.setProperty("role", "error")
        ground = Ground()
        self._column = QVBoxLayout(ground)
        self._column.setContentsMargins(8, 4, 8, 8)
        self._column.setSpacing(6)
        self._column.addWidget(self.sentence)
        self._column.addWidget(self.first, 0, Qt.AlignmentFlag.AlignLeft)
        self._column.addWidget(self.trouble)
        self._column.addStretch(1)
        scroll = QScrollArea()
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setWidgetResizable(True)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setWidget(ground)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 4, 0, 0)
        whole.setSpacing(2)
        head.setContentsMargins(12, 2, 12, 2)
        whole.addLayout(head)
        whole.addWidget(scroll, 1)
        self.follow(None, None)

    def follow(self, thing: Chained | None, lit: int | None) -> None:
        """Show the chain of a thing as it is now; ``lit`` marks a stage."""
        self._thing = thing
        chain = () if thing is None else thing.transforms
        told = self._edits.stages(chain)
        note = f'<span style="color:{tokens().muted}">{_("applied from the top down")}</span>'
        self.heading.setText(f"<b>{_('Chain')}</b> {note if chain else ''}")
        self.add.setEnabled(thing is not None)
        self.sentence.setText(self._edits.none if thing is None else self._edits.bare)
        self.sentence.setVisible(not chain)
        self.first.setVisible(thing is not None and not chain)
        self._fit_cards(chain)
        count = sum(map(len, told.values()))
        for card, link in zip(self.cards, chain, strict=True):
            card.show_link(link, told.get(link.id, []), count, lit)
        whole = thing is not None and is_singular(thing.matrix) and not any(map(complaint_of, chain))
        self.trouble.setText(
            _(
                "Together the links flatten the figure, so it has no handles; change or switch "
                "off one of them."
            )
            if whole
            else ""
        )
        self.trouble.setVisible(whole)

    def _fit_cards(self, chain: Sequence[Link]) -> None:
        """As many cards as links, each kept where it still fits."""
        kept = {card.identity: card for card in self.cards}
        cards = []
        for link in chain:
            card = kept.get(link.id)
            if card is None or not card.fits(link):
                card = self._made(link)
            else:
                del kept[link.id]
            cards.append(card)
        for card in self.cards:
            if card not in cards:
                for field in card.fields.values():
                    field.blockSignals(True)
                card.hide()
                card.deleteLater()
        if cards != self.cards:
            self.cards = cards
            for place, card in enumerate(cards, 2):
                self._column.removeWidget(card)
                self._column.insertWidget(place, card)
                card.show()

    def _made(self, link: Link) -> LinkCard:
        card = LinkCard(link)
        card.changed.connect(partial(self._set, card))
        card.scrub_ended.connect(self._session.end_merge)
        card.switched.connect(partial(self._switch, card))
        card.removed.connect(partial(self._remove, card))
        card.stage_pointed.connect(self.stage_pointed)
        card.grip.moved.connect(partial(self._move, card))
        card.grip.dragged.connect(partial(self._drag, card))
        card.grip.dropped.connect(self._session.end_merge)
        return card

    # What is done

    def append(self, make: Callable[[Pivot], Link], *_checked: object) -> None:
        """Put a link at the end of the chain."""
        if self._thing is not None:
            self._apply(self._edits.add(self._thing.id, make(self.pivot())), undo_names()["add_transform"])

    def _address(self, link: str, attribute: str = "on") -> str:
        assert self._thing is not None
        return f"{self._session.sheet.id}/{self._thing.id}/{link}/{attribute}"

    def set_number(self, link: str, attribute: str, value: float, merge: str = "") -> str:
        """Set a number of a link; the sentence that says why it was refused, or an empty one."""
        if self._thing is None or not np.isfinite(value):
            return _("Type a number.")
        address = self._address(link, attribute)
        return self._apply(set_attribute(address, value), _("Change value"), merge and f"{merge} {address}")

    def _set(self, card: LinkCard, attribute: str, value: float, scrubbed: bool) -> None:
        refusal = self.set_number(card.identity, attribute, value, "scrub" if scrubbed else "")
        link = self._link_of(card)
        if refusal and link is not None:
            card.fields[attribute].refuse(refusal, round(getattr(link, attribute), 6))

    def _link_of(self, card: LinkCard) -> Link | None:
        chain = () if self._thing is None else self._thing.transforms
        return next((link for link in chain if link.id == card.identity), None)

    def _switch(self, card: LinkCard, on: bool) -> None:
        edit = self._edits.switch(self._address(card.identity), self._link_of(card), on)
        self._apply(edit, undo_names()["switch_transform"])

    def _remove(self, card: LinkCard) -> None:
        edit = self._edits.remove(self._address(card.identity))
        self._apply(edit, undo_names()["remove_transform"])

    def _move(self, card: LinkCard, by: int, merge: str = "") -> None:
        at = self.cards.index(card) + by
        if 0 <= at < len(self.cards):
            edit = self._edits.reorder(self._address(card.identity), at)
            self._apply(edit, undo_names()["reorder_transform"], merge)

    def _drag(self, card: LinkCard, place: QPoint) -> None:
        """Past the middle of a neighbour the card takes its place."""
        at = self.cards.index(card)
        for by in (-1, 1):
            if 0 <= at + by < len(self.cards):
                other = self.cards[at + by]
                beyond = other.mapFromGlobal(place).y() - other.height() / 2
                if beyond * by > 0:
                    self._move(card, by, f"drag link {card.identity}")
                    return

    def _apply(self, edit: Edit, name: str, merge: str = "") -> str:
        try:
            self._session.apply(edit, name, merge)
        except DocumentError as problem:
            self.said.emit(problem.short)
            return problem.short
        return ""
