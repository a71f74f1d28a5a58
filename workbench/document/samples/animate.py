"""The built-in pictures that move: a bouncing ball, a letter that becomes another, a clock,
a pendulum, a drive through a house, two ways to turn."""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import count

from msgspec.structs import replace

from workbench.document.building import with_ids, without_ids
from workbench.document.model import AnyFigure, Document, Ellipse, Rectangle, Sheet, View
from workbench.document.motion.model import EULER, QUATERNION, Key, Motion, Track
from workbench.document.samples.figures import PALETTE, Example, Places, line, points_at, polygon
from workbench.document.samples.space import scene_of
from workbench.document.scene.links import Rotate3D
from workbench.document.scene.model import Camera, Point3D, SpacePoint
from workbench.document.scene.solids import Extrusion, House
from workbench.document.transforms.links import Rotate
from workbench.language import _

Numbers = tuple[float, ...]
# Frame, value, and the easing that leads to the next key
Keyed = tuple[int, Numbers, str]
Tracks = Callable[[Sequence[AnyFigure]], Iterable[tuple[str, Sequence[Keyed]]]]


def animate_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "animate-ball",
            _("A bouncing ball"),
            _("Four key frames per bounce: easing alone makes it leave the ground fast and turn slowly."),
            "animate",
            _ball(),
            dock="between",
        ),
        Example(
            "animate-letter",
            _("A letter becomes another"),
            _("An L of six corners becomes an E of twelve: its edges are cut until both have equally many."),
            "animate",
            _letter(),
            frame=18,
            dock="morphing",
        ),
        Example(
            "animate-clock",
            _("A clock runs"),
            _("Each hand is one angle with two keys; the long hand goes round twelve times as fast."),
            "animate",
            _clock(),
            dock="between",
        ),
        Example(
            "animate-pendulum",
            _("A pendulum"),
            _("Three keys swing it; easing in and out makes it slow at the ends and fast in the middle."),
            "animate",
            _pendulum(),
            frame=6,
            dock="physics",
        ),
        Example(
            "animate-drive",
            _("A drive through a house"),
            _("Two splines through a few keys move the eye and what it looks at."),
            "animate",
            _drive(),
            dock="between",
        ),
        Example(
            "animate-turn",
            _("Two ways to turn in space"),
            _("Two identical houses with the same keys: one turns by quaternion, the other by Euler angles."),
            "animate",
            _turn(),
            frame=24,
            dock="turning",
        ),
    ]


def _document(
    name: str, size: tuple[int, int], figures: Sequence[AnyFigure], frames: int, tracks: Tracks
) -> Document:
    """One sheet of pixels whose figures, numbered, have these tracks."""
    wide, high = size
    whole = Rectangle(-0.5, -0.5, wide - 0.5, high - 0.5)
    own, parts = count(1), count(1)
    numbered = tuple(with_ids(without_ids(figure), own, parts) for figure in figures)
    names = count(1)
    motion = Motion(
        frames,
        24.0,
        tuple(
            Track(
                f"a{next(names)}",
                target,
                tuple(Key(f"k{next(names)}", frame, value, easing) for frame, value, easing in keys),
            )
            for target, keys in tracks(numbered)
        ),
    )
    view = View("v1", whole, whole)
    return Document((Sheet("s1", name, wide, high, (view,), PALETTE, numbered, motion=motion),))


def _ball() -> Document:
    """The ball of the course's falling: from 46 to 10 in twelve frames, from 28 to 40."""
    turns = [(0, 74.0), (16, 10.0), (28, 46.0), (40, 10.0), (49, 26.0), (58, 10.0)]
    heights: list[Keyed] = [
        (frame, (height,), "ease_out" if height == 10.0 else "ease_in") for frame, height in turns
    ]
    touches = [frame for frame, height in turns if height == 10.0]
    squash: list[Keyed] = [(0, (1.0,), "linear")]
    for touch in touches[:-1]:
        squash += [(touch - 2, (1.0,), "linear"), (touch, (0.7,), "linear"), (touch + 2, (1.0,), "linear")]
    ball = Ellipse(
        "", points_at((16.0, 74.0)), "ellipse_fill", 2, _("Ball"), radius_x_world=7.0, radius_y_world=7.0
    )

    def tracks(figures: Sequence[AnyFigure]) -> Iterable[tuple[str, Sequence[Keyed]]]:
        body = figures[-1]
        centre = body.points_world[0].id
        yield f"{body.id}/{centre}/y", heights
        yield f"{body.id}/{centre}/x", [(0, (16.0,), "linear"), (58, (248.0,), "linear")]
        yield (
            f"{body.id}/radius_y_world",
            [(frame, (7.0 * factor,), easing) for frame, (factor,), easing in squash],
        )
        wider = [(frame, (7.0 / factor,), easing) for frame, (factor,), easing in squash]
        yield (
            f"{body.id}/colour",
            [(0, (0x56, 0xB4, 0xE9), "linear"), (58, (0xFF, 0x8A, 0x4C), "linear")],
        )
        yield f"{body.id}/radius_x_world", wider

    ground = line((0, 1), (263, 1), 7, name=_("Ground"))
    return _document(_("A bouncing ball"), (264, 88), [ground, ball], 59, tracks)


