"""A derivation as PDF, and the colours that one has on paper."""

from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QSizeF
from PySide6.QtGui import QFont, QGuiApplication, QPageSize, QPainter, QPdfWriter

from workbench.algorithms.marks import INKS
from workbench.exchange.diagrams import Derivation, lay_out_derivation
from workbench.exchange.formulas.layout import Typesetter
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.formulas.typesetting import QtMetrics, paint_primitives
from workbench.widgets.look.tokens import LIGHT

_DOTS_PER_INCH, _POINTS_PER_INCH = 1200, 72


def paper_inks() -> dict[str, str]:
    """The colour of every ink on paper."""
    return {ink: ink_of(LIGHT, ink) for ink in INKS}


def write_pdf(derivation: Derivation) -> bytes:
    """The page as PDF, as large as what is on it."""
    font = QFont(QGuiApplication.font())
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    metrics = QtMetrics(font)
    laid = lay_out_derivation(derivation, Typesetter(metrics))
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QPdfWriter(buffer)
    writer.setResolution(_DOTS_PER_INCH)
    size = QSizeF(laid.width, laid.height)
    writer.setPageSize(QPageSize(size, QPageSize.Unit.Point, "", QPageSize.SizeMatchPolicy.ExactMatch))
    writer.setPageMargins(QMarginsF(0, 0, 0, 0))
    writer.setTitle(derivation.title)
    painter = QPainter(writer)
    try:
        painter.scale(_DOTS_PER_INCH / _POINTS_PER_INCH, _DOTS_PER_INCH / _POINTS_PER_INCH)
        paint_primitives(painter, laid.primitives, metrics, derivation.ink)
    finally:
        painter.end()
    return bytes(buffer.data().data())
