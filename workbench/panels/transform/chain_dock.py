"""The chain of the figure that is worked on, as cards: added, changed, moved, switched and removed."""

from collections.abc import Callable
from functools import partial

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

from workbench.document.building import Edit
from workbench.document.edits import set_attribute
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure
from workbench.document.transforms.chains import is_singular
from workbench.document.transforms.edits import (
    add_transform,
    remove_transform,
    reorder_transform,
    switch_transform,
)
from workbench.document.transforms.links import Affine, AnyLink, Reflect, Rotate, Scale, Shear, Translate
from workbench.document.transforms.names import undo_names
from workbench.document.transforms.stages import stages
from workbench.language import _
from workbench.panels.transform.ground import Ground
from workbench.panels.transform.link_card import LinkCard, complaint_of
from workbench.session.session import Session
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import tokens

Pivot = tuple[float, float]


def offers() -> list[tuple[str, Callable[[Pivot], AnyLink]]]:
    """What can be added: its title, and the link about a pivot where it has one."""
    return [
        (_("Translation"), lambda _p: Translate("", tx=2.0, ty=1.0)),
        (_("Rotation about the pivot"), lambda p: Rotate("", angle=45.0, x_pivot=p[0], y_pivot=p[1])),
        (_("Scaling about the pivot"), lambda p: Scale("", sx=1.5, sy=1.5, x_pivot=p[0], y_pivot=p[1])),
        (_("Reflection in the x axis"), lambda _p: Reflect("", angle=0.0)),
        (_("Reflection in the y axis"), lambda _p: Reflect("", angle=90.0)),
        (_("Reflection in the origin"), lambda _p: Reflect("", mirror="point")),
        (_("Reflection in the line y = x"), lambda _p: Reflect("", angle=45.0)),
        (
            _("Reflection in a line through the pivot"),
            lambda p: Reflect("", angle=30.0, x_pivot=p[0], y_pivot=p[1]),
        ),
        (_("Shear along x"), lambda _p: Shear("", sh_x=0.5)),
        (_("Shear along y"), lambda _p: Shear("", sh_y=0.5)),
        (_("Matrix, typed"), lambda _p: Affine("")),
    ]


class ChainDock(Ground):
    """Shows and edits the chain of a figure. ``stage_pointed`` sends a stage or None, ``said`` a sentence."""

    stage_pointed = Signal(object)
    said = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._figure: AnyFigure | None = None
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
        for title, make in offers():
            self.menu.addAction(title, partial(self.append, make))
        self.add.setMenu(self.menu)
        head = QHBoxLayout()
        head.addWidget(self.heading, 1)
        head.addWidget(self.add)
        self.sentence = QLabel()
        self.sentence.setWordWrap(True)
        self.sentence.setProperty("role", "muted")
        self.first = QPushButton(_("Add a rotation"))
        self.first.setToolTip(_("Turn the figure by 45° about the pivot"))
        self.first.clicked.connect(partial(self.append, offers()[1][1]))
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

    def follow(self, figure: AnyFigure | None, lit: int | None) -> None:
        """Show the chain of ``figure`` as it is now; ``lit`` marks a stage."""
        self._figure = figure
        chain = () if figure is None else figure.transforms
        acting = stages(chain)
        note = f'<span style="color:{tokens().muted}">{_("acts from the top down")}</span>'
        self.heading.setText(f"<b>{_('Chain')}</b> {note if chain else ''}")
        self.add.setEnabled(figure is not None)
        self.sentence.setText(
            _("Draw or select a figure to transform it.")
            if figure is None
            else _("This figure stands as it was drawn.")
        )
        self.sentence.setVisible(not chain)
        self.first.setVisible(figure is not None and not chain)
        self._fit_cards(chain)
        for card, link in zip(self.cards, chain, strict=True):
            own = [stage for stage in acting if stage.link.id == link.id]
            card.show_link(link, own, len(acting), lit)
        whole = figure is not None and is_singular(figure.matrix) and not any(map(complaint_of, chain))
        self.trouble.setText(
            _("Together the links flatten the figure, so handles are gone; change or switch off one.")
            if whole
            else ""
        )
        self.trouble.setVisible(whole)

    def _fit_cards(self, chain: tuple[AnyLink, ...]) -> None:
        """As many cards as links, each kept where it still fits."""
        kept = {card.identity: card for card in self.cards}
        cards = []
        for link in chain:
            card = kept.get(link.id)
            if card is None or not card.fits(link, len(link.unfolded())):
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

    def _made(self, link: AnyLink) -> LinkCard:
        card = LinkCard(link, len(link.unfolded()))
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

    def append(self, make: Callable[[Pivot], AnyLink], *_checked: object) -> None:
        """Put a link at the end of the chain."""
        if self._figure is not None:
            link = make(self.pivot())
            self._apply(add_transform(self._figure.id, link), undo_names()["add_transform"])

    def _address(self, link: str, attribute: str = "on") -> str:
        assert self._figure is not None
        return f"{self._session.sheet.id}/{self._figure.id}/{link}/{attribute}"

    def set_number(self, link: str, attribute: str, value: float, merge: str = "") -> str:
        """Set a number of a link; the sentence that says why it was refused, or an empty one."""
        if self._figure is None or not np.isfinite(value):
            return _("Type a number.")
        address = self._address(link, attribute)
        return self._apply(set_attribute(address, value), _("Change value"), merge and f"{merge} {address}")

    def _set(self, card: LinkCard, attribute: str, value: float, scrubbed: bool) -> None:
        refusal = self.set_number(card.identity, attribute, value, "scrub" if scrubbed else "")
        if refusal and self._figure is not None:
            link = next((each for each in self._figure.transforms if each.id == card.identity), None)
            if link is not None:
                card.fields[attribute].refuse(refusal, round(getattr(link, attribute), 6))

    def _switch(self, card: LinkCard, on: bool) -> None:
        self._apply(switch_transform(self._address(card.identity), on), undo_names()["switch_transform"])

    def _remove(self, card: LinkCard) -> None:
        self._apply(remove_transform(self._address(card.identity)), undo_names()["remove_transform"])

    def _move(self, card: LinkCard, by: int, merge: str = "") -> None:
        at = self.cards.index(card) + by
        if 0 <= at < len(self.cards):
            edit = reorder_transform(self._address(card.identity), at)
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
