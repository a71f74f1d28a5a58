"""A cathode-ray tube cut open along its axis, to scale: outlines of its parts, its beam, and its labels.

Everything is in millimetres, z to the right from the cathode, y upwards from the axis.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.scanning.electron_optics import ANODE_MM, FACE_MM, GRID_MM, LENS_MM, PLATES_MM
from workbench.display.gun import Gun, Place
from workbench.language import _

Points = NDArray[np.float64]
Box = tuple[float, float, float, float]
"""Left, bottom, right, top."""

Part = Literal[
    "heater",
    "cathode",
    "grid",
    "focus",
    "anode",
    "plates_y",
    "plates_x",
    "coils",
    "beam",
    "coating",
    "screen",
]
Kind = Literal["glass", "pin", "heater", "metal", "plate", "coil", "coating", "phosphor", "axis"]

STEPS: tuple[tuple[Part, ...], ...] = (
    ("heater", "cathode"),
    ("grid",),
    ("focus",),
    ("anode",),
    ("plates_y", "plates_x", "coils"),
    ("screen",),
)
"""The parts that each of the six steps of the text is about."""

_FOOT, _NECK, _WALL = -20.0, 17.0, 5.0
_BULGE = 5.0
_AXIS_ENDS = 6.0
_YOKE = 8.0
_SHIFTS = 24
_ROUND = 9
_LEAST_WAY = 1e-9
MARGIN = 8.0


class Shape(NamedTuple):
    """One outline (n, 2) of a part; ``part`` is empty where it is none that a person chooses."""

    part: Part | Literal[""]
    kind: Kind
    points: Points
    closed: bool = True


class Label(NamedTuple):
    """What a part is called and set to, where it is pointed at, and whether that is done from above.

    ``short`` is what it is called where there is no room for its title.
    """

    part: Part
    title: str
    short: str
    value: str
    anchor: tuple[float, float]
    above: bool


class PlacedLabel(NamedTuple):
    """A label and the box it stands in."""

    label: Label
    box: Box

    @property
    def leader(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """From the box to what it names."""
        left, bottom, right, top = self.box
        z, y = self.label.anchor
        return (min(max(z, left + 1.0), right - 1.0), bottom if self.label.above else top), (z, y)


class Span(NamedTuple):
    """A length that is drawn with arrows at its ends, ``y`` high."""

    name: str
    start: float
    end: float
    y: float


def parts_of(gun: Gun) -> tuple[Part, ...]:
    """The parts from left to right, as a person goes through them."""
    bent: tuple[Part, ...] = ("coils",) if gun.coils else ("plates_y", "plates_x")
    return "heater", "cathode", "grid", "focus", "anode", *bent, "beam", "coating", "screen"


def window_of(gun: Gun) -> Box:
    """What the drawing needs of the plane."""
    half = FACE_MM[1] / 2.0
    return _FOOT - MARGIN, -half - 2.5 * MARGIN, gun.screen + _BULGE + MARGIN, half + 1.7 * MARGIN


def neck_of(gun: Gun) -> float:
    """Half the height of the neck, which holds the plates."""
    return max(_NECK, gun.gap / 2.0 + _WALL)


def face(gun: Gun, share: float) -> tuple[float, float]:
    """A place of the curved face, ``share`` from -1 at its lower to 1 at its upper edge."""
    return gun.screen + _BULGE * (1.0 - share * share), share * FACE_MM[1] / 2.0


def shapes(gun: Gun) -> tuple[Shape, ...]:
    """Every part, from back to front."""
    neck, flare = neck_of(gun), _flare(gun)
    front = [face(gun, share) for share in np.linspace(1.0, -1.0, 2 * _ROUND)]
    inner = [(z - 2.5, 0.96 * y) for z, y in front]
    upper = [(_FOOT + 4.0, neck), *flare]
    whole = [(_FOOT, neck - 4.0), *upper, *front, *_below(upper), (_FOOT, 4.0 - neck)]
    coat = [(z, y - 3.0) for z, y in flare]
    drawn = [
        Shape("", "glass", _points(whole)),
        Shape("", "axis", _points([(_FOOT - _AXIS_ENDS, 0.0), (gun.screen + _BULGE, 0.0)]), False),
        *(Shape("", "pin", _points([(_FOOT - 5.0, y), (_FOOT + 5.0, y)]), False) for y in (-6.0, 0.0, 6.0)),
        Shape("coating", "coating", _points(coat), False),
        Shape("coating", "coating", _points(_below(coat)), False),
        Shape("screen", "phosphor", _points(inner), False),
        Shape(
            "heater", "heater", _points([(-13.0 + 1.5 * k, 3.0 if k % 2 else -3.0) for k in range(7)]), False
        ),
        Shape("cathode", "metal", _box(-3.0, -6.0, 0.0, 6.0)),
    ]
    for side in (1.0, -1.0):
        drawn += [
            Shape("grid", "metal", _box(4.0, side * 8.0, GRID_MM + 1.0, side * 9.6)),
            Shape("grid", "metal", _box(GRID_MM - 0.6, side * 1.6, GRID_MM + 1.0, side * 9.6)),
            Shape("focus", "metal", _box(LENS_MM - 10.0, side * 7.4, LENS_MM + 10.0, side * 9.0)),
            Shape("anode", "metal", _box(ANODE_MM - 10.0, side * 8.0, ANODE_MM, side * 9.6)),
            Shape("anode", "metal", _box(ANODE_MM - 1.6, side * 4.0, ANODE_MM, side * 9.6)),
        ]
    if gun.coils:
        for side in (1.0, -1.0):
            box = _box(PLATES_MM, side * (neck + 1.5), PLATES_MM + gun.length, side * (neck + _YOKE))
            drawn.append(Shape("coils", "coil", box))
        return tuple(drawn)
    second = gun.screen - gun.reach_x - gun.length / 2.0
    tall = min(7.0, neck - 4.0)
    drawn.append(Shape("plates_x", "plate", _box(second, -tall, second + gun.length, tall)))
    for side in (1.0, -1.0):
        box = _box(PLATES_MM, side * gun.gap / 2.0, PLATES_MM + gun.length, side * (gun.gap / 2.0 + 1.6))
        drawn.append(Shape("plates_y", "metal", box))
    return tuple(drawn)


def _flare(gun: Gun) -> list[tuple[float, float]]:
    """The upper wall from the neck to the edge of the face."""
    half, neck = FACE_MM[1] / 2.0, neck_of(gun)
    last = gun.length / 2.0 if gun.coils else gun.length / 2.0 + gun.reach_y - gun.reach_x
    start = min(PLATES_MM + gun.length / 2.0 + last + 6.0, gun.screen - 30.0)
    shares = np.linspace(0.0, 1.0, 3 * _ROUND)
    rise = shares * shares * (3.0 - 2.0 * shares)
    return [
        (float(start + s * (gun.screen - start)), float(neck + r * (half - neck)))
        for s, r in zip(shares, rise, strict=True)
    ]


def beam_outline(way: Sequence[Place]) -> Points:
    """The beam (n, 2) from its way as the text emits it, as wide as it is; empty where it is cut off."""
    places = [place for place in way if place[0] >= GRID_MM]
    if not places:
        return np.zeros((0, 2))
    upper = [(z, y + r) for z, _x, y, r in places]
    lower = [(z, y - r) for z, _x, y, r in places]
    return _points([(0.0, 2.0), *upper, *lower[::-1], (0.0, -2.0)])


def ends_on_face(gun: Gun, way: Sequence[Place]) -> bool:
    """Whether the beam reaches the phosphor."""
    z, x, y, _r = way[-1]
    return z >= gun.screen and abs(x) <= FACE_MM[0] / 2.0 and abs(y) <= FACE_MM[1] / 2.0


def tangent(gun: Gun, way: Sequence[Place]) -> Points:
    """From the middle of what bends the beam upwards straight to where it lands; empty where it does not."""
    if way[-1][0] < gun.screen or way[-1][2] == 0.0:
        return np.zeros((0, 2))
    return _points([(gun.screen - gun.reach_y, 0.0), (gun.screen, way[-1][2])])


def spans(gun: Gun) -> tuple[Span, ...]:
    """l and D below the tube."""
    half = FACE_MM[1] / 2.0
    middle = gun.screen - gun.reach_y
    return (
        Span(f"l = {gun.length:g} mm", PLATES_MM, PLATES_MM + gun.length, -half + MARGIN),
        Span(f"D = {gun.reach_y:g} mm", middle, gun.screen, -half - 1.5 * MARGIN),
    )


# Labels


def labels(gun: Gun, seconds: float | None = None) -> tuple[Label, ...]:
    """What each part is called, in the words of the course, and what it is set to now."""
    way_x, way_y = gun.arguments(seconds)[4]
    neck, flare = neck_of(gun), _flare(gun)
    coat = flare[len(flare) // 2]
    first = PLATES_MM + gun.length / 2.0
    second = gun.screen - gun.reach_x
    if gun.coils:
        field = f"B = {_volts(math.hypot(way_x, way_y), 'mT')}"
        above: list[Label] = []
        below = Label("coils", _("deflection coils"), _("coils"), field, (first, -neck - 5.0), False)
    else:
        up, across = f"V_y = {_volts(way_y, 'V')}", f"V_x = {_volts(way_x, 'V')}"
        lower, within = (first, -gun.gap / 2.0 - 1.0), (second, 4.0)
        above = [Label("plates_x", _("horizontal deflection plates"), _("X plates"), across, within, True)]
        below = Label("plates_y", _("vertical deflection plates"), _("Y plates"), up, lower, False)
    beyond = (flare[0][0] + 2.0 * gun.screen) / 3.0
    return (
        Label("heater", _("heater"), _("heater"), "6.3 V", (-8.5, 3.0), True),
        Label("grid", _("control grid"), _("grid"), _volts(gun.grid, "V"), (GRID_MM, 9.0), True),
        Label(
            "anode", _("accelerating anode"), _("anode"), _volts(gun.anode, "V"), (ANODE_MM - 4.0, 9.0), True
        ),
        *above,
        Label("screen", _("phosphor-coated screen"), _("screen"), gun.phosphor, face(gun, 0.97), True),
        Label("cathode", _("cathode"), _("cathode"), "0 V", (-1.5, -6.0), False),
        Label("focus", _("focusing anode"), _("focus"), _volts(gun.focus, "V"), (LENS_MM, -8.5), False),
        below,
        Label("beam", _("electron beam"), _("beam"), "", (beyond, 0.0), False),
        Label("coating", _("conductive coating"), _("coating"), "", (coat[0], 3.0 - coat[1]), False),
    )


def _volts(value: float, unit: str) -> str:
    sign = "+" if value > 0 else "\u2212" if value < 0 else ""
    return f"{sign}{abs(value):,.4g} {unit}" if abs(value) < 1000 else f"{sign}{abs(value):,.0f} {unit}"


def place_labels(
    told: Iterable[Label], gun: Gun, size_of: Callable[[Label], tuple[float, float]], gap: float, room: Box
) -> tuple[PlacedLabel, ...]:
    """Put every label as near to its part as it can be, ``gap`` clear of the neck and of the others.

    ``size_of`` gives width and height of its box, ``room`` is where they may stand. No label covers a line of
    the drawing, or of those that lead to parts; where there is no room for that, of the latter only, and
    where there is none at all, a label is left out.
    """
    told = tuple(told)
    return clear_labels(told, gun, size_of, gap, room) or near_labels(told, gun, size_of, gap, room)


def clear_labels(
    told: Iterable[Label], gun: Gun, size_of: Callable[[Label], tuple[float, float]], gap: float, room: Box
) -> tuple[PlacedLabel, ...]:
    """As ``place_labels`` where there is room for all of them to cover nothing; else none of them."""
    return _placed(told, gun, size_of, gap, room, _lines(gun))


def near_labels(
    told: Iterable[Label], gun: Gun, size_of: Callable[[Label], tuple[float, float]], gap: float, room: Box
) -> tuple[PlacedLabel, ...]:
    """As ``place_labels`` where there is no such room: they may cover the drawing, and some are left out."""
    return _placed(told, gun, size_of, gap, room, None)


def _placed(
    told: Iterable[Label],
    gun: Gun,
    size_of: Callable[[Label], tuple[float, float]],
    gap: float,
    room: Box,
    drawn: tuple[Points, Points] | None,
) -> tuple[PlacedLabel, ...]:
    """Every label clear of those before it and of their lines, if it can be.

    Where they have to be clear of what is ``drawn`` as well, there are none if one cannot be so.
    """
    left_end, low, right_end, high = room
    free = neck_of(gun) + 2.0 * gap + (_YOKE if gun.coils else 0.0)
    lengths = [
        (span.start, span.y - gap, span.end + len(span.name) * gap, span.y + gap) for span in spans(gun)
    ]
    over = FACE_MM[1] / 2.0 + gap
    placed: list[PlacedLabel] = []
    for label in told:
        wide, tall = size_of(label)
        pitch = tall + 0.6 * gap  # more than keeps rows apart
        rows = max(int(((high if label.above else -low) - free + 0.6 * gap) // pitch), 1)
        middle = label.anchor[0] - wide / 2.0
        shifts = sorted((shift * gap for shift in range(-_SHIFTS, _SHIFTS + 1)), key=abs)
        lefts = [min(max(middle + shift, left_end), right_end - wide) for shift in shifts]
        starts = [free + row * pitch for row in range(rows)]
        if drawn is not None:
            starts.append(max(free, (high if label.above else -low) - tall))
        if label.part == "screen" and over + tall <= high:
            starts = [over]  # lower it would cover the bulb
        boxes = [(left, start, left + wide, start + tall) for start in starts for left in lefts]
        if not label.above:
            boxes = [(left, -top, right, -bottom) for left, bottom, right, top in boxes]
        places = sorted((PlacedLabel(label, box) for box in boxes), key=lambda each: math.dist(*each.leader))
        taken = [*lengths, *(each.box for each in placed)]
        best, least = None, (True, True)
        for place in places:
            if any(_touch(place.box, box, gap) for box in taken):
                continue
            in_the_way = any(_in_the_way(place, other) for other in placed)
            faults = in_the_way, drawn is not None and _covers(place.box, drawn)
            if best is None or faults < least:
                best, least = place, faults
            if not any(faults):
                break
        if drawn is not None and (best is None or any(least)):
            return ()
        if best is not None:
            placed.append(best)
    return tuple(placed)


def _lines(gun: Gun) -> tuple[Points, Points]:
    """Where every line of the drawing begins, and the way (n, 2) from there to its end, nowhere quite 0."""
    outlines = [np.vstack([s.points, s.points[:1]]) if s.closed else s.points for s in shapes(gun)]
    ways = np.vstack([np.diff(points, axis=0) for points in outlines])
    ways[np.abs(ways) < _LEAST_WAY] = _LEAST_WAY
    return np.vstack([points[:-1] for points in outlines]), ways


def _covers(box: Box, lines: tuple[Points, Points]) -> bool:
    """Whether any of the lines passes through a box."""
    starts, ways = lines
    low, high = (box[:2] - starts) / ways, (box[2:] - starts) / ways
    near, far = np.minimum(low, high), np.maximum(low, high)
    enters, leaves = np.maximum(near[:, 0], near[:, 1]), np.minimum(far[:, 0], far[:, 1])
    return bool((np.maximum(enters, 0.0) < np.minimum(leaves, 1.0)).any())


def _in_the_way(one: PlacedLabel, other: PlacedLabel) -> bool:
    """Whether either label stands on the line that leads from the other to its part."""
    return _cuts(one.leader, other.box) or _cuts(other.leader, one.box)


def _cuts(line: tuple[tuple[float, float], tuple[float, float]], box: Box) -> bool:
    """Whether a line from one place to another passes through a box."""
    (z0, y0), (z1, y1) = line
    enters, leaves = 0.0, 1.0
    for start, step, low, high in ((z0, z1 - z0, box[0], box[2]), (y0, y1 - y0, box[1], box[3])):
        if step == 0.0:
            if not low < start < high:
                return False
            continue
        near, far = sorted(((low - start) / step, (high - start) / step))
        enters, leaves = max(enters, near), min(leaves, far)
    return enters < leaves


def _touch(one: Box, other: Box, gap: float) -> bool:
    return (
        one[0] < other[2] + gap
        and other[0] < one[2] + gap
        and one[1] < other[3] + gap / 2
        and other[1] < one[3] + gap / 2
    )


def _below(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    return [(z, -y) for z, y in reversed(points)]


def _points(places: Sequence[tuple[float, float]]) -> Points:
    return np.array(places, np.float64)


def _box(left: float, low: float, right: float, high: float) -> Points:
    return _points([(left, low), (right, low), (right, high), (left, high)])
