"""Documents and edits made by hypothesis, for the laws of this folder."""

from typing import Any

from hypothesis import strategies as st

from workbench.document import edits
from workbench.document.model import (
    LINE_CLIPPERS,
    POLYGON_CLIPPERS,
    AnyFigure,
    Circle,
    Document,
    Ellipse,
    Figure,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
    WorldPoint,
    whole_sheet,
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
    kind: type[Figure] = draw(st.sampled_from([Line, Polyline, Polygon, Circle, Ellipse, SeedFill]))
    count = draw(st.integers(kind.least_points, min(kind.most_points, 7)))
    points = tuple(
        WorldPoint(f"{identity}p{i}" if identity else "", draw(coordinates), draw(coordinates))
        for i in range(count)
    )
    more: dict[str, Any] = {}
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
                draw(rectangles()),
                draw(st.just(whole_sheet(width, height)) | rectangles()),
                draw(palettes),
                tuple(draw(figures(f"s{s}f{f}-")) for f in range(draw(st.integers(0, 3)))),
                draw(st.integers(0, 2)),
                draw(st.none() | rectangles()),
                draw(st.sampled_from(LINE_CLIPPERS)),
                draw(st.sampled_from(POLYGON_CLIPPERS)),
            )
        )
    return Document(tuple(sheets), draw(st.integers(0, 50)))


@st.composite
def sound_edits(draw: st.DrawFn, document: Document) -> edits.Edit:
    """An edit that ``document`` may still refuse (the last sheet, a polyline's last two points)."""
    sheet = draw(st.sampled_from(document.sheets))
    size = st.integers(1, 200)
    of_sheet: list[st.SearchStrategy[edits.Edit]] = [
        st.builds(edits.add_figure, st.just(sheet.id), figures()),
        st.builds(edits.add_sheet, st.sampled_from(document.sheets)),
        st.builds(edits.remove_sheet, st.just(sheet.id)),
        st.builds(edits.rename_sheet, st.just(sheet.id), names),
        st.builds(edits.reorder_sheet, st.just(sheet.id), st.integers(0, len(document.sheets) - 1)),
        st.builds(edits.set_sheet_size, st.just(sheet.id), size, size),
        st.builds(edits.set_window, st.just(sheet.id), rectangles()),
        st.builds(edits.set_viewport, st.just(sheet.id), rectangles()),
        st.builds(edits.set_palette, st.just(sheet.id), palettes),
        st.builds(edits.set_clip, st.just(sheet.id), st.none() | rectangles()),
        st.builds(edits.set_clippers, st.just(sheet.id), st.sampled_from(LINE_CLIPPERS)),
    ]
    if not sheet.figures or draw(st.integers(0, 3)) == 0:
        return draw(st.one_of(of_sheet))
    figure = draw(st.sampled_from(sheet.figures))
    point = draw(st.sampled_from(figure.points_world))
    at = f"{sheet.id}/{figure.id}/{point.id}"
    some = st.lists(st.sampled_from([f.id for f in sheet.figures]), min_size=1, unique=True)
    near = st.floats(-100, 100)
    choices: list[st.SearchStrategy[edits.Edit]] = [
        st.builds(edits.move_points, st.fixed_dictionaries({f"{at}/x": st.tuples(coordinates, coordinates)})),
        st.builds(edits.set_attribute, st.just(f"{at}/y"), coordinates),
        st.builds(edits.set_attribute, st.just(f"{sheet.id}/{figure.id}/colour"), st.integers(0, 2)),
        st.builds(edits.set_algorithm, st.just(figure.id), st.sampled_from(figure.algorithms)),
        st.builds(edits.remove_figures, some),
        st.builds(edits.duplicate_figures, some, near, near),
        st.builds(edits.move_figures, some, near, near),
        st.builds(edits.reorder, st.just(figure.id), st.integers(0, len(sheet.figures) - 1)),
        st.builds(edits.rename_figure, st.just(figure.id), names),
    ]
    if isinstance(figure, Polyline):
        choices.append(st.builds(edits.set_closed, st.just(figure.id), st.booleans()))
    if isinstance(figure, Polygon):
        corners = st.lists(st.tuples(coordinates, coordinates), min_size=3, max_size=5)
        choices.append(st.builds(edits.add_ring, st.just(figure.id), corners))
    if isinstance(figure, Polyline | Polygon):
        choices += [
            st.builds(
                edits.insert_point,
                st.just(figure.id),
                st.integers(0, len(figure.points_world)),
                coordinates,
                coordinates,
            ),
            st.builds(edits.remove_point, st.just(at + "/*")),
        ]
    return draw(st.one_of(choices))
