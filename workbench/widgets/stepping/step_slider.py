"""A slider over the run, with a mark where a decision changed or a part of it begins."""

from PySide6.QtCore import QRectF, Qt, QTimer
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from workbench.language import _
from workbench.session.run import Run
from workbench.widgets.look.tokens import colour, theme, tokens

_MOST_MARKED = 5_000
_AT_ONCE = 100


class StepSlider(QSlider):
    """Moves the cursor of a run while it is dragged."""

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._run = run
        self._marks: tuple[int, ...] = ()
        self._beyond: int | None = None
        self._places: list[float] = []
        self._drawn: tuple[object, ...] = ()
        self.setAccessibleName(_("Position in the run"))
        self.setToolTip(_("Drag to any step; marks show where the decision changed or a part begins"))
        self.setMinimumWidth(90)
        self.setFixedHeight(32)
        self.setPageStep(10)
        self._search = QTimer(self)
        self._search.setInterval(0)
        self._search.timeout.connect(self._look_for_marks)
        self.valueChanged.connect(self._moved_by_hand)
        self.sliderReleased.connect(self._let_go)
        run.changed.connect(self._take_run)
        run.moved.connect(self.refresh)
        run.grown.connect(self.refresh)
        theme.changed.connect(self.update)
        self.refresh()

    def _take_run(self) -> None:
        self._marks = ()
        self._beyond = None
        self.refresh()

    def refresh(self) -> None:
        """Follow the run."""
        run = self._run
        total = run.last_position if run.detail else max(run.total_steps or 0, run.passed + run.last_position)
        self.blockSignals(True)
        self.setEnabled(run.entry is not None)
        self.setRange(0, min(total, 2**31 - 1))
        if self._beyond is None or not self.isSliderDown():
            self.setValue(run.number)
        self.blockSignals(False)
        many = run.steps is not None and len(run.steps) > _MOST_MARKED
        if run.landmarks:
            self._search.stop()
            self._marks = run.landmarks
        elif run.steps is None or many or not run.done or run.ask_first or run.in_stretches:
            self._search.stop()
            self._marks = ()
        elif run.steps.judged < len(run.steps) or len(self._marks) != len(run.steps.find_decisions(0)):
            self._search.start()
        self.update()

    def _look_for_marks(self) -> None:
        steps = self._run.steps
        if steps is None or self._run.ask_first:
            self._search.stop()
            return
        before = steps.judged
        self._marks = steps.find_decisions(_AT_ONCE)
        if steps.judged == before:
            self._search.stop()
            self.update()

    @property
    def marks(self) -> tuple[int, ...]:
        """Steps where the decision changed, or where a part of the run begins."""
        return self._marks

    def _moved_by_hand(self, value: int) -> None:
        run = self._run
        beyond = run.in_stretches and not run.detail and not 0 < value - run.passed <= run.last_position
        self._beyond = value if beyond else None
        if beyond and not self.isSliderDown():
            self._let_go()
        elif not beyond:
            run.go_to_number(value)
        self.refresh()

    def _let_go(self) -> None:
        """Where nothing is recorded, the stretch there is recorded once the handle is let go."""
        beyond, self._beyond = self._beyond, None
        if beyond is not None:
            self._run.go_to_number(beyond)
            self.refresh()

    def _groove(self) -> tuple[int, int, QStyleOptionSlider]:
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        style, control = self.style(), QStyle.ComplexControl.CC_Slider
        groove = style.subControlRect(control, option, QStyle.SubControl.SC_SliderGroove, self)
        handle = style.subControlRect(control, option, QStyle.SubControl.SC_SliderHandle, self)
        return groove.left() + handle.width() // 2, groove.width() - handle.width(), option

    def x_of(self, value: int) -> int:
        """Where the middle of the handle stands for a value."""
        left, width, _option = self._groove()
        span = self.maximum() - self.minimum()
        return (
            left + QStyle.sliderPositionFromValue(self.minimum(), self.maximum(), value, width)
            if span
            else left
        )

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A press beside the handle brings it there."""
        if event.button() == Qt.MouseButton.LeftButton and self.maximum() > 0:
            left, width, _option = self._groove()
            at = round(event.position().x()) - left
            self.setValue(QStyle.sliderValueFromPosition(self.minimum(), self.maximum(), at, width))
        super().mousePressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The slider, and its marks above and below the groove."""
        super().paintEvent(event)
        if not self._marks or not self.isEnabled():
            return
        state = (self._marks, self.width(), self.minimum(), self.maximum(), self._run.detail)
        if state != self._drawn:
            self._drawn, self._places = state, self._places_of_marks()
        painter = QPainter(self)
        ink = colour(tokens().muted)
        middle = self.height() / 2
        for x in self._places:
            painter.fillRect(QRectF(x, middle + 9, 1.5, 4), ink)
            painter.fillRect(QRectF(x, middle - 13, 1.5, 4), ink)

    def _places_of_marks(self) -> list[float]:
        """Where the marks are drawn, 3 pixels apart at least."""
        left, width, _option = self._groove()
        span, steps = self.maximum() - self.minimum(), self._run.steps
        if not span or steps is None:
            return []
        places = [-9.0]
        for number in self._marks:
            if number - self._run.passed > len(steps):
                continue  # not recorded yet, or no more
            value = steps.span(number)[0] if self._run.detail else number
            x = left + width * (value - self.minimum()) / span
            if x - places[-1] >= 3:
                places.append(x)
        return places[1:]
