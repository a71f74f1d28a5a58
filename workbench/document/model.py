"""The picture as a value. Nothing here changes in place: an edit is a function from document to document.

Two frames, named in every field: world (float) and device (integer pixels, origin at the lower left).
Ids are short texts, unique in their document, and survive edits, insertion and undo.
"""

from collections.abc import Iterable
from itertools import pairwise
from typing import Annotated, Any, ClassVar, Self

import msgspec

from workbench.algorithms.catalogue import clipping, drawing
from workbench.document.fields import Choice, Number
from workbench.document.motion.model import Motion
from workbench.document.numbers import MAX_COORDINATE, coordinate
from workbench.document.parts import WithParts
from workbench.document.scene.model import Scene
from workbench.document.transforms.chains import Transformed
from workbench.language import _

MAX_SIDE_PX = 4096
MAX_PALETTE = 256
MAX_DEGREE = 7
MAX_ID = 2**53
WEIGHTS = (1e-9, 1e9)


def _radius(label: str, symbol: str) -> Number:
    return Number(label=label, symbol=symbol, low=0.0, high=MAX_COORDINATE, unit="world", keyed=True)


def _side(label: str) -> Number:
    return Number(label=label, low=1, high=MAX_SIDE_PX, whole=True, unit="px", keyed=False)


def _shape(label: str, low: float, high: float) -> Number:
    return Number(label=label, low=low, high=high, keyed=True)


def _palette_index(label: str) -> Number:
    return Number(label=label, whole=True, indexes="palette", keyed=False)


class WorldPoint(msgspec.Struct, frozen=True, forbid_unknown_fields=True, cache_hash=True):
    """A control point, in world coordinates. Its id begins with ``letter`` by habit."""

    letter: ClassVar[str] = "p"

    id: str
    x: Annotated[float, coordinate("x")]
    y: Annotated[float, coordinate("y")]


