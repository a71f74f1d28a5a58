"""What the chain comes to as a whole: its inverse, the parts that it can be made of, one point in space."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms import transforms
from workbench.algorithms.transforms import Matrix, Parts
from workbench.document.transforms.chains import is_singular
from workbench.document.transforms.stages import Stage, products
from workbench.exchange.formulas.terms import Phrase, Sign, Term, displayed, matrix
from workbench.language import _
from workbench.panels.transform.ground import Ground
from workbench.panels.transform.homogeneous import HomogeneousView
from workbench.panels.transform.told import place_text
from workbench.widgets.formulas.matrix_row import MatrixRow

Place = tuple[float, float]
MOST_FACTORS = 7


def inverse_terms(chain: Sequence[Stage]) -> tuple[Term, ...]:
    """The inverse of a chain, and the inverses of its matrices in the opposite order; none where singular."""
    whole = products(list(chain))[-1]
    if is_singular(whole):
        return ()
    terms: list[Term] = [Phrase("M^{−1}", strong=True), matrix(transforms.inverse(whole))]
    if 1 < len(chain) <= MOST_FACTORS:
        terms += [Sign("="), *(matrix(transforms.inverse(stage.elementary.matrix)) for stage in chain)]
    return tuple(terms)


def parts_terms(parts: Parts) -> tuple[Term, ...]:
    """M = T R S Sh with numbers, and what they make together again."""
    return (
        Phrase("M", strong=True),
        Sign("="),
        matrix(transforms.translation(parts.tx, parts.ty), name="T"),
        matrix(transforms.rotation(parts.theta), name="R"),
        matrix(transforms.scaling(parts.sx, parts.sy), name="S"),
        matrix(transforms.shear(parts.sh, 0.0), name="Sh"),
        Sign("="),
        matrix(transforms.recomposed(parts)),
    )


def parts_told(parts: Parts) -> str:
    """The parts in words, and what is lost."""
    told = _(
        "First sheared by {sh} along x, then scaled by {sx} and {sy}, turned by {angle}°, and moved by {way}."
    ).format(
        sh=displayed(parts.sh),
        sx=displayed(parts.sx),
        sy=displayed(parts.sy),
        angle=displayed(round(math.degrees(parts.theta), 4)),
        way=place_text(parts.tx, parts.ty),
    )
    return " ".join(filter(None, (told, lost(parts))))


def lost(parts: Parts) -> str:
    """What cannot be seen any more of the figure; empty where nothing is lost."""
    if parts.loss.rank == 0:
        return _("Every point lands in one place: nothing of the figure is left.")
    if parts.loss.rank == 1:
        return _("Every point lands on one line: its distance from that line is lost.")
    if parts.loss.mirrored:
        return _("The factor of y is negative: the figure is mirrored, so left and right are exchanged.")
    return ""


class WholeDock(Ground):
    """The inverse, the parts, and homogeneous coordinates, one at a time. ``said`` sends a sentence."""

    said = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._shown: tuple[Sequence[Stage], Place | None] = ((), None)
        self.inverse, self.parts = MatrixRow(upright=2), MatrixRow(upright=2)
        self.backwards, self.told, self.space_told = QLabel(), QLabel(), QLabel()
        self.space = HomogeneousView()
        self.buttons: list[QPushButton] = []
        self._stack = QStackedWidget()
        self._row = QHBoxLayout()
        self._row.setContentsMargins(12, 6, 12, 0)
        self._row.setSpacing(0)
        group = QButtonGroup(self)
        for title, tip, words, view in (
            (_("Inverse"), _("The chain run backwards"), self.backwards, self.inverse),
            (_("Parts"), _("The matrix as M = T R S Sh"), self.told, self.parts),
            (_("Plane w = 1"), _("Homogeneous coordinates of one point"), self.space_told, self.space),
        ):
            button = QPushButton(title)
            button.setCheckable(True)
            button.setProperty("low", True)
            button.setToolTip(tip)
            button.clicked.connect(partial(self._choose, len(self.buttons)))
            group.addButton(button)
            self.buttons.append(button)
            self._row.addWidget(button)
            self._stack.addWidget(_page(words, view))
        self._row.addStretch(1)
        self.buttons[0].setChecked(True)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addLayout(self._row)
        whole.addWidget(self._stack, 1)
        for row in (self.inverse, self.parts):
            row.copied.connect(self.said)

    def follow(self, chain: Sequence[Stage], point: tuple[float, float] | None) -> None:
        """Show the whole of a chain, and ``point`` under it; what is not seen waits until it is."""
        self._shown = chain, point
        self._show_page(self._stack.currentIndex())

    def _choose(self, number: int, *_checked: object) -> None:
        self._stack.setCurrentIndex(number)
        self._show_page(number)

    def _show_page(self, number: int) -> None:
        chain, point = self._shown
        whole = products(list(chain))[-1] if chain else np.eye(3)
        (self._show_inverse, self._show_parts, self._show_point)[number](chain, whole, point)

    def _show_inverse(self, chain: Sequence[Stage], _whole: Matrix, _point: Place | None) -> None:
        back = inverse_terms(chain) if chain else (Phrase("M^{−1}", strong=True), matrix(np.eye(3)))
        self.inverse.set_terms(back)
        self.inverse.setVisible(bool(back))
        self.backwards.setText(_backwards(chain, bool(back)))

    def _show_parts(self, _chain: Sequence[Stage], whole: Matrix, _point: Place | None) -> None:
        parts = transforms.decomposed(whole)
        self.parts.set_terms(parts_terms(parts))
        self.told.setText(parts_told(parts))

    def _show_point(self, _chain: Sequence[Stage], whole: Matrix, point: Place | None) -> None:
        self.space.show_points(point, None if point is None else _image(whole, point))
        self.space_told.setText(
            ""
            if point is None
            else _(
                "{point} is written ({x}, {y}, 1), or as any multiple of that, such as (2x, 2y, 2)."
            ).format(point=place_text(*point), x=displayed(point[0]), y=displayed(point[1]))
        )


def _page(words: QLabel, view: QWidget) -> QScrollArea:
    """A sentence over what it is about."""
    words.setWordWrap(True)
    ground, page = Ground(), QScrollArea()
    column = QVBoxLayout(ground)
    column.setContentsMargins(12, 6, 8, 8)
    column.setSpacing(4)
    column.addWidget(words)
    column.addWidget(view)
    if view.sizePolicy().verticalPolicy() != QSizePolicy.Policy.Expanding:
        column.addStretch(1)
    page.setFrameShape(QFrame.Shape.NoFrame)
    page.setWidgetResizable(True)
    page.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    page.setWidget(ground)
    return page


def _image(whole: Matrix, point: tuple[float, float]) -> tuple[float, float]:
    x, y, _w = (whole @ (*point, 1.0)).tolist()
    return x, y


def _backwards(chain: Sequence[Stage], there: bool) -> str:
    if not there:
        return _("This chain flattens the figure: no matrix can undo it.")
    if len(chain) > 1:
        return _("The inverses of the matrices, the last one undone first.")
    return ""
