"""The turn of the frame that is shown, made in each way there is, side by side."""

import math

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QWidget

from workbench.algorithms.animation.turns import entries_determinant
from workbench.algorithms.numerals import numeral, with_minus
from workbench.document.model import Sheet
from workbench.document.motion.between import part_of_the_way, quaternion_of
from workbench.document.motion.model import TURNINGS, Track
from workbench.document.motion.tracks import group_moved
from workbench.geometry.euler import Triple, euler_angles, euler_between
from workbench.language import _
from workbench.panels.animate.names import label_of
from workbench.panels.animate.physics import is_angle
from workbench.panels.animate.track_dock import TrackDock, as_table, box_of
from workbench.panels.animate.turning import (
    Ways,
    drawn,
    lined_up,
    numbers_of,
    rings,
    ways_between,
    whole,
)
from workbench.rendering.subjects.track import Interval

_FOUR_PX = 160
_NEARLY_LOCKED = 10.0


class TurningDock(TrackDock):
    """By angle or quaternion, by Euler's angles, by matrix entries. ``turning_wanted`` sends the way in which
    a turn in space is to go on.
    """

    turning_wanted = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Ways to turn"), parent)
        self.way = QComboBox()
        for title, turning in zip((_("By quaternion"), _("By Euler angles")), TURNINGS, strict=True):
            self.way.addItem(title, turning)
        self.way.setAccessibleName(_("How it turns on its way to the next key"))
        self.way.setToolTip(_("How it turns on its way to the next key, in the picture too"))
        self.way.activated.connect(lambda _index: self.turning_wanted.emit(self.way.currentData()))
        self.fields.addWidget(self.way)

    def show_interval(
        self, sheet: Sheet, shown: Sheet, track: Track | None, around: Interval | None, frame: int
    ) -> None:
        """The ways between the keys around the frame of a track that is an angle or a turn in space."""
        group = group_moved(sheet, track) if track is not None else None
        in_space = group is not None and group.kind == "turn"
        self.way.setVisible(in_space and around is not None)
        if (
            track is None
            or group is None
            or around is None
            or not (in_space or is_angle(sheet, track.target))
        ):
            self.show_nothing(
                _("Nothing turns here"),
                _("Choose the track of an angle, or of a turn in space, with two keys."),
            )
            return
        first, second = around
        self.key = first
        title = _("{what}: frame {first} to {second}").format(
            what=label_of(sheet, track.target), first=first.frame, second=second.frame
        )
        part = part_of_the_way(first, second, min(max(frame, first.frame), second.frame))
        ways = ways_between(around, not in_space)
        marks = drawn(around, frame, not in_space)
        shrinks = _shrinks(ways.theta, part)
        if not in_space:
            self.show_drawn(title, marks, box_of(whole(2)), _numbers(ways, part), shrinks)
            return
        self.way.setCurrentIndex(TURNINGS.index(first.turning))
        before, after = (euler_angles(quaternion_of(key.value)) for key in around)
        angles = euler_between(before, after, part)
        self.show_drawn(
            title,
            (*marks, *rings(angles, 3)),
            box_of(whole(4)),
            _numbers(ways, part),
            f"{_locks(angles)} {shrinks}",
            height=_FOUR_PX,
        )


def _numbers(ways: Ways, part: float) -> str:
    rows = [("", _("det"), _("length"), _("turn"))]
    for way in ways.ways:
        numbers = numbers_of(way, part)
        turned = with_minus(f"{numbers.turned:.1f}°")
        rows.append((way.title, f"{numbers.determinant:.3f}", f"{numbers.length:.3f}", turned))
    return as_table(rows)


def _shrinks(theta: float, part: float) -> str:
    told = _(
        "The entries go along the chord: det = 1 − 2 t (1 − t) (1 − cos θ) = "
        "1 − 2 · {t} (1 − {t}) (1 − cos {theta}°) = {det}. "
        "That is not a rotation: the figure shrinks, so a track keeps the angle instead."
    )
    return told.format(
        t=numeral(part), theta=numeral(math.degrees(theta)), det=numeral(entries_determinant(theta, part))
    )


def _locks(angles: Triple) -> str:
    degrees = [with_minus(f"{math.degrees(angle):.1f}°") for angle in angles]
    apart = lined_up(angles)
    sentence = _(
        "Euler's angles, about x, then y, then z: {x}, {y}, {z}. The axes of x and z are {apart:.1f}° apart"
    )
    told = sentence.format(x=degrees[0], y=degrees[1], z=degrees[2], apart=apart)
    if apart > _NEARLY_LOCKED:
        return told + "."
    return told + _(
        ": they line up, turning about either does the same, and one degree of freedom is lost: gimbal lock."
    )