_L: Places = [(8.0, 6.0), (38.0, 6.0), (38.0, 14.0), (18.0, 14.0), (18.0, 58.0), (8.0, 58.0)]
# It begins at the right, so that the letter never crosses itself on the way.
_E: Places = [
    *((38.0, 6.0), (38.0, 14.0), (18.0, 14.0), (18.0, 28.0), (34.0, 28.0), (34.0, 36.0)),
    *((18.0, 36.0), (18.0, 50.0), (38.0, 50.0), (38.0, 58.0), (8.0, 58.0), (8.0, 6.0)),
]


def _letter() -> Document:
    def flat(places: Places) -> Numbers:
        return tuple(number for place in places for number in place)

    def tracks(figures: Sequence[AnyFigure]) -> Iterable[tuple[str, Sequence[Keyed]]]:
        yield (
            f"{figures[0].id}/points_world",
            [
                (0, flat(_L), "linear"),
                (6, flat(_L), "ease_in_out"),
                (30, flat(_E), "linear"),
                (36, flat(_E), "ease_in_out"),
                (60, flat(_L), "linear"),
            ],
        )

    letter = polygon([_L], 1, _("Letter"))
    return _document(_("A letter becomes another"), (48, 64), [letter], 61, tracks)


def _clock() -> Document:
    middle = (64.0, 64.0)

    def hand(width: float, length: float, colour: int, name: str) -> AnyFigure:
        x, y = middle
        corners = [(x - width, y - 8.0), (x + width, y - 8.0), (x, y + length)]
        return replace(
            polygon([corners], colour, name), transforms=(Rotate("", angle=0.0, x_pivot=x, y_pivot=y),)
        )

    marks: list[AnyFigure] = []
    for hour in range(12):
        way = math.radians(30.0 * hour)
        ends = [(middle[0] + far * math.sin(way), middle[1] + far * math.cos(way)) for far in (50.0, 57.0)]
        marks.append(line(ends[0], ends[1], 7, name=_("{hour} o'clock").format(hour=hour or 12)))

    def tracks(figures: Sequence[AnyFigure]) -> Iterable[tuple[str, Sequence[Keyed]]]:
        for figure, turn in ((figures[-2], 360.0), (figures[-1], 30.0)):
            yield (
                f"{figure.id}/{figure.transforms[0].id}/angle",
                [(0, (0.0,), "linear"), (60, (-turn,), "linear")],
            )

    figures = [*marks, hand(2.5, 46.0, 2, _("Minute hand")), hand(3.5, 30.0, 1, _("Hour hand"))]
    return _document(_("A clock runs"), (128, 128), figures, 61, tracks)


def _pendulum() -> Document:
    pivot = (60.0, 76.0)
    rest = (60.0, 20.0)

    def turned(figure: AnyFigure) -> AnyFigure:
        return replace(figure, transforms=(Rotate("", angle=35.0, x_pivot=pivot[0], y_pivot=pivot[1]),))

    bob = Ellipse("", points_at(rest), "ellipse_fill", 1, _("Bob"), radius_x_world=6.0, radius_y_world=6.0)
    rod = line(pivot, rest, 7, name=_("Rod"))

    def tracks(figures: Sequence[AnyFigure]) -> Iterable[tuple[str, Sequence[Keyed]]]:
        for figure in figures[1:]:
            yield (
                f"{figure.id}/{figure.transforms[0].id}/angle",
                [(0, (35.0,), "ease_in_out"), (24, (-35.0,), "ease_in_out"), (48, (35.0,), "linear")],
            )

    beam = line((30, 77), (90, 77), 7, name=_("Beam"))
    return _document(_("A pendulum"), (121, 84), [beam, turned(rod), turned(bob)], 49, tracks)


