"""Flicker in numbers: by formula beside what was measured, and what an eye makes of it."""

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QSizePolicy, QWidget

from workbench.display.flicker import EYE_S, Flicker, fusion_hz, share_later, smears
from workbench.display.phosphor import Phosphor, doubts
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.scrolled import scrolled
from workbench.widgets.look.tokens import CAPTION_PX
from workbench.widgets.look.type_faces import keep_code_font

_NOT_YET = "\N{HORIZONTAL ELLIPSIS}"


def _texts(flicker: Flicker | None) -> tuple[str, str, str]:
    if flicker is None:
        return _NOT_YET, _NOT_YET, _NOT_YET
    percent, index, modulation = flicker
    return f"{100.0 * percent:.1f} %", f"{index:.3f}", f"{modulation:.3f}"


class MeasuresView(QWidget):
    """Three measures in two columns, and the verdict; ``corner`` stands beside the headings."""

    def __init__(self, corner: Sequence[QWidget], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self.table = Table(("", _("formula"), _("measured")), [], formulas=False)
        grid = QGridLayout(self)
        grid.setContentsMargins(8, 4, 8, 4)
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(2)
        titles = (
            (_("Percent flicker"), _("(most \N{MINUS SIGN} least) / (most + least)")),
            (_("Flicker index"), _("The area above the mean over the whole area")),
            (_("Modulation"), _("Amplitude of the fundamental over the mean, at most 2")),
        )
        self.names = tuple(title for title, _meaning in titles)
        beside = QHBoxLayout()
        beside.setSpacing(8)
        for field in corner:
            beside.addWidget(field)
        grid.addLayout(beside, 0, 0)
        for column, heading in enumerate(self.table.columns[1:], 1):
            label = QLabel(heading)
            label.setProperty("role", "caption")
            label.setAlignment(Qt.AlignmentFlag.AlignRight)
            grid.addWidget(label, 0, column)
        self._values = [[QLabel(), QLabel()] for _measure in titles]
        for row, (title, meaning) in enumerate(titles, 1):
            name = QLabel(title)
            name.setToolTip(meaning)
            grid.addWidget(name, row, 0)
            for column, value in enumerate(self._values[row - 1], 1):
                keep_code_font(value, CAPTION_PX + 1)
                value.setAlignment(Qt.AlignmentFlag.AlignRight)
                value.setToolTip(meaning)
                grid.addWidget(value, row, column)
        self.verdict = QLabel()
        self.verdict.setWordWrap(True)
        self.verdict.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._told = scrolled(self.verdict)
        grid.addWidget(self._told, 4, 0, 1, 3)
        grid.setRowStretch(4, 1)

    def be_low(self, low: bool) -> None:
        """Leave the verdict to the map, which says it too, and to the tooltip, where there is little room."""
        self._told.setVisible(not low)

    def show_measures(
        self, formula: Flicker, measured: Flicker | None, phosphor: Phosphor, refresh_hz: float, cd_m2: float
    ) -> None:
        """Show them; ``measured`` is None until it is."""
        columns = _texts(formula), _texts(measured)
        for row, labels in enumerate(self._values):
            for label, column in zip(labels, columns, strict=True):
                label.setText(column[row])
        self.table = Table(self.table.columns, list(zip(self.names, *columns, strict=True)), formulas=False)
        self.verdict.setText(f"{verdict(phosphor, refresh_hz, cd_m2)} {doubt(phosphor)}")
        self.setToolTip(self.verdict.text())


def verdict(phosphor: Phosphor, refresh_hz: float, cd_m2: float) -> str:
    """Whether an eye sees it flicker, and whether what moves leaves a trail."""
    fusion = fusion_hz(phosphor, cd_m2)
    if refresh_hz < fusion:
        said = _("At {cd:g} cd/m\N{SUPERSCRIPT TWO} it fuses from {fusion:.1f} Hz: {rate:.4g} Hz flickers.")
    else:
        said = _("At {cd:g} cd/m\N{SUPERSCRIPT TWO} it fuses from {fusion:.1f} Hz: {rate:.4g} Hz is steady.")
    if smears(phosphor):
        trail = _("{share:.2g}\N{NO-BREAK SPACE}% of the light comes after {ms:g} ms: what moves smears.")
    else:
        trail = _("{share:.2g}\N{NO-BREAK SPACE}% of the light comes after {ms:g} ms: no trail is seen.")
    later = 100.0 * share_later(phosphor, EYE_S)
    seen = said.format(cd=cd_m2, fusion=fusion, rate=refresh_hz)
    return f"{seen} {trail.format(share=later, ms=1e3 * EYE_S)}"


def doubt(phosphor: Phosphor) -> str:
    """What is uncertain of all this."""
    of_the_eye = _("The rate above which the eye sees no flicker is uncertain by about 10 Hz.")
    if not phosphor.uncertain_fields:
        return of_the_eye
    own = _("Also uncertain for {name}: {fields}.").format(name=phosphor.name, fields=doubts(phosphor))
    return f"{of_the_eye} {own}"
