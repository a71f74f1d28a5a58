"""The numbers of the box on the card: how far to move, turn, scale and shear, and about which point."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from workbench.document.fields import numbers_of
from workbench.document.transforms.links import Rotate, Scale, Shear, Translate
from workbench.geometry.transform_box import Point
from workbench.language import _
from workbench.panels.stage.boxing import Boxing
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.action_button import ActionButton

_ROWS = (
    ("move", Translate, ("tx", "ty"), 0.0, 1.0),
    ("rotate", Rotate, ("angle",), 0.0, 1.0),
    ("scale", Scale, ("sx", "sy"), 1.0, 0.1),
    ("shear", Shear, ("sh_x", "sh_y"), 0.0, 0.1),
)
"""Kind, the link that declares its numbers, their names, the number that does nothing, the step."""


class TransformForm(QWidget):
    """Each number is done when it is typed, and goes back to the one that does nothing."""

    def __init__(self) -> None:
        super().__init__()
        self._boxing: Boxing | None = None
        self.fields: dict[str, NumberField] = {}
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(4)
        for row, (kind, link, names, neutral, step) in enumerate(_ROWS):
            for column, name in enumerate(names):
                field = self._field(link, name, step)
                field.set_value(neutral)
                field.edited.connect(partial(self._do, kind, False))
                field.scrubbed.connect(partial(self._do, kind, True))
                field.scrub_ended.connect(self._end_scrub)
                grid.addWidget(field, row, column)
        self.pivot = [self._field(Rotate, name, 1.0) for name in ("x_pivot", "y_pivot")]
        for column, field in enumerate(self.pivot):
            field.edited.connect(lambda _value: self._put_pivot())
            field.scrubbed.connect(lambda _value: self._put_pivot())
            grid.addWidget(field, len(_ROWS), column)
        self.hint = QLabel(_("Each number is applied once, about the pivot."))
        self.hint.setWordWrap(True)
        self.hint.setProperty("role", "muted")
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(6)
        self._buttons = QHBoxLayout()
        self._buttons.setSpacing(4)
        self._buttons.addStretch(1)
        whole.addWidget(self.hint)
        whole.addLayout(grid)
        whole.addLayout(self._buttons)
        self.hide()

    def _field(self, link: type, name: str, step: float) -> NumberField:
        number = numbers_of(link)[name]
        unit = "" if number.unit == "world" else number.unit
        meaning = number.label.capitalize()
        field = NumberField(number.symbol, unit, low=number.low, high=number.high, step=step, meaning=meaning)
        self.fields[name] = field
        return field

    def connect_to(self, boxing: Boxing, actions: Sequence[QAction]) -> None:
        """Let the numbers do what they say; ``actions`` have a button each under them."""
        self._boxing = boxing
        for action in actions:
            button = ActionButton(action)
            button.setFixedSize(32, 28)
            self._buttons.addWidget(button)

    def refresh(self, pivot: Point | None) -> None:
        """Show the pivot, world; without one there is nothing to transform."""
        for field in self.fields.values():
            field.belong_to(self._boxing and self._boxing.boxed())
        self.setVisible(pivot is not None)
        for field, value in zip(self.pivot, pivot or (), strict=False):
            field.set_value(round(value, 6))

    def _do(self, kind: str, scrubbing: bool, _value: float) -> None:
        names = next(names for other, _link, names, *_rest in _ROWS if other == kind)
        values = [self.fields[name].value() for name in names]
        if self._boxing is not None:
            self._boxing.typed(kind, values[0], values[-1], scrubbing)
        if not scrubbing:
            self._reset()

    def _end_scrub(self) -> None:
        if self._boxing is not None:
            self._boxing.end_scrub()
        self._reset()

    def _reset(self) -> None:
        for _kind, _link, names, neutral, _step in _ROWS:
            for name in names:
                self.fields[name].set_value(neutral)

    def _put_pivot(self) -> None:
        if self._boxing is not None:
            self._boxing.put_pivot(self.pivot[0].value(), self.pivot[1].value())
