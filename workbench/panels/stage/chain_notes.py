"""What the card says of figures that have chains of transforms, and how they get rid of them."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from workbench.document.model import AnyFigure
from workbench.document.transforms.chains import read_only_reason
from workbench.document.transforms.names import title
from workbench.language import _, ngettext
from workbench.rendering.rounds import reason

MOST_NAMED = 6


class ChainNotes(QWidget):
    """Which transforms the selected figures have, what these do to them, and two buttons."""

    bake_wanted = Signal()
    removal_wanted = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.links = _words()
        self.reasons = _words()
        self.reasons.setProperty("role", "muted")
        self.flat = _words()
        self.flat.setProperty("role", "warn")
        self.bake = QPushButton(_("Bake"))
        self.bake.setAccessibleName(_("Bake into the points"))
        self.bake.setToolTip(_("Move the points to where they are seen now, and remove the transforms"))
        self.bake.clicked.connect(self.bake_wanted)
        self.removal = QPushButton(_("Remove"))
        self.removal.setAccessibleName(_("Remove the transforms"))
        self.removal.setToolTip(_("Remove the transforms; the figure goes back to where its points are"))
        self.removal.clicked.connect(self.removal_wanted)
        buttons = QHBoxLayout()
        buttons.setSpacing(8)
        buttons.addWidget(self.bake)
        buttons.addWidget(self.removal)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(4)
        for label in (self.links, self.reasons, self.flat):
            whole.addWidget(label)
        whole.addLayout(buttons)
        self.hide()

    def refresh(self, figures: Sequence[AnyFigure]) -> None:
        """Speak of those of ``figures`` that have transforms; of none, say nothing."""
        chained = [figure for figure in figures if figure.transforms]
        self.setVisible(bool(chained))
        if not chained:
            return
        self.links.setText(_sentence(chained, len(figures)))
        for label, sentences in (
            (self.reasons, {reason(figure) for figure in chained}),
            (self.flat, {read_only_reason(figure) for figure in chained}),
        ):
            text = "\n".join(sorted(sentences - {""}))
            label.setText(text)
            label.setVisible(bool(text))


def _sentence(chained: Sequence[AnyFigure], of: int) -> str:
    """Which transforms one figure has, from the first to act; of several, how many of them have some."""
    if of > 1:
        text = ngettext("{n} figure has transforms.", "{n} figures have transforms.", len(chained))
        return text.format(n=len(chained))
    off = _("{link} (off)")
    names = [title(link) if link.on else off.format(link=title(link)) for link in chained[0].transforms]
    if len(names) > MOST_NAMED:  # the card stands over the picture and has to stay small
        text = _("{n} transforms, the last of them {links}")
        return text.format(n=len(names), links=", ".join(names[-2:]))
    return _("Transforms: {links}").format(links=", ".join(names))


def _words() -> QLabel:
    label = QLabel()
    label.setWordWrap(True)
    return label
