"""The coordinates of a colour in one model: a number and a slider for each."""

from collections.abc import Sequence
from typing import NamedTuple

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QSlider, QWidget

from workbench.language import _
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.type_faces import type_scale

_NOTCHES = 1000
_LEAST_PX, _APART_PX = 30, 6


class Coordinate(NamedTuple):
    """Letter, meaning, greatest value, unit, step and least value; ``decimals`` are shown at most."""

    letter: str
    meaning: str
    most: float = 1.0
    unit: str = ""
    step: float = 0.01
    least: float = 0.0
    decimals: int = 4


class NumberSlider(QWidget):
    """One coordinate; ``changed`` sends a value that a hand asks for, ``held`` that the slider is dragged.

    What is wrong with a number is said in ``complaint``: there is no room for it beside the slider.
    """

    changed = Signal(float)
    held = Signal(bool)

    def __init__(self, coordinate: Coordinate, complaint: QLabel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._coordinate = coordinate
        self._showing = False
        self.field = NumberField(
            coordinate.letter,
            coordinate.unit,
            low=coordinate.least,
            high=coordinate.most,
            step=coordinate.step,
            meaning=coordinate.meaning,
            complaint=complaint,
            digits=6,
        )
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, _NOTCHES)
        self.slider.setPageStep(_NOTCHES // 10)
        self.slider.setAccessibleName(coordinate.meaning)
        self.slider.setToolTip(_("{meaning}: drag, or press the arrows").format(meaning=coordinate.meaning))
        self.slider.setMinimumWidth(_LEAST_PX)
        type_scale.changed.connect(self._fit)
        self._fit()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(_APART_PX)
        grid.addWidget(self.field, 0, 0)
        grid.addWidget(self.slider, 0, 1)
        grid.setColumnStretch(1, 1)
        for told in (self.field.edited, self.field.scrubbed):
            told.connect(self.changed)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderPressed.connect(lambda: self.held.emit(True))
        self.slider.sliderReleased.connect(lambda: self.held.emit(False))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where there is no room for a slider beside it, the number stands alone, with its unit."""
        super().resizeEvent(event)
        needed = self.field.sizeHint().width() + _APART_PX + _LEAST_PX
        self.slider.setVisible(event.size().width() >= needed)

    def _fit(self) -> None:
        self.field.setMinimumWidth(self.field.sizeHint().width())

    def _slid(self, notch: int) -> None:
        if not self._showing:
            low, high = self._coordinate.least, self._coordinate.most
            self.changed.emit(round(low + (high - low) * notch / _NOTCHES, 4))

    def set_value(self, value: float) -> None:
        """Show a value."""
        low, high = self._coordinate.least, self._coordinate.most
        self.field.set_value(round(value, self._coordinate.decimals) + 0.0)
        self._showing = True
        if not self.slider.isSliderDown():
            self.slider.setValue(round((value - low) / (high - low) * _NOTCHES))
        self._showing = False


class Sliders(QWidget):
    """Several coordinates one above the other; ``changed`` sends all of them, ``held`` as each of them.

    ``complaint`` is that of each.
    """

    changed = Signal(object)
    held = Signal(bool)

    def __init__(
        self, coordinates: Sequence[Coordinate], complaint: QLabel, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._values = [0.0] * len(coordinates)
        self.parts = [NumberSlider(coordinate, complaint) for coordinate in coordinates]
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(2)
        for number, part in enumerate(self.parts):
            grid.addWidget(part, number, 0)
            part.changed.connect(lambda value, n=number: self._send(n, value))
            part.held.connect(self.held)

    def _send(self, number: int, value: float) -> None:
        values = list(self._values)
        values[number] = float(value)
        self._values = values
        self.changed.emit(tuple(values))

    def set_values(self, values: Sequence[float]) -> None:
        """Show these."""
        self._values = list(values)
        for part, value in zip(self.parts, values, strict=True):
            part.set_value(value)