# A gable with a doorway; carried along z it is a house that one can go through.
_GATE: Places = [
    *((-1.2, 0.0), (-0.55, 0.0), (-0.55, 1.25), (0.55, 1.25), (0.55, 0.0), (1.2, 0.0)),
    *((1.2, 1.4), (0.0, 2.4), (-1.2, 1.4)),
]


def _drive() -> Document:
    """Past the corner of a house, through it, and up to the next one, past which it turns away."""
    eyes = [(0, (3.4, 1.8, 9.0)), (28, (0.4, 0.9, 6.0)), (46, (0.0, 0.8, 3.5)), (60, (0.2, 0.8, 1.9))]
    eyes.append((84, (2.6, 1.3, 2.2)))
    aims = [(0, (0.0, 0.6, 3.2)), (28, (0.0, 0.7, 1.6)), (46, (0.0, 0.8, 0.0)), (60, (0.0, 0.7, -1.0))]
    aims.append((84, (0.0, 0.6, -1.4)))
    placed = [
        (_("House {n}").format(n=n), House(2.4, 1.4, 1.8, 1.0), (0.0, 0.0, 3.2 - 3.2 * k), 0.0, colour)
        for k, (n, colour) in enumerate(((1, 0x9CC8E6), (2, 0xF0A878), (3, 0x8CCDB0)))
    ]
    start, aim = Point3D(*eyes[0][1]), Point3D(*aims[0][1])
    camera = Camera(eye=start, look_at=aim, near=0.1, far=40.0, distance=2.0)

    def tracks(_figures: Sequence[AnyFigure]) -> Iterable[tuple[str, Sequence[Keyed]]]:
        for name, places in (("eye", eyes), ("look_at", aims)):
            yield f"scene.camera.{name}", [(frame, place, "spline") for frame, place in places]

    document = _document(_("A drive through a house"), (320, 240), [], 85, tracks)
    sheet = document.sheets[0]
    view = replace(sheet.views[0], window_world=Rectangle(-2.0, -1.5, 2.0, 1.5))
    scene = scene_of(placed, camera)
    *closed, last = scene.objects
    number = count(1)
    opened = [
        replace(
            house,
            solid=Extrusion(depth=1.8),
            points=tuple(SpacePoint(f"p{next(number)}", x, y) for x, y in _GATE),
        )
        for house in closed
    ]
    return Document((replace(sheet, views=(view,), scene=replace(scene, objects=(*opened, last))),))


def _turn() -> Document:
    """A quarter turn about y, where Euler's rings lock, and on from there."""
    turns = [(0, (0.0, 0.0, 1.0, 0.0)), (16, (90.0, 0.0, 1.0, 0.0)), (48, (120.0, 1.0, 1.0, 1.0))]
    houses = (
        (_("By quaternion"), -1.9, QUATERNION, 0x9CC8E6),
        (_("By Euler angles"), 1.9, EULER, 0xF0A878),
    )
    placed = [
        (name, House(1.4, 1.0, 1.8, 0.8), (x, 0.0, 0.0), 0.0, colour) for name, x, _way, colour in houses
    ]
    camera = Camera(
        eye=Point3D(0.0, 2.4, 8.0), look_at=Point3D(0.0, 0.0, 0.0), near=0.1, far=40.0, distance=3.0
    )
    scene = scene_of(placed, camera)
    turning = [
        replace(thing, transforms=(Rotate3D(f"r{number}"), *thing.transforms))
        for number, thing in enumerate(scene.objects, 1)
    ]

    def tracks(_figures: Sequence[AnyFigure]) -> Iterable[tuple[str, Sequence[Keyed]]]:
        for thing in turning:
            yield f"{thing.id}/{thing.transforms[0].id}/*", [(frame, turn, "linear") for frame, turn in turns]

    sheet = _document(_("Two ways to turn in space"), (320, 240), [], 49, tracks).sheets[0]
    assert sheet.motion is not None
    ways = tuple(
        replace(track, keys=tuple(replace(key, turning=house[2]) for key in track.keys))
        for track, house in zip(sheet.motion.tracks, houses, strict=True)
    )
    view = replace(sheet.views[0], window_world=Rectangle(-1.6, -1.2, 1.6, 1.2))
    scene = replace(scene, objects=tuple(turning))
    return Document((replace(sheet, views=(view,), scene=scene, motion=replace(sheet.motion, tracks=ways)),))
