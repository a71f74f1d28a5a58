"""Keys beside the physics that they imitate: a spacing chart, the equation's numbers, squash and stretch."""

import math

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from workbench.algorithms.animation.pendulum import lengthening
from workbench.algorithms.numerals import numeral
from workbench.document.model import Ellipse, Sheet
from workbench.document.motion.edits import RADII
from workbench.document.motion.evaluation import at
from workbench.document.motion.model import Key, Track
from workbench.document.motion.tracks import group_moved, track_on
from workbench.language import _
from workbench.panels.animate.names import label_of
from workbench.panels.animate.physics import equation_of
from workbench.panels.animate.spacing import Chart, box, chart_of, drawn
from workbench.panels.animate.track_dock import TrackDock, box_of
from workbench.rendering.subjects.track import Interval


class PhysicsDock(TrackDock):
    """``area_wanted`` sends the figure whose area is to stay as it is squashed."""

    area_wanted = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Keys and physics"), parent)
        self._figure = ""
        self.keep = QPushButton(_("Keep the area"))
        self.keep.setToolTip(
            _(
                "In every key, make it wider by as much as it is flatter: squash and stretch "
                "without losing area"
            )
        )
        self.keep.clicked.connect(lambda: self.area_wanted.emit(self._figure))
        self.layout_below.addWidget(self.keep)

    def show_interval(
        self, sheet: Sheet, shown: Sheet, track: Track | None, around: Interval | None, frame: int
    ) -> None:
        """How the chosen track spaces its frames between two keys, and how physics would."""
        group = group_moved(sheet, track) if track is not None else None
        self.keep.hide()
        if track is None or group is None or around is None or group.kind != "numbers":
            self.show_nothing(
                _("No number moves here"), _("Choose the track of a number or a point with two keys.")
            )
            return
        self.key = around[0]
        equation = equation_of(sheet, track.target)
        chart = chart_of(track, around, equation)
        title = _("{what}: frame {first} to {second}").format(
            what=label_of(sheet, track.target), first=around[0].frame, second=around[1].frame
        )
        lines = []
        if equation is not None:
            lines = _fall(track, around) if equation.law == "fall" else _swing(around)
            lines += _apart(chart, frame)
        note = _(
            "Ticks far apart are fast, close together slow. Lengths are those of the sheet, times are frames."
        )
        self.show_drawn(
            title, drawn(chart, frame), box_of(box(chart)), [*lines, *self._squash(sheet, shown, track)], note
        )

    def _squash(self, sheet: Sheet, shown: Sheet, track: Track) -> list[str]:
        """The area of an ellipse whose radii move, and what it was in frame 0."""
        name = track.target.split("/")[0]
        figure = next((each for each in shown.figures if each.id == name), None)
        tracked = [track_on(sheet, f"{name}/{radius}") for radius in RADII]
        if not isinstance(figure, Ellipse) or not any(tracked):
            return []
        first = next(each for each in at(sheet, 0).figures if each.id == name)
        assert isinstance(first, Ellipse)
        self._figure = name
        self.keep.setVisible(not all(tracked))
        now, then = math.prod(figure.radii_world), math.prod(first.radii_world)
        x, y = map(numeral, figure.radii_world)
        return [
            _("r_x · r_y = {x} · {y} = {now}").format(x=x, y=y, now=numeral(now)),
            _("{share:.0f} % of the area of frame 0").format(share=100.0 * now / then if then else 100.0),
        ]


def _fall(track: Track, keys: tuple[Key, Key]) -> list[str]:
    """What falls so far in so many frames."""
    first, second = keys
    n, high = second.frame - first.frame, abs(second.value[0] - first.value[0])
    lines = [
        _("g = 2 · {high} / {n}² = {g}").format(high=numeral(high), n=n, g=numeral(2.0 * high / n**2)),
        _("v = 2 · {high} / {n} = {v} below").format(high=numeral(high), n=n, v=numeral(2.0 * high / n)),
    ]
    before = next(
        (key for key, after in zip(track.keys, track.keys[1:], strict=False) if after is first), None
    )
    if before is not None and before.value[0] > first.value[0] < second.value[0]:
        fell = before.value[0] - first.value[0]
        kept = numeral(math.sqrt(high / fell))
        lines.append(
            _("keeps √({high} / {fell}) = {kept} of its speed").format(
                high=numeral(high), fell=numeral(fell), kept=kept
            )
        )
    return lines


def _swing(keys: tuple[Key, Key]) -> list[str]:
    first, second = keys
    half = abs(second.value[0] - first.value[0]) / 2.0
    longer = lengthening(math.radians(half))
    n = second.frame - first.frame
    return [
        _("θ'' = −(g / l) sin θ, from {half}°").format(half=numeral(half)),
        _("T = 2 · {n} = {period} frames").format(n=n, period=2 * n),
        _("{longer} times 2π √(l / g)").format(longer=numeral(longer)),
        _("g / l = {ratio}").format(ratio=numeral((math.pi * longer / n) ** 2)),
    ]


def _apart(chart: Chart, frame: int) -> list[str]:
    apart = chart.apart
    worst = int(apart.argmax())
    lines = []
    if frame in chart.frames:
        place = chart.frames.index(frame)
        by_keys, by_law = (numeral(float(row.values[place])) for row in chart.rows[:2])
        lines.append(_("frame {frame}: {keys}, by law {law}").format(frame=frame, keys=by_keys, law=by_law))
    most, where = numeral(float(apart[worst])), chart.frames[worst]
    return [*lines, _("at most {most} apart, frame {where}").format(most=most, where=where)]
