"""The built-in pictures of transforms: figures in a small world, four pixels to a unit, with their chains."""

from itertools import count

from msgspec.structs import replace

from workbench.document.building import with_ids, without_ids
from workbench.document.model import AnyFigure, Document, Rectangle, Sheet, View
from workbench.document.samples.figures import PALETTE, Example, Places, document_of, line, polygon
from workbench.document.scene.links import Rotate3D
from workbench.document.scene.model import Camera, Material, Object, Point3D, Scene
from workbench.document.scene.solids import House
from workbench.document.transforms.links import AnyLink, Reflect, Rotate, Scale, Shear, Translate
from workbench.language import _

_PIXELS_PER_UNIT = 4
_CAMERA = Camera(eye=Point3D(7.0, 5.0, 9.0), look_at=Point3D(0.5, 1.0, 0.5), near=0.1, far=40.0)


def transform_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "transform-pivot",
            _("A turn about a point"),
            _("A triangle turned by 45° about (3, 3): to the origin, turned, and back, matrix by matrix."),
            "transform",
            _document(_("A turn about a point"), (-4, -3, 12, 7), [_triangle()]),
        ),
        Example(
            "transform-clock",
            _("The hands of a clock"),
            _("Both hands are drawn upright, scaled and turned about the middle: twenty past four."),
            "transform",
            _document(_("The hands of a clock"), (-9, -7, 9, 7), _clock()),
        ),
        Example(
            "transform-leaf",
            _("A mirrored leaf"),
            _("The same half of a leaf twice, the second reflected in its midrib, y = x/2 + 2."),
            "transform",
            _document(_("A mirrored leaf"), (-5, -2, 11, 10), _leaf()),
        ),
        Example(
            "transform-shear",
            _("A sheared square"),
            _("A unit square sheared along x by 1/2, relative to the line y = −1."),
            "transform",
            _document(_("A sheared square"), (-3, -2, 5, 3), [_square()], 8),
        ),
        Example(
            "transform-order",
            _("Turned and moved"),
            _("A flag turned by 90° and then moved: exchange the two links and compare."),
            "transform",
            _document(_("Turned and moved"), (-5, -3, 11, 8), [_flag()]),
        ),
        Example(
            "transform-axis",
            _("A turn about an axis in space"),
            _("A house turned by 90° about the axis from (1, 0, 1) to (2, 2, 3), in seven steps."),
            "transform",
            _in_space(),
            "space",
        ),
    ]


def _in_space() -> Document:
    """The course's axis, through (1, 0, 1) along (1, 2, 2)."""
    turn = Rotate3D("t1", angle=90.0, x_pivot=1.0, z_pivot=1.0, x_axis=1.0, y_axis=2.0, z_axis=2.0)
    house = Object("o1", House(2.0, 1.5, 2.0, 1.0), "m1", _("House"), transforms=(turn,))
    scene = Scene((house,), (Material("m1", name=_("Blue"), colour=0x9CC8E6),), camera=_CAMERA)
    document = document_of(_("A turn about an axis in space"), 320, 240, ())
    return Document((replace(document.sheets[0], scene=scene),))


def _document(
    name: str, window: tuple[int, int, int, int], figures: list[AnyFigure], scale: int = _PIXELS_PER_UNIT
) -> Document:
    """One sheet whose pixel centres lie on multiples of 1/scale of the window."""
    xmin, ymin, xmax, ymax = window
    wide, high = scale * (xmax - xmin), scale * (ymax - ymin)
    world = Rectangle(float(xmin), float(ymin), float(xmax), float(ymax))
    view = View("v1", world, Rectangle(0.0, 0.0, float(wide), float(high)))
    own, parts = count(1), count(1)
    numbered = tuple(with_ids(without_ids(figure), own, parts) for figure in figures)
    return Document((Sheet("s1", name, wide + 1, high + 1, (view,), PALETTE, numbered),))


def _with(figure: AnyFigure, *chain: AnyLink) -> AnyFigure:
    return replace(figure, transforms=chain)


def _area(corners: Places, colour: int, name: str) -> AnyFigure:
    return polygon([corners], colour, name)


def _triangle() -> AnyFigure:
    return _with(
        _area([(5.0, 6.0), (6.0, 2.0), (4.0, 1.0)], 1, _("Triangle")),
        Rotate("", angle=45.0, x_pivot=3.0, y_pivot=3.0),
    )


def _clock() -> list[AnyFigure]:
    marks: list[AnyFigure] = [
        _with(
            line((0, 5), (0, 6), 7, name=_("{hour} o'clock").format(hour=hour)),
            Rotate("", angle=-30.0 * hour),
        )
        for hour in range(1, 13)
    ]
    hand = [(-0.25, -0.75), (0.25, -0.75), (0.0, 3.0)]
    return [
        *marks,
        _with(_area(hand, 2, _("Minute hand")), Scale("", sx=1.0, sy=1.5), Rotate("", angle=-120.0)),
        _with(_area(hand, 1, _("Hour hand")), Rotate("", angle=-130.0)),
    ]


def _leaf() -> list[AnyFigure]:
    half: Places = [(0.0, 2.0), (1.0, 4.5), (3.0, 5.75), (5.5, 6.0), (8.0, 6.0)]
    midrib = line((-1, 1.5), (8.5, 6.25), 7, name=_("Midrib"))
    return [
        midrib,
        _area(half, 3, _("Half of the leaf")),
        _with(
            _area(half, 1, _("Other half")),
            Reflect("", angle=26.56505117707799, x_pivot=0.0, y_pivot=2.0),
        ),
    ]


def _square() -> AnyFigure:
    return _with(
        _area([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], 1, _("Square")),
        Shear("", sh_x=0.5, y_ref=-1.0),
    )


def _flag() -> AnyFigure:
    return _with(
        _area([(1.0, 0.0), (1.25, 0.0), (1.25, 2.0), (3.0, 2.75), (1.0, 3.5)], 4, _("Flag")),
        Rotate("", angle=90.0),
        Translate("", tx=6.0, ty=1.0),
    )
