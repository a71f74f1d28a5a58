"""The switches of what is shown of a curve, and its measures in words."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QFrame, QGridLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from workbench.language import _
from workbench.panels.curves.crossings import MOST_PIECES
from workbench.panels.curves.focus import CurveFocus

_WIDE_PX = 300


def switches() -> list[tuple[str, str, str]]:
    """Name, title and meaning of everything that can be switched on, in groups that belong together."""
    return [
        ("construction", _("Construction at u"), _("De Casteljau's or de Boor's levels; drag the ring (U)")),
        ("tangent", _("Tangent"), _("The derivative by u at u, and its direction")),
        ("circle", _("Osculating circle"), _("The circle that bends as the curve does at u")),
        (
            "comb",
            _("Curvature comb"),
            _(
                "Teeth across the curve, longer where it bends more; a jump in them is a jump of "
                "curvature (K)"
            ),
        ),
        ("polygon", _("Control polygon"), _("The legs between the control points, and handles")),
        ("hull", _("Convex hull"), _("The hull of the points; a Bézier curve or B-spline stays within it")),
        ("box", _("Bounding box"), _("The smallest box around the curve itself")),
        ("extrema", _("Extrema"), _("Where x or y turns back")),
        ("inflections", _("Inflections"), _("Where the curve changes the side towards which it bends")),
        (
            "crossings",
            _("Self-intersections"),
            _("Where a curve of up to {most} pieces crosses itself").format(most=MOST_PIECES),
        ),
        ("steps_u", _("Equal steps of u"), _("Points at equal steps of the parameter")),
        (
            "steps_length",
            _("Equal steps of length"),
            _("The same number of points at equal steps along the curve"),
        ),
        (
            "influence",
            _("Region of influence"),
            _("What follows the chosen points"),
        ),
        ("names", _("Names"), _("P0, P1 and so on at the points")),
        ("pixels", _("Full pixels"), _("The pixels in their own colour, not faded")),
    ]


class CurveInsight(QScrollArea):
    """One switch for each thing that can be shown, and a line of words for each measure."""

    def __init__(self, focus: CurveFocus, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._focus = focus
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName(_("What is shown of the curve"))
        inner = QWidget()
        inner.setProperty("role", "surface")
        column = QVBoxLayout(inner)
        column.setContentsMargins(12, 8, 8, 8)
        column.setSpacing(8)
        grid = QGridLayout()
        grid.setHorizontalSpacing(4)
        grid.setVerticalSpacing(4)
        self.boxes: dict[str, QCheckBox] = {}
        for k, (name, title, meaning) in enumerate(switches()):
            box = QCheckBox(title)
            box.setToolTip(meaning)
            box.setChecked(name in focus.shown)
            box.toggled.connect(self._switch(name))
            self.boxes[name] = box
            grid.addWidget(box, k // 2, k % 2)
        column.addLayout(grid)
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.RichText)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.words.setProperty("role", "muted")
        column.addWidget(self.words)
        column.addStretch(1)
        self.setWidget(inner)
        focus.changed.connect(self._follow)

    def _switch(self, name: str) -> Callable[[bool], None]:
        return lambda on: self._focus.switch(name, on)

    def _follow(self) -> None:
        for name, box in self.boxes.items():
            box.setChecked(name in self._focus.shown)

    def say(self, lines: list[tuple[str, str]]) -> None:
        """Show measures: what is measured, and the value with its unit."""
        rows = "".join(
            f"<tr><td style='padding-right:12px'>{name}</td><td>{value}</td></tr>" for name, value in lines
        )
        text = f"<table>{rows}</table>" if lines else _("Draw or select a curve to measure it.")
        if text != self.words.text():
            self.words.setText(text)
