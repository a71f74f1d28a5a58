"""Newell's depth sort: the painter's order, but proved for each pair, and split where there is none.

order       the pieces that are not painted yet, with their greatest depths, the farthest last
boxes       the box around each piece
P, p        the last of them and its number, which is painted next if nothing forbids it
Q, q        one that may have to be painted before P
marked      the pieces that were moved to the end once: a second time might go on for ever
split       number of the piece to be split, or NONE
settled     whether P passed a test with every Q
"""

from collections.abc import Iterator

from workbench.algorithms.counted import Counted, Kept
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.depth_sort_views import COLUMNS, VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.visibility.depth_tests import (
    NONE,
    Waiting,
    boxes_apart,
    cut_between,
    is_behind,
    is_in_front,
    pass_exchanged,
    projections_apart,
    put_by_depth,
    split_in_two,
)
from workbench.algorithms.visibility.painting import farthest_first
from workbench.algorithms.visibility.piece_painting import paint_piece
from workbench.algorithms.visibility.pieces import plane_of, whole
from workbench.algorithms.visibility.surface_marks import marks
from workbench.algorithms.visibility.surface_scene import ONE_PICTURE, SURFACES, surfaces_at_will
from workbench.algorithms.visibility.surfaces import Colours, Picture, Triangles, Vertices, surfaces_of


def depth_sort(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int, int]]:
    """Paint from back to front in an order in which nothing hides wrongly.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (y, x_left, x_right, surface).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-6.
    """
    # Sort the surfaces by their greatest depth, the farthest last
    surfaces = surfaces_of(vertices, faces)
    pieces = [whole(surfaces, number) for number in farthest_first(surfaces)]
    boxes = [piece.box for piece in pieces]
    order = [Waiting(boxes[k].z_far, k) for k in range(len(pieces) - 1, -1, -1)]
    marked = [waiting.piece for waiting in order[:0]]

    while order:
        # Take the farthest piece as P
        p = order[-1].piece
        P, settled = pieces[p], True
        for place in range(len(order) - 2, -1, -1):
            # Compare the depths of P with those of the next piece, Q
            z_far, q = order[place]
            if z_far < P.box.z_near:
                continue
            # Test 1 (Foley 1, 2): their boxes do not overlap in x, or in y
            passed = boxes_apart(P.box, boxes[q])
            if passed:
                continue
            # Test 2 (Foley 3): P is wholly behind the plane of Q
            Q = pieces[q]
            passed = is_behind(surfaces, P, Q)
            if passed:
                continue
            # Test 3 (Foley 4): Q is wholly in front of the plane of P
            passed = is_in_front(surfaces, Q, P)
            if passed:
                continue
            # Test 4 (Foley 5): their projections do not overlap
            passed = projections_apart(P, Q)
            if passed:
                continue
            # Swap: Q goes to the end and is marked, unless it was marked already
            settled, split, plane = False, NONE, plane_of(surfaces, Q.number)
            if q in marked or not pass_exchanged(surfaces, P, Q):
                split, plane = cut_between(surfaces, pieces, p, q)
            if split == NONE:
                order.append(order.pop(place))
                marked.append(q)
                break
            # Split the one that the other's plane or edge cuts
            front, behind = split_in_two(pieces, boxes, plane, split)
            order.pop(place if split == q else len(order) - 1)
            put_by_depth(order, pieces, front)
            put_by_depth(order, pieces, behind)
            break
        if settled:
            # Paint P
            order.pop()
            yield from paint_piece(image, surfaces, P, colours)


ENTRY = Entry(
    function=depth_sort,
    topic="visibility",
    title="Depth sort",
    summary="Paints from back to front in an order that tests prove, and splits surfaces that have none.",
    parameters=SURFACES,
    arguments=surfaces_at_will,
    emits="spans",
    emitted_columns=("y", "x_left", "x_right", "surface"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-6; Foley, van Dam, Feiner and Hughes, "
    "Computer Graphics: Principles and Practice, section 15.5",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        ONE_PICTURE,
        Law(
            "It ends on every input: a piece is moved once, and no line cuts a piece twice.",
            "visibility/test_painters.py::test_the_depth_sort_ends_where_no_order_helps",
        ),
        Law(
            "Each surface paints each pixel that it covers once, and the farther one first.",
            "visibility/test_painters.py::test_each_surface_paints_its_pixels_once_and_the_farther_one_first",
        ),
    ),
    not_laws=(
        "Some order always paints correctly: three surfaces that overlap in a cycle have none.",
        "A surface that fails all tests must be split: usually it is enough to swap it with the other one.",
    ),
    works_in="object and image space",
    questions=(7,),
    labs=("Hidden surfaces: depth sort",),
    tie="In one plane the lower number is painted last, and stays",
    writes="image",
    marks=marks,
    counted={"swaps and splits": Counted("swap or split", ("Swap",)), "splits": Counted("split", ("Split",))},
    keeps={"pieces": Kept("piece", "len(faces) + 2 * counted['splits']")},
)