class Rectangle(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A window (world) or viewport (device), sides parallel to the axes; xmin < xmax, ymin < ymax."""

    xmin: Annotated[float, coordinate("x_min")]
    ymin: Annotated[float, coordinate("y_min")]
    xmax: Annotated[float, coordinate("x_max")]
    ymax: Annotated[float, coordinate("y_max")]


def whole_sheet(width_px: int, height_px: int) -> Rectangle:
    """The device rectangle that a picture of this size covers."""
    return Rectangle(-0.5, -0.5, width_px - 0.5, height_px - 0.5)


class Figure(
    WithParts,
    Transformed,
    frozen=True,
    forbid_unknown_fields=True,
    omit_defaults=True,
    tag_field="kind",
    cache_hash=True,
):
    """What all figures share. ``colour`` is a palette index of the sheet, ``algorithm`` a catalogue slug.

    ``algorithms`` are the slugs that can draw this kind of figure, as the catalogue has them, the first one
    new figures get; ``least_points`` and ``most_points`` bound the number of its control points. A slug that
    the catalogue does not have is kept: a newer program may have written it. ``transforms`` is a chain whose
    first link acts first on the points; it is drawn where the chain takes them. Figures of a sheet with the
    same ``group``, other than 0, are selected together.
    """

    letter: ClassVar[str] = "f"
    topic: ClassVar[str] = ""
    algorithms: ClassVar[tuple[str, ...]] = ()
    least_points: ClassVar[int] = 1
    most_points: ClassVar[int] = 1

    id: str
    points_world: tuple[WorldPoint, ...]
    algorithm: str
    colour: Annotated[int, _palette_index(_("colour"))] = 1
    name: str = ""
    visible: bool = True
    group: Annotated[int, Number(label=_("group"), low=0, high=1_000_000, whole=True, keyed=False)] = 0

    @property
    def drawn_with(self) -> str:
        """The slug that draws it: its own, or where the catalogue has none of that name, the kind's first."""
        return self.algorithm if self.algorithm in self.algorithms else self.algorithms[0]

    @property
    def radii_world(self) -> tuple[float, float]:
        """Its radii along x and y, before its chain; 0 for a figure that has none."""
        return 0.0, 0.0

    def with_radii(self, across: float, up: float) -> Self:
        """The figure with these radii along x and y: a circle takes the first; one that has none stays."""
        return self


class Line(Figure, frozen=True, tag="line"):
    """A segment between two points."""

    topic: ClassVar[str] = "lines"
    algorithms: ClassVar[tuple[str, ...]] = drawing("line", first="bresenham_line")
    least_points: ClassVar[int] = 2
    most_points: ClassVar[int] = 2


class Polyline(Figure, frozen=True, tag="polyline"):
    """Segments through two or more points, and back to the first when closed."""

    topic: ClassVar[str] = "lines"
    algorithms: ClassVar[tuple[str, ...]] = drawing("polyline", first="bresenham_line")
    least_points: ClassVar[int] = 2
    most_points: ClassVar[int] = 100_000

    closed: bool = False


class Polygon(Figure, frozen=True, tag="polygon"):
    """An area inside one or more rings of at least three corners each, one ring after the other.

    ``ring_ends`` is one past each ring's last corner; empty means one ring. ``closed_interior`` paints every
    centre inside or on the boundary, else the half-open rule holds; ``nonzero`` counts windings, else the
    crossings are paired (even-odd).
    """

    topic: ClassVar[str] = "polygons"
    algorithms: ClassVar[tuple[str, ...]] = drawing("polygon", first="scan_line_exact")
    least_points: ClassVar[int] = 3
    most_points: ClassVar[int] = 100_000

    ring_ends: tuple[Annotated[int, Number(label=_("list of rings"), whole=True, keyed=False)], ...] = ()
    closed_interior: bool = False
    nonzero: bool = False

    @property
    def rings(self) -> tuple[tuple[WorldPoint, ...], ...]:
        """The corners of each ring."""
        ends = self.ring_ends or (len(self.points_world),)
        return tuple(self.points_world[a:b] for a, b in pairwise((0, *ends)))


class Circle(Figure, frozen=True, tag="circle", kw_only=True):
    """A circle about its one point; a radius of 0 is a single pixel."""

    topic: ClassVar[str] = "circles"
    algorithms: ClassVar[tuple[str, ...]] = drawing("circle", first="midpoint_circle")

    radius_world: Annotated[float, _radius(_("radius"), "r")]

    @property
    def radii_world(self) -> tuple[float, float]:
        """Its radius, twice."""
        return self.radius_world, self.radius_world

    def with_radii(self, across: float, up: float) -> Self:
        """The circle with the radius ``across``."""
        return msgspec.structs.replace(self, radius_world=across)


class Ellipse(Figure, frozen=True, tag="ellipse", kw_only=True):
    """An ellipse with axes parallel to x and y, about its one point; a radius of 0 makes it a segment."""

    topic: ClassVar[str] = "circles"
    algorithms: ClassVar[tuple[str, ...]] = drawing("ellipse", first="midpoint_ellipse")

    radius_x_world: Annotated[float, _radius(_("horizontal radius"), "r_x")]
    radius_y_world: Annotated[float, _radius(_("vertical radius"), "r_y")]

    @property
    def radii_world(self) -> tuple[float, float]:
        """Both radii."""
        return self.radius_x_world, self.radius_y_world

    def with_radii(self, across: float, up: float) -> Self:
        """The ellipse with these radii."""
        return msgspec.structs.replace(self, radius_x_world=across, radius_y_world=up)


class SeedFill(Figure, frozen=True, tag="seed_fill", kw_only=True):
    """A fill from its one point, evaluated on what lies below it; ``boundary`` is a palette index.

    Flood fills ignore ``boundary``; the recursive fill is stopped ``recursion_limit`` calls deep.
    """

    topic: ClassVar[str] = "seed_fill"
    algorithms: ClassVar[tuple[str, ...]] = drawing("seed_fill", first="boundary_fill_4")

    boundary: Annotated[int, _palette_index(_("boundary colour"))] = 1
    recursion_limit: Annotated[
        int, Number(label=_("recursion limit"), low=10, high=4_000, whole=True, keyed=False)
    ] = 1000


SPLINES = (
    "bezier",
    "bezier_path",
    "b_spline",
    "nurbs",
    "hermite",
    "natural_cubic",
    "clamped_cubic",
    "periodic_cubic",
    "cardinal",
    "catmull_rom",
    "kochanek_bartels",
)
# Over knots, with a degree; with a derivative at points; with a tangent made of the neighbours of a point.
B_SPLINES = ("b_spline", "nurbs")
TANGENT_SPLINES = ("hermite", "clamped_cubic")
NEIGHBOUR_SPLINES = ("cardinal", "catmull_rom", "kochanek_bartels")
THROUGH = (*TANGENT_SPLINES, "natural_cubic", "periodic_cubic", *NEIGHBOUR_SPLINES)
JOINTS = ("corner", "smooth", "symmetric")
KNOT_RULES = ("open_uniform", "uniform", "free")
ENDS = ("through", "inner")
CONTINUITY_SIGNS = ("book", "paper")


class CurvePoint(WorldPoint, frozen=True, omit_defaults=True):
    """A control point of a curve.

    ``weight`` is what a NURBS gives it, above 0; (``tangent_x``, ``tangent_y``) the derivative there by u, in
    world units, for Hermite's curve and the ends of a clamped one; ``joint`` how the handles of a point on a
    path of Bézier pieces hang together: not at all, in one direction, or in one direction equally long.
    """

    weight: Annotated[
        float, Number(label=_("weight"), symbol="w", low=WEIGHTS[0], high=WEIGHTS[1], keyed=True)
    ] = 1.0
    tangent_x: Annotated[float, coordinate(_("x of the tangent"), "x'")] = 0.0
    tangent_y: Annotated[float, coordinate(_("y of the tangent"), "y'")] = 0.0
    joint: Annotated[str, Choice(JOINTS)] = JOINTS[0]


class Knot(msgspec.Struct, frozen=True, forbid_unknown_fields=True, cache_hash=True):
    """One knot of a B-spline, at the parameter ``u``. Its id begins with ``letter`` by habit."""

    letter: ClassVar[str] = "k"

    id: str
    u: Annotated[float, coordinate("u", unit="")]


class Curve(Figure, frozen=True, tag="curve", omit_defaults=True):
    """A curve of the kind ``spline`` over its points; ``beside`` are kinds shown over the same points.

    ``algorithm`` draws the lines that it is flattened into, nowhere farther from it than ``tolerance_px``.
    The points of a path are point, handle, handle, point and so on; what is left over waits for more.
    ``knots`` are there only under the rule "free": degree + 1 more than points, or for one turn of a closed
    curve 1 more. ``tension``, ``continuity`` and ``bias`` shape cardinal and Kochanek-Bartels splines,
    ``alpha`` Catmull-Rom's; with ``ends`` "inner" the outer points of these three only steer, as in the
    course. ``continuity_sign``: Hearn and Baker's, or the opposite one, of Kochanek and Bartels' paper.
    """

    topic: ClassVar[str] = "curves"
    algorithms: ClassVar[tuple[str, ...]] = drawing("curve", first="bresenham_line")
    least_points: ClassVar[int] = 1
    most_points: ClassVar[int] = 10_000

    points_world: tuple[CurvePoint, ...]
    spline: Annotated[str, Choice(SPLINES)] = SPLINES[0]
    beside: tuple[Annotated[str, Choice(SPLINES)], ...] = ()
    degree: Annotated[int, Number(label=_("degree"), low=1, high=MAX_DEGREE, whole=True, keyed=False)] = 3
    closed: bool = False
    knot_rule: Annotated[str, Choice(KNOT_RULES)] = KNOT_RULES[0]
    knots: tuple[Knot, ...] = ()
    tension: Annotated[float, _shape(_("tension"), -10.0, 10.0)] = 0.0
    continuity: Annotated[float, _shape(_("continuity"), -10.0, 10.0)] = 0.0
    bias: Annotated[float, _shape(_("bias"), -10.0, 10.0)] = 0.0
    alpha: Annotated[float, _shape(_("alpha"), 0.0, 1.0)] = 0.5
    ends: Annotated[str, Choice(ENDS)] = ENDS[0]
    continuity_sign: Annotated[str, Choice(CONTINUITY_SIGNS)] = CONTINUITY_SIGNS[0]
    tolerance_px: Annotated[
        float, Number(label=_("tolerance"), low=1e-4, high=100.0, unit="px", keyed=False)
    ] = 0.1


AnyFigure = Line | Polyline | Polygon | Circle | Ellipse | SeedFill | Curve

LINE_CLIPPERS = clipping("line", first="cohen_sutherland")
POLYGON_CLIPPERS = clipping("polygon", first="sutherland_hodgman")


MODES = ("stretch", "fit", "fill")


class View(msgspec.Struct, frozen=True, forbid_unknown_fields=True, cache_hash=True):
    """One look at a sheet's world: a window (world) and the viewport (device) that shows it.

    ``mode`` says what becomes of the window's proportions: it is stretched onto the viewport, fits into it as
    a whole, or fills it, cut off where it is longer; nothing is painted outside of the viewport.
    ``clip_world`` is the window that figures are clipped to before they are scan converted, by the clippers
    of the sheet; None clips nothing. Its id begins with ``letter`` by habit.
    """

    letter: ClassVar[str] = "v"

    id: str
    window_world: Rectangle
    viewport_device: Rectangle
    name: str = ""
    clip_world: Rectangle | None = None
    mode: Annotated[str, Choice(MODES)] = MODES[0]


class Sheet(msgspec.Struct, frozen=True, forbid_unknown_fields=True, cache_hash=True):
    """One picture: a size in pixels, views in the order of painting, palette (0xRRGGBB), figures.

    The figures come from back to front. ``background`` is the palette index of the paper: the canvas shows it
    as the theme's canvas colour, the tube as an unlit screen. The clippers work where a view clips; of these
    too a slug that the catalogue does not have is kept. The view plane of the ``scene``, if there is one, is
    the sheet's world. All else is as the sheet stands; ``motion.evaluation.at`` gives it in a frame.
    """

    letter: ClassVar[str] = "s"

    id: str
    name: str
    width_px: Annotated[int, _side(_("width"))]
    height_px: Annotated[int, _side(_("height"))]
    views: tuple[View, ...]
    palette: tuple[
        Annotated[int, Number(label=_("palette"), low=0, high=0xFFFFFF, whole=True, keyed=False)], ...
    ]
    figures: tuple[AnyFigure, ...] = ()
    background: Annotated[int, _palette_index(_("background"))] = 0
    line_clipper: str = LINE_CLIPPERS[0]
    polygon_clipper: str = POLYGON_CLIPPERS[0]
    scene: Scene | None = None
    motion: Motion | None = None

    @property
    def lines_clipped_with(self) -> str:
        """The slug that clips lines: the one named, or where the catalogue has no such, the first."""
        return self.line_clipper if self.line_clipper in LINE_CLIPPERS else LINE_CLIPPERS[0]

    @property
    def polygons_clipped_with(self) -> str:
        """The slug that clips polygons, likewise."""
        return self.polygon_clipper if self.polygon_clipper in POLYGON_CLIPPERS else POLYGON_CLIPPERS[0]

    def place_of(self, figure: str) -> int:
        """The place among the figures, from the back, of the one with this id; -1 where there is none.

        In another frame a figure is another value, so it is not looked for as such.
        """
        return next((place for place, each in enumerate(self.figures) if each.id == figure), -1)

    def together(self, chosen: Iterable[str]) -> tuple[str, ...]:
        """The ids ``chosen``, followed by those of all figures that are in a group with one of them."""
        ids = dict.fromkeys(chosen)
        groups = {figure.group for figure in self.figures if figure.group and figure.id in ids}
        return tuple(ids | {figure.id: None for figure in self.figures if figure.group in groups})

    @property
    def things(self) -> tuple[Any, ...]:
        """What has an id of its own and parts: figures, what the scene is made of, and tracks."""
        scene = () if self.scene is None else self.scene.things
        tracks = () if self.motion is None else self.motion.tracks
        return (*self.figures, *scene, *tracks) if scene or tracks else self.figures

    @property
    def first_view(self) -> View:
        """The view in which figures are drawn by hand and stepped."""
        return self.views[0]

    @property
    def seen(self) -> "tuple[Sheet, ...]":
        """The sheet once for each view, with that view alone, in the order of painting."""
        if len(self.views) == 1:
            return (self,)
        return tuple(msgspec.structs.replace(self, views=(view,)) for view in self.views)


class Document(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A list of sheets, at least one. ``last_id`` is the highest number of an id that was removed.

    No id is given twice in the life of a document: what refers to a removed figure never finds another.
    """

    sheets: tuple[Sheet, ...]
    last_id: Annotated[int, Number(label="last_id", low=0, high=MAX_ID, whole=True, keyed=False)] = 0
