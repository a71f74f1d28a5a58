"""Documents and edits made by hypothesis, for the laws of this folder."""

from collections.abc import Callable
from typing import Any

from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.curves.made_curves import curves
from workbench.document import edits
from workbench.document.fields import numbers_of
from workbench.document.model import (
    LINE_CLIPPERS,
    MODES,
    POLYGON_CLIPPERS,
    AnyFigure,
    Circle,
    Curve,
    Document,
    Ellipse,
    Figure,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
    View,
    WorldPoint,
    whole_sheet,
)
from workbench.document.transforms.links import (
    MIRRORS,
    Affine,
    AnyLink,
    Reflect,
    Rotate,
    Scale,
    Shear,
    Translate,
)

coordinates = st.floats(-1e6, 1e6) | st.integers(-60, 60).map(float)
radii = st.floats(0, 1e6) | st.integers(0, 40).map(float)
names = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
palettes = st.lists(st.integers(0, 0xFFFFFF), min_size=3, max_size=6).map(tuple)


@st.composite
def rectangles(draw: st.DrawFn) -> Rectangle:
    x, y = draw(st.floats(-1e5, 1e5)), draw(st.floats(-1e5, 1e5))
    return Rectangle(x, y, x + draw(st.floats(0.5, 1e5)), y + draw(st.floats(0.5, 1e5)))


@st.composite
def figures(draw: st.DrawFn, identity: str = "") -> AnyFigure:
    """A figure of any kind, with ids made of ``identity``, or empty ones; its colours are 0 to 2."""
    kind: type[Figure] = draw(st.sampled_from([Line, Polyline, Polygon, Circle, Ellipse, SeedFill, Curve]))
    chain = draw(chains(identity))
    if kind is Curve:
        return replace(draw(curves(identity=identity, most=7)), transforms=chain)
    count = draw(st.integers(kind.least_points, min(kind.most_points, 7)))
    points = tuple(
        WorldPoint(f"{identity}p{i}" if identity else "", draw(coordinates), draw(coordinates))
        for i in range(count)
    )
    more: dict[str, Any] = {"transforms": chain, "group": draw(st.integers(0, 2))}
    if kind is Polyline:
        more["closed"] = draw(st.booleans())
    elif kind is Circle:
        more["radius_world"] = draw(radii)
    elif kind is Ellipse:
        more.update(radius_x_world=draw(radii), radius_y_world=draw(radii))
    elif kind is Polygon:
        whole = st.just((count,)) | st.just(())
        more["ring_ends"] = draw(whole | st.just((3, count)) if count >= 6 else whole)
        more.update(closed_interior=draw(st.booleans()), nonzero=draw(st.booleans()))
    elif kind is SeedFill:
        more.update(boundary=draw(st.integers(0, 2)), recursion_limit=draw(st.integers(10, 4000)))
    figure: AnyFigure = kind(  # type: ignore[assignment]
        identity,
        points,
        draw(st.sampled_from(kind.algorithms)),
        draw(st.integers(0, 2)),
        draw(names),
        draw(st.booleans()),
        **more,
    )
    return figure


@st.composite
def views(draw: st.DrawFn, identity: str, width: int, height: int) -> View:
    viewport = draw(st.just(whole_sheet(width, height)) | rectangles())
    clip = draw(st.none() | rectangles())
    return View(identity, draw(rectangles()), viewport, draw(names), clip, draw(st.sampled_from(MODES)))


@st.composite
def links(draw: st.DrawFn, identity: str = "") -> AnyLink:
    """A link of any kind, with any numbers but those that would make a long chain too large."""
    kind = draw(st.sampled_from([Translate, Rotate, Scale, Reflect, Shear, Affine]))
    values = {name: draw(_numbers_of_links(name)) for name in numbers_of(kind)}
    if kind is Reflect:
        values["mirror"] = draw(st.sampled_from(MIRRORS))
    link: AnyLink = kind(identity, draw(st.integers(0, 4)) > 0, **values)
    return link


def _numbers_of_links(name: str) -> st.SearchStrategy[Any]:
    if name == "angle":
        return st.floats(-720, 720) | st.integers(-8, 8).map(lambda k: 45.0 * k)
    small = name.startswith(("s", "m")) and name not in ("m13", "m23")
    return st.floats(-4, 4) | st.integers(-2, 2).map(float) if small else st.integers(-60, 60).map(float)


@st.composite
def chains(draw: st.DrawFn, identity: str = "", most: int = 4) -> tuple[AnyLink, ...]:
    """A chain of no link to ``most``, without ids or with such as end in t and a number."""
    count = draw(st.integers(0, most))
    return tuple(draw(links(f"{identity}t{k}" if identity else "")) for k in range(count))


