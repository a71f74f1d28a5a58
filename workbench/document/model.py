"""The picture as a value. Nothing here changes in place: an edit is a function from document to document.

Two frames, named in every field: world (float) and device (integer pixels, origin at the lower left).
Ids are short texts, unique in their document, and survive edits, insertion and undo.
"""

from typing import ClassVar

import msgspec


class WorldPoint(msgspec.Struct, frozen=True):
    """A control point, in world coordinates."""

    id: str
    x: float
    y: float


class Rectangle(msgspec.Struct, frozen=True):
    """A window (world) or viewport (device), sides parallel to the axes; xmin < xmax, ymin < ymax."""

    xmin: float
    ymin: float
    xmax: float
    ymax: float


class Figure(msgspec.Struct, frozen=True, tag_field="kind"):
    """What all figures share. ``colour`` is an index into the sheet's palette; ``algorithm`` a catalogue slug."""

    topic: ClassVar[str] = ""

    id: str
    points_world: tuple[WorldPoint, ...]
    algorithm: str
    colour: int = 1
    name: str = ""
    visible: bool = True


class Line(Figure, frozen=True, tag="line"):
    """A segment between two points."""

    topic: ClassVar[str] = "lines"


class Polyline(Figure, frozen=True, tag="polyline"):
    """Segments through two or more points, and back to the first when closed."""

    topic: ClassVar[str] = "lines"

    closed: bool = False


class Circle(Figure, frozen=True, tag="circle", kw_only=True):
    """A circle about its one point."""

    topic: ClassVar[str] = "circles"

    radius_world: float


class Ellipse(Figure, frozen=True, tag="ellipse", kw_only=True):
    """An ellipse with axes parallel to x and y, about its one point."""

    topic: ClassVar[str] = "ellipses"

    radius_x_world: float
    radius_y_world: float


class SeedFill(Figure, frozen=True, tag="seed_fill", kw_only=True):
    """A fill from its one point, evaluated on what lies below it; ``boundary`` is a palette index."""

    topic: ClassVar[str] = "seed_fill"

    boundary: int = 1


AnyFigure = Line | Polyline | Circle | Ellipse | SeedFill


class Sheet(msgspec.Struct, frozen=True):
    """One picture: a size in pixels, window and viewport, palette (0xRRGGBB), figures from back to front."""

    id: str
    name: str
    width_px: int
    height_px: int
    window_world: Rectangle
    viewport_device: Rectangle
    palette: tuple[int, ...]
    figures: tuple[AnyFigure, ...] = ()
    background: int = 0


class Document(msgspec.Struct, frozen=True):
    """A list of sheets, at least one."""

    sheets: tuple[Sheet, ...]
