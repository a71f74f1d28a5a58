"""A cathode-ray tube that runs: its time, its light, its cabinet. A subclass says what the beam draws.

The tube's time runs from a timer that stops when the widget is hidden, paused, or shows a picture that no
longer changes. With Calm on, refreshes that would be seen as flicker are averaged; slow motion below three
pictures a second shows the beam itself.
"""

from collections.abc import Callable
from fractions import Fraction
from functools import partial

from PySide6.QtCore import QElapsedTimer, QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QPainter, QPaintEvent, QPen, QPixmap, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.display.beam import Beam
from workbench.display.driver import VISIBLE, TubeDriver, driven, must_average
from workbench.display.exposure import Screen
from workbench.display.tube import PICOSECOND, Tube
from workbench.engine.background import report
from workbench.session.answers import Answers
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.tube.glass import CORNER, cabinet_pixmap, fitted, glass_path, reflection_pixmap
from workbench.widgets.tube.marks import paint_plate

_FRAME_MS, _IDLE_MS = 16, 250
_LONGEST_STEP_S = 0.1
_WIDEST_PX = 520
_PLATE_PX = 22


class LiveTube(QWidget):
    """One tube. ``advanced`` comes with each step of its time; ``sight`` tells whether it is seen: one behind
    other tabs is not, and is made when it is. One of a large picture is made on a thread; until it is there
    the one before stands still.
    """

    advanced = Signal()
    shown = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._slow = 1.0
        self._paused = False
        self._seconds = Fraction(0)
        self.driver: TubeDriver | None = None
        self._making: Callable[[], TubeDriver] | None = None  # what is to take its place, as asked for last
        self._under_way: Callable[[], TubeDriver] | None = None
        self._coming = QTimer(self, singleShot=True, interval=0)  # its place has its size by then
        self._coming.timeout.connect(self._rebuild)
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take_answer)
        self._screen: Screen | None = None
        self._shown: QImage | None = None
        self._cabinet: QPixmap | None = None
        self._reflection: QPixmap | None = None
        self._glass = QRectF()
        self._case = QRectF()
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._clock = QElapsedTimer()
        self._resized = QTimer(self)
        self._resized.setSingleShot(True)
        self._resized.setInterval(80)
        self._resized.timeout.connect(self._rebuild)
        self.sight = InSight(self)
        self.sight.changed.connect(self._come_in_sight)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(100, 60)
        theme.changed.connect(self.update)
        comfort.changed.connect(self._wake)

    # What a subclass says

    @property
    def face_mm(self) -> tuple[float, float]:
        """Width and height of the face."""
        raise NotImplementedError

    @property
    def asked_hz(self) -> float:
        """The refresh rate that is asked for, before there is a beam that keeps it."""
        raise NotImplementedError

    @property
    def widest_px(self) -> int:
        """The most pixels that the face has across."""
        return _WIDEST_PX

    @property
    def lettering(self) -> tuple[str, str]:
        """What stands at the left and at the right below the glass."""
        raise NotImplementedError

    def _maker(self, size_px: tuple[int, int]) -> Callable[[], tuple[Tube, Beam]]:
        """Makes the tube with a face of so many pixels, and its beam; holds nothing of Qt, for any thread."""
        raise NotImplementedError

    @property
    def _is_fed(self) -> bool:
        """Whether there is anything to show."""
        return True

    @property
    def _is_large(self) -> bool:
        """Whether to make it may hold the interface."""
        return False

    @property
    def _held_at(self) -> Fraction | None:
        """The time since the start of a picture at which it stands; None where it runs."""
        return None

    def _paint_over(self, painter: QPainter) -> None:
        """Paint what lies over the light, under the reflection."""

    # Its time

    def sizeHint(self) -> QSize:
        """Room for half a window."""
        return QSize(420, 360)

    def set_slow_motion(self, factor: float) -> None:
        """Run ``factor`` times slower than life, 1 to 1,000,000."""
        slow = min(max(factor, 1.0), 1e6)
        if slow != self._slow:
            self._slow = slow
            self._wake()

    def set_paused(self, paused: bool) -> None:
        """Hold the tube's time, or let it run."""
        if paused != self._paused:
            self._paused = paused
            self._wake()

    @property
    def averaged(self) -> bool:
        """Whether whole pictures are averaged now, so that neither flicker nor beam is seen."""
        return must_average(self.refresh_hz, self._slow, comfort.calm)

    @property
    def refresh_hz(self) -> float:
        """Pictures per second; a long display list takes longer than the rate asked for."""
        return self.asked_hz if self.driver is None else 1.0 / float(self.driver.beam.frame_s)

    @property
    def running(self) -> bool:
        """Whether the timer runs."""
        return self._timer.isActive()

    @property
    def is_current(self) -> bool:
        """Whether it shows what it was given, in the size that it has now."""
        later = self._coming.isActive() or self._resized.isActive() or self._making is not None
        return (self._shown is not None or not self._is_fed) and not later

    @property
    def standing(self) -> TubeDriver | None:
        """The driver, unless another is to take its place."""
        return self.driver if self._making is None else None

    def seconds(self) -> Fraction:
        """Tube time, exact."""
        return self._seconds if self.standing is None else self.standing.tube.seconds

    def set_seconds(self, seconds: Fraction) -> None:
        """Go to another tube time, as when a saved one is opened; the picture is that of long drawing."""
        there = self.driver is not None or self._making is not None
        self.driver, self._seconds = None, seconds
        if there:
            self._rebuild()

    def step(self, seconds: Fraction) -> None:
        """Advance the tube's time by hand and show the beam where it then is, Calm or not."""
        if self.standing is not None and seconds > 0:
            self.standing.advance(seconds / PICOSECOND, False)
            self._refresh()

    def _wake(self) -> None:
        if self.sight.now and not self._paused and self.standing is not None:
            if not self._timer.isActive():
                self._clock.start()
            self._timer.start(_FRAME_MS)
        else:
            self._timer.stop()

    def _tick(self) -> None:
        if self.standing is None:
            return
        elapsed_ns = self._clock.nsecsElapsed()
        self._clock.restart()
        elapsed = min(Fraction(elapsed_ns, 10**9), Fraction(_LONGEST_STEP_S))
        averaged, driver = self.averaged, self.standing
        if driver.averages and not averaged and self._is_large:
            self._rebuild()
            return
        driver.advance(elapsed / Fraction(self._slow) / PICOSECOND, averaged)
        self._refresh()
        if averaged and driver.steady:
            self._timer.stop()
            return
        # A long tail changes so slowly that few pictures a second show it as well. Where a phosphor of many
        # terms takes long to add up, half of the time is left to the rest of the window.
        slower = VISIBLE / max(driver.change, VISIBLE / 100.0) if averaged else 1.0
        wait = max(_FRAME_MS * max(slower, 1.0), 2 * self._clock.elapsed())
        self._timer.setInterval(int(min(wait, _IDLE_MS)))

    def _refresh(self) -> None:
        if self.driver is None or self._screen is None:
            return
        packed = self._screen.picture(self.driver.lights)
        rows, columns = packed.shape
        self._packed = packed  # what the image looks at
        self._shown = QImage(packed.data, columns, rows, 4 * columns, QImage.Format.Format_RGB32)
        self.update(self._glass.toAlignedRect())
        self.advanced.emit()

    # Its face

    def _face_px(self) -> tuple[int, int]:
        width = min(round(self._glass.width() * self.devicePixelRatioF()), self.widest_px)
        face = self.face_mm
        return max(width, 16), max(round(width * face[1] / face[0]), 12)

    def _rebuild(self) -> None:
        """Make the tube anew for this size, picture and setup, showing what it would show after a while."""
        self._seconds = self.seconds()
        self._making = None
        if self._coming.isActive() or not self.sight.now or not self._is_fed:
            self.driver = None
            return
        self._layout()
        if self._glass.width() < 8:
            return
        maker = self._maker(self._face_px())
        make = partial(driven, maker, self._seconds, self._slow, comfort.calm, self._held_at)
        if not self._is_large:
            self._take(make())
            return
        self._making = make
        self._wake()
        if self._under_way is None:
            self._ask()

    def _ask(self) -> None:
        self._under_way = self._making
        if self._making is not None:  # it is still in sight
            self._answers.ask(partial(_driver_or_none, self._making), "tube")

    def _take_answer(self, answer: tuple[TubeDriver | None]) -> None:
        """Show what was asked for, unless another is by now."""
        (driver,), asked, self._under_way = answer, self._under_way, None
        if self._making is not asked:
            self._ask()
            return
        self._making = None
        if driver is not None:
            self._take(driver)

    def _take(self, driver: TubeDriver) -> None:
        """From now on this is the tube."""
        self.driver = driver
        layers = [rgb for gun in driver.tube.guns for _name, rgb in gun.colours]
        self._screen = Screen(driver.tube.size_px, layers)
        self._cabinet = self._reflection = None
        self._refresh()
        self._wake()
        self.update()

    def _layout(self) -> None:
        width, height = self.face_mm
        plate = _PLATE_PX if self.height() > 190 else 0
        self._case, self._glass = fitted(self.width(), self.height(), height / width, plate)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay the cabinet out at once, make the tube when the size has come to rest."""
        super().resizeEvent(event)
        self._layout()
        self._cabinet = self._reflection = None
        if self.driver is not None:
            self._resized.start()
        elif self.sight.now:
            self._rebuild()

    def _come_in_sight(self, seen: bool) -> None:
        """Run again, or rest: a tube that nobody sees costs nothing."""
        if seen:
            if self.standing is None:
                self._coming.start()  # once, whatever it is given by those who are told
            self.shown.emit()
        self._wake()

    def _to_widget(self, x_mm: float, y_mm: float) -> QPointF:
        width, height = self.face_mm
        return QPointF(
            self._glass.left() + x_mm / width * self._glass.width(),
            self._glass.bottom() - y_mm / height * self._glass.height(),
        )

    def paintEvent(self, event: QPaintEvent) -> None:
        """Cabinet, light, beam, glass."""
        painter = QPainter(self)
        if self._cabinet is None or self._reflection is None:
            size = self.width(), self.height(), self.devicePixelRatioF()
            self._cabinet = cabinet_pixmap(*size, self._case, self._glass)
            self._reflection = reflection_pixmap(*size, self._glass)
        painter.drawPixmap(0, 0, self._cabinet)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.save()
        painter.setClipPath(glass_path(self._glass))
        if self._shown is not None:
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Plus)
            painter.drawImage(self._glass, self._shown)
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceOver)
            self._paint_over(painter)
        painter.restore()
        painter.drawPixmap(0, 0, self._reflection)
        if self._case.bottom() - self._glass.bottom() >= _PLATE_PX:
            plate = self._glass.translated(0, self._case.bottom() - _PLATE_PX - 3 - self._glass.top())
            plate.setHeight(_PLATE_PX)
            paint_plate(painter, plate, *self.lettering)
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            radius = CORNER * self._case.width()
            painter.drawRoundedRect(self._case.adjusted(1, 1, -1, -1), radius, radius)


def _driver_or_none(make: Callable[[], TubeDriver]) -> tuple[TubeDriver | None]:
    """What is made, None where that fails, which is told where the faults of threads are."""
    try:
        return (make(),)
    except Exception:
        report()
        return (None,)