@st.composite
def documents(draw: st.DrawFn) -> Document:
    sheets = []
    for s in range(draw(st.integers(1, 2))):
        width, height = draw(st.integers(1, 4096)), draw(st.integers(1, 4096))
        sheets.append(
            Sheet(
                f"s{s}",
                draw(names),
                width,
                height,
                tuple(draw(views(f"s{s}v{v}-", width, height)) for v in range(draw(st.integers(1, 2)))),
                draw(palettes),
                tuple(draw(figures(f"s{s}f{f}-")) for f in range(draw(st.integers(0, 3)))),
                draw(st.integers(0, 2)),
                draw(st.sampled_from(LINE_CLIPPERS)),
                draw(st.sampled_from(POLYGON_CLIPPERS)),
            )
        )
    return Document(tuple(sheets), draw(st.integers(0, 50)))


@st.composite
def sound_edits(draw: st.DrawFn, document: Document) -> edits.Edit:
    """An edit that ``document`` may still refuse (the last sheet, a polyline's last two points)."""
    sheet = draw(st.sampled_from(document.sheets))
    if sheet.figures and draw(st.integers(0, 3)):
        return draw(_edits_of_a_figure(sheet, draw(st.sampled_from(sheet.figures))))
    size = st.integers(1, 200)
    here, view = st.just(sheet.id), st.sampled_from([view.id for view in sheet.views])
    # Made only when drawn: to make a strategy takes longer than to draw from it.
    choices: list[Callable[[], st.SearchStrategy[edits.Edit]]] = [
        lambda: st.builds(edits.add_figure, here, figures()),
        lambda: st.builds(edits.add_sheet, st.sampled_from(document.sheets)),
        lambda: st.builds(edits.remove_sheet, here),
        lambda: st.builds(edits.rename_sheet, here, names),
        lambda: st.builds(edits.reorder_sheet, here, st.integers(0, len(document.sheets) - 1)),
        lambda: st.builds(edits.set_sheet_size, here, size, size),
        lambda: st.builds(edits.set_window, view, rectangles()),
        lambda: st.builds(edits.set_viewport, view, rectangles()),
        lambda: st.builds(edits.set_mode, view, st.sampled_from(MODES)),
        lambda: st.builds(edits.rename_view, view, names),
        lambda: st.builds(edits.remove_view, view),
        lambda: st.builds(edits.reorder_view, view, st.integers(0, len(sheet.views) - 1)),
        lambda: st.builds(edits.add_view, here, views("", 40, 30)),
        lambda: st.builds(edits.pan, view, coordinates, coordinates),
        lambda: st.builds(edits.zoom, view, st.floats(0.01, 100), coordinates, coordinates),
        lambda: st.builds(edits.set_palette, here, palettes),
        lambda: st.builds(edits.set_clip, view, st.none() | rectangles()),
        lambda: st.builds(edits.set_clipper, here, st.sampled_from((*LINE_CLIPPERS, *POLYGON_CLIPPERS))),
    ]
    return draw(draw(st.sampled_from(choices))())


@st.composite
def _edits_of_a_figure(draw: st.DrawFn, sheet: Sheet, figure: AnyFigure) -> edits.Edit:
    point = draw(st.sampled_from(figure.points_world))
    at = f"{sheet.id}/{figure.id}/{point.id}"
    here = st.just(figure.id)
    some = st.lists(st.sampled_from([f.id for f in sheet.figures]), min_size=1, unique=True)
    place = st.tuples(coordinates, coordinates)
    near = st.floats(-100, 100)
    choices: list[Callable[[], st.SearchStrategy[edits.Edit]]] = [
        lambda: st.builds(edits.move_points, st.fixed_dictionaries({f"{at}/x": place})),
        lambda: st.builds(edits.set_attribute, st.just(f"{at}/y"), coordinates),
        lambda: st.builds(edits.set_attribute, st.just(f"{sheet.id}/{figure.id}/colour"), st.integers(0, 2)),
        lambda: st.builds(edits.set_algorithm, here, st.sampled_from(figure.algorithms)),
        lambda: st.builds(edits.remove_figures, some),
        lambda: st.builds(edits.duplicate_figures, some, near, near),
        lambda: st.builds(edits.move_figures, some, near, near),
        lambda: st.builds(edits.reorder, here, st.integers(0, len(sheet.figures) - 1)),
        lambda: st.builds(edits.rename_figure, here, names),
    ]
    if isinstance(figure, Polyline):
        choices.append(lambda: st.builds(edits.set_closed, here, st.booleans()))
    if isinstance(figure, Polygon):
        corners = st.lists(place, min_size=3, max_size=5)
        choices.append(lambda: st.builds(edits.add_ring, here, corners))
    if isinstance(figure, Polyline | Polygon):
        index = st.integers(0, len(figure.points_world))
        choices += [
            lambda: st.builds(edits.insert_point, here, index, coordinates, coordinates),
            lambda: st.builds(edits.remove_point, st.just(at + "/*")),
        ]
    return draw(draw(st.sampled_from(choices))())
