"""Curves, and edits of them, made by hypothesis."""

from collections.abc import Callable

import numpy as np
from hypothesis import strategies as st

from workbench.document.building import Edit
from workbench.document.curves import edits as curve_edits
from workbench.document.curves.knot_removal import remove_knot
from workbench.document.laws import needed_knots
from workbench.document.model import ENDS, JOINTS, KNOT_RULES, SPLINES, Curve, CurvePoint, Document, Knot
from workbench.document.samples.figures import document_of

near = st.integers(-60, 60).map(float) | st.floats(-100, 100)
places = st.tuples(near, near)


@st.composite
def curves(draw: st.DrawFn, spline: str = "", identity: str = "", most: int = 12) -> Curve:
    """A sound curve, with ids made of ``identity`` or empty ones; it may have too few points to be drawn."""
    count = draw(st.integers(1, most))
    points = tuple(
        CurvePoint(
            f"{identity}p{i}" if identity else "",
            *draw(places),
            weight=draw(st.sampled_from([1.0, 0.5, 3.0])),
            tangent_x=draw(st.sampled_from([0.0, 2.0])),
            joint=draw(st.sampled_from(JOINTS)),
        )
        for i in range(count)
    )
    bare = Curve(
        identity,
        points,
        "bresenham_line",
        spline=spline or draw(st.sampled_from(SPLINES)),
        degree=draw(st.integers(1, 7)),
        closed=draw(st.booleans()),
        knot_rule=draw(st.sampled_from(KNOT_RULES)),
        alpha=draw(st.sampled_from([0.0, 0.5, 1.0])),
        tension=draw(st.sampled_from([0.0, 0.5, -0.5])),
        bias=draw(st.sampled_from([0.0, 0.25])),
        continuity=draw(st.sampled_from([0.0, 0.25])),
        ends=draw(st.sampled_from(ENDS)),
    )
    if bare.knot_rule != "free":
        return bare
    steps = draw(
        st.lists(
            st.sampled_from([0.0, 1.0, 0.5, 2.0]), min_size=needed_knots(bare), max_size=needed_knots(bare)
        )
    )
    values = np.cumsum(steps).tolist()
    knots = tuple(Knot(f"{identity}k{i}" if identity else "", u) for i, u in enumerate(values))
    return Curve(**{name: getattr(bare, name) for name in bare.__struct_fields__} | {"knots": knots})


@st.composite
def documents_with_curves(draw: st.DrawFn, spline: str = "") -> Document:
    """One sheet with one to three curves, whose ids are the document's."""
    made = draw(st.lists(curves(spline), min_size=1, max_size=3))
    return document_of("Curves", 320, 200, made)


@st.composite
def curve_edit_of(draw: st.DrawFn, document: Document) -> Edit:
    """An edit of one of the curves of ``document``, which it may still refuse."""
    sheet = document.sheets[0]
    curve = draw(st.sampled_from([f for f in sheet.figures if isinstance(f, Curve)]))
    here = f"{sheet.id}/{curve.id}"
    point = draw(st.sampled_from(curve.points_world))
    some = st.lists(st.sampled_from(curve.points_world), min_size=1, max_size=3, unique=True).map(
        lambda chosen: [f"{here}/{p.id}/*" for p in chosen]
    )
    one, name = st.just(f"{here}/{point.id}/x"), st.just(curve.id)
    index = st.none() | st.integers(0, len(curve.points_world))
    choices: list[Callable[[], st.SearchStrategy[Edit]]] = [
        lambda: st.builds(curve_edits.move_curve_points, st.dictionaries(one, places, min_size=1)),
        lambda: st.builds(curve_edits.add_points, name, st.lists(places, max_size=3), index),
        lambda: st.builds(curve_edits.add_path_point, name, near, near, st.none() | places, st.booleans()),
        lambda: st.builds(curve_edits.remove_points, some),
        lambda: st.builds(curve_edits.set_spline, name, st.sampled_from(SPLINES)),
        lambda: st.builds(curve_edits.set_beside, name, st.lists(st.sampled_from(SPLINES), max_size=3)),
        lambda: st.builds(curve_edits.set_degree, name, st.integers(1, 7)),
        lambda: st.builds(curve_edits.set_knot_rule, name, st.sampled_from(KNOT_RULES)),
        lambda: st.builds(curve_edits.set_weights, st.dictionaries(one, st.floats(1e-9, 1e9), min_size=1)),
        lambda: st.builds(curve_edits.set_joint, some, st.sampled_from(JOINTS)),
        lambda: st.builds(curve_edits.set_curve_closed, name, st.booleans()),
    ]
    if curve.knots:
        knot = draw(st.sampled_from(curve.knots))
        choices.append(
            lambda: st.builds(
                curve_edits.set_knot, st.just(f"{here}/{knot.id}/u"), st.floats(knot.u - 1, knot.u + 1)
            )
        )
        choices.append(
            lambda: st.builds(remove_knot, st.just(f"{here}/{knot.id}/u"), st.sampled_from([0.01, 1e3]))
        )
    return draw(draw(st.sampled_from(choices))())
