"""The motion of a sheet: its length and rate, and tracks of keys, each on a number or a group of numbers."""

from typing import Annotated, ClassVar

import msgspec

from workbench.algorithms.animation.easings import BEZIER, NAMES, NEAREST_HANDLES
from workbench.document.fields import Choice, Number
from workbench.document.parts import WithParts
from workbench.language import _

MAX_FRAMES = 1_000_000
LARGEST_VALUE = 1e9
SPLINE = "spline"
EASINGS = (*NAMES, SPLINE)
LINEAR, BEZIER_NAME = "linear", NAMES[BEZIER]
TURNINGS = QUATERNION, EULER = ("quaternion", "euler")
_MOST_CORNERS = 1_000_000


def _time(label: str, symbol: str) -> Number:
    return Number(label=label, symbol=symbol, low=0.0, high=1.0, keyed=False)


def _height(label: str, symbol: str) -> Number:
    return Number(label=label, symbol=symbol, low=-10.0, high=10.0, keyed=False)


class Key(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, cache_hash=True):
    """What a track's numbers are in one frame. Its id begins with ``letter`` by habit.

    ``easing`` leads from here to the next key; (x1, y1) and (x2, y2) are the handles of "bezier".
    ``tension``, ``continuity`` and ``bias`` shape the slope of a "spline" at this key, on both sides.
    Of a closed outline ``shift`` is the vertex of the next key to which vertex 0 goes; ``turning`` is how a
    turn in space goes to the next one.
    """

    letter: ClassVar[str] = "k"

    id: str
    frame: Annotated[int, Number(label=_("frame"), low=0, high=MAX_FRAMES - 1, whole=True, keyed=False)]
    value: tuple[
        Annotated[float, Number(label=_("value"), low=-LARGEST_VALUE, high=LARGEST_VALUE, keyed=False)], ...
    ]
    easing: Annotated[str, Choice(EASINGS)] = LINEAR
    x1: Annotated[float, _time(_("x of the first handle"), "x_1")] = NEAREST_HANDLES[BEZIER][0]
    y1: Annotated[float, _height(_("y of the first handle"), "y_1")] = NEAREST_HANDLES[BEZIER][1]
    x2: Annotated[float, _time(_("x of the second handle"), "x_2")] = NEAREST_HANDLES[BEZIER][2]
    y2: Annotated[float, _height(_("y of the second handle"), "y_2")] = NEAREST_HANDLES[BEZIER][3]
    tension: Annotated[float, _height(_("tension"), "t")] = 0.0
    continuity: Annotated[float, _height(_("continuity"), "c")] = 0.0
    bias: Annotated[float, _height(_("bias"), "b")] = 0.0
    shift: Annotated[
        int,
        Number(label=_("vertex that vertex 0 moves to"), low=0, high=_MOST_CORNERS, whole=True, keyed=False),
    ] = 0
    turning: Annotated[str, Choice(TURNINGS)] = QUATERNION

    @property
    def handles(self) -> tuple[float, float, float, float]:
        """Those of a Bézier easing: x1, y1, x2, y2."""
        return self.x1, self.y1, self.x2, self.y2


class Track(
    WithParts,
    msgspec.Struct,
    frozen=True,
    forbid_unknown_fields=True,
    omit_defaults=True,
    cache_hash=True,
    dict=True,
):
    """The keys of what ``target`` names on the sheet, in the order of their frames.

    A target is an address without its sheet: a number (``f2/radius_world``), a point (``f2/p3/*``), all
    points (``f2/points_world``), a colour (``f2/colour``), a turn in space (``o5/t6/*``), or something of the
    camera (``scene.camera.eye``). Before the first key its value holds, and after the last one that one's.
    """

    letter: ClassVar[str] = "a"

    id: str
    target: str
    keys: tuple[Key, ...]


class Motion(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, cache_hash=True):
    """``frames`` frames, from 0, ``rate`` of them a second."""

    frames: Annotated[
        int, Number(label=_("number of frames"), low=1, high=MAX_FRAMES, whole=True, keyed=False)
    ] = 49
    rate: Annotated[float, Number(label=_("rate"), low=0.1, high=240.0, unit="1/s", keyed=False)] = 24.0
    tracks: tuple[Track, ...] = ()
