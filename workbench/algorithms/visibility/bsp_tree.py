"""The BSP tree: planes divide space in two, and each half again; a walk gives the order to paint in.

pieces      surfaces, and the parts that planes have split them into
nodes       the tree: of each node the pieces in its plane, and the nodes in front of the plane and behind it
work        halves of space that are still to be divided
number      the surface whose plane divides
front, back, same   the pieces in front of the plane, behind it, and in it
walk        nodes on the way, and whether all beyond their planes is painted
"""

from collections.abc import Iterator

from workbench.algorithms.counted import Counted, Kept
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.bsp_views import COLUMNS, VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.visibility.piece_painting import paint_piece
from workbench.algorithms.visibility.pieces import (
    add_piece,
    part_of,
    plane_of,
    side_of,
    whole,
)
from workbench.algorithms.visibility.surface_marks import marks
from workbench.algorithms.visibility.surface_scene import ONE_PICTURE, SURFACES, surfaces_at_will
from workbench.algorithms.visibility.surfaces import (
    Colours,
    Picture,
    Triangles,
    Vertices,
    in_view,
    surfaces_of,
)
from workbench.algorithms.visibility.tree import NONE, Half, Node, add_half, dividing, put_in_plane


def bsp_tree(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int, int]]:
    """Divide space by the planes of the surfaces; paint from back to front.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (y, x_left, x_right, surface).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-7.
    """
    # Begin with one node for all surfaces
    surfaces = surfaces_of(vertices, faces)
    pieces = [whole(surfaces, number) for number in in_view(surfaces)]
    nodes = [Node(NONE, [0], NONE, NONE) for _none in pieces[:0]]
    work = [Half(NONE, [0]) for _none in pieces[:0]]
    add_half(nodes, work, pieces, list(range(len(pieces))))

    while work:
        # Choose the piece whose plane divides
        here, members = work.pop()
        number = pieces[dividing(pieces, surfaces, members)].number
        plane = plane_of(surfaces, number)
        same, front, back = members[:0], members[:0], members[:0]
        for member in members:
            # Find the side of the plane that the piece is on
            piece = pieces[member]
            side = side_of(plane, piece)
            if side == 0:
                put_in_plane(pieces, same, member)
            elif side == 1:
                front.append(member)
            elif side == -1:
                back.append(member)
            else:
                # Split the piece
                pieces[member] = part_of(plane, piece, 1)
                front.append(member)
                back.append(add_piece(pieces, part_of(plane, piece, -1)))
        # Attach both halves to the node
        in_front = add_half(nodes, work, pieces, front)
        behind = add_half(nodes, work, pieces, back)
        nodes[here] = Node(number, same, in_front, behind)

    walk = [(0, False) for _root in nodes[:1]]
    while walk:
        # Go beyond the plane first, away from the eye
        here, beyond = walk.pop()
        node = nodes[here]
        far, near = node.front, node.back
        if surfaces[node.surface].C < 0.0:
            far, near = near, far
        if not beyond:
            walk.append((here, True))
            if far != NONE:
                walk.append((far, False))
            continue
        # Paint what is in the plane, then go to the eye's side
        for k in node.pieces:
            yield from paint_piece(image, surfaces, pieces[k], colours)
        if near != NONE:
            walk.append((near, False))


ENTRY = Entry(
    function=bsp_tree,
    topic="visibility",
    title="BSP tree",
    summary="Divides space by the planes of the surfaces; for any eye, a walk through the tree "
    "goes from back to front.",
    parameters=SURFACES,
    arguments=surfaces_at_will,
    emits="spans",
    emitted_columns=("y", "x_left", "x_right", "surface"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-7; Fuchs, Kedem and Naylor, On Visible "
    "Surface Generation by A Priori Tree Structures, 1980",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        ONE_PICTURE,
        Law(
            "Each surface paints each pixel that it covers once, and the farther one first.",
            "visibility/test_painters.py::test_each_surface_paints_its_pixels_once_and_the_farther_one_first",
        ),
    ),
    not_laws=(
        "The tree must be built again when the eye moves: it holds for every eye, and only the walk changes.",
        "The order in which planes are taken does not matter: it changes how many surfaces are split.",
    ),
    works_in="object and image space",
    questions=(7,),
    labs=("Hidden surfaces: BSP tree",),
    tie="In one plane the lower number is painted last, and stays",
    writes="image",
    marks=marks,
    stack="walk",
    counted={"splits": Counted("split", ("Split the piece",))},
    keeps={"pieces": Kept("piece", "len(faces) + counted['splits']")},
)
