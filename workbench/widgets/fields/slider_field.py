"""A number that is dragged, typed or scrubbed: a field with a slider beside it."""

import math

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QSlider, QVBoxLayout, QWidget

from workbench.widgets.fields.number_field import NumberField, complaint_label

_STEPS = 1000
_LABEL_PX, _FIELD_PX, _UNIT_PX = 30, 68, 16
_LEAST_SLIDER_PX = 40
_TIGHT_FIELD_PX, _TIGHT_SLIDER_PX = 56, 24


class SliderField(QWidget):
    """``edited`` sends each value that a person gives; ``ended`` follows a drag, or what was typed.

    ``span`` is what the slider reaches, where that is less than ``low`` to ``high``; a ``logarithmic`` one
    gives every decade the same room. What is wrong with what was typed is said below both.
    """

    edited = Signal(float)
    ended = Signal()

    def __init__(
        self,
        label: str,
        unit: str,
        meaning: str,
        low: float,
        high: float,
        *,
        span: tuple[float, float] | None = None,
        step: float = 1.0,
        logarithmic: bool = False,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._span = span or (low, high)
        self._logarithmic = logarithmic
        self._step = step
        self._showing = False
        complaint = complaint_label()
        self.number = NumberField(
            label, unit, low=low, high=high, step=step, meaning=meaning, complaint=complaint
        )
        self.number.label.setMinimumWidth(_LABEL_PX)
        self.number.field.setFixedWidth(_FIELD_PX)
        self.number.unit.setMinimumWidth(_UNIT_PX)
        self.number.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, _STEPS)
        self.slider.setPageStep(_STEPS // 20)
        self.slider.setMinimumWidth(_LEAST_SLIDER_PX)
        self.slider.setAccessibleName(meaning)
        self.slider.setToolTip(meaning)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(self.number)
        row.addWidget(self.slider, 1)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(2)
        whole.addLayout(row)
        whole.addWidget(complaint)
        self.setFocusProxy(self.number)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(self.ended)
        self.number.edited.connect(self._typed)
        self.number.scrubbed.connect(self._scrubbed)
        self.number.scrub_ended.connect(self.ended)

    def be_tight(self, on: bool) -> None:
        """Have room for fewer digits, where several stand beside one another."""
        self.number.field.setFixedWidth(_TIGHT_FIELD_PX if on else _FIELD_PX)
        self.number.unit.setMinimumWidth(0 if on else _UNIT_PX)
        self.slider.setMinimumWidth(_TIGHT_SLIDER_PX if on else _LEAST_SLIDER_PX)

    def value(self) -> float:
        """The last good value."""
        return self.number.value()

    def belong_to(self, owner: object) -> None:
        """Be a number of ``owner``; what was typed for another one is left out."""
        self.number.belong_to(owner)

    def set_value(self, value: float) -> None:
        """Show a value, and nothing else."""
        self._showing = True
        self.number.set_value(value)
        self.slider.setValue(round(_STEPS * self._share(value)))
        self._showing = False

    def reach(self, low: float, high: float) -> None:
        """Let the slider reach from ``low`` to ``high``."""
        self._span = low, high

    def _share(self, value: float) -> float:
        low, high = self._span
        if self._logarithmic:
            value, low, high = (math.log(max(each, 1e-12)) for each in (value, low, high))
        return min(max((value - low) / (high - low), 0.0), 1.0)

    def _slid(self, at: int) -> None:
        if self._showing:
            return
        low, high = self._span
        share = at / _STEPS
        value = low * (high / low) ** share if self._logarithmic else low + share * (high - low)
        step = 10.0 ** (math.floor(math.log10(value)) - 2) if self._logarithmic else self._step
        value = round(round(value / step) * step, 9)
        self.number.set_value(value)
        self.edited.emit(value)

    def _typed(self, value: float) -> None:
        self.set_value(value)
        self.edited.emit(value)
        self.ended.emit()

    def _scrubbed(self, value: float) -> None:
        self.set_value(value)
        self.edited.emit(value)
