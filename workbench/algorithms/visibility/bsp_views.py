"""What the BSP tree shows of its blocks."""

from workbench.algorithms.entry import View
from workbench.algorithms.visibility.pieces import Piece
from workbench.algorithms.visibility.surface_marks import piece_marks, surface_mark
from workbench.algorithms.visibility.surface_words import listed
from workbench.algorithms.visibility.tree import NONE, Node

COLUMNS = ("node", "plane of", "surface", "is", "pieces")

_SIDE = "Find the side of the plane that the piece is on"
_SIDES = "('in front', 'behind', 'in the plane', 'cut through')"
_TREE = {"Tree": ("tree_rows(nodes, pieces)", ("node", "plane of", "in its plane", "in front", "behind"))}
_MARKS = "(surface_mark(surfaces[number], 'data2'), *piece_marks(piece))"


def tree_rows(nodes: list[Node], pieces: list[Piece]) -> list[tuple[int, str, str, str, str]]:
    """The tree: each node, whose plane divides it, the surfaces in that plane, the nodes on both sides."""
    return [
        (
            k,
            _number(node.surface),
            listed([pieces[piece].number for piece in node.pieces]),
            _number(node.front),
            _number(node.back),
        )
        for k, node in enumerate(nodes)
    ]


def _number(node: int) -> str:
    return "–" if node == NONE else str(node)


def numbers_of(pieces: list[Piece], members: list[int]) -> str:
    """The surfaces that some pieces are of."""
    return listed([pieces[member].number for member in members])


VIEW_FUNCTIONS = (listed, numbers_of, piece_marks, surface_mark, tree_rows)


def _side_view(when: str, name: str, sentence: str) -> View:
    return View(
        block=_SIDE,
        when=when,
        row=f"(here, number, piece.number, {name!r}, len(pieces))",
        tables=_TREE,
        options=_SIDES,
        answer=repr(name),
        marks=_MARKS,
        sentence=sentence,
    )


def _walk_view(when: str, sentence: str) -> View:
    return View(
        block="Go beyond the plane first, away from the eye", when=when, tables=_TREE, sentence=sentence
    )


VIEWS = (
    View(
        block="Begin with one node for all surfaces",
        sentence="{len(pieces)} surfaces, none of them divided yet.",
    ),
    View(
        block="Choose the piece whose plane divides",
        tables=_TREE,
        marks="(surface_mark(surfaces[number], 'data2'),)",
        sentence="Node {here}: the plane of surface {number} divides {len(members)} pieces.",
    ),
    _side_view(
        "side == 0", "in the plane", "Surface {piece.number} lies in the plane of {number}: it stays here."
    ),
    _side_view("side == 1", "in front", "Surface {piece.number} is in front of the plane of {number}."),
    _side_view("side == -1", "behind", "Surface {piece.number} is behind the plane of {number}."),
    _side_view(
        "True",
        "cut through",
        "The plane of surface {number} cuts surface {piece.number}: one part is in front, one behind.",
    ),
    View(
        block="Attach both halves to the node",
        tables=_TREE,
        sentence="Node {here} is done: in front of its plane {numbers_of(pieces, front)}, behind it "
        "{numbers_of(pieces, back)}.",
    ),
    _walk_view(
        "beyond",
        "All beyond the plane of surface {node.surface} is painted.",
    ),
    _walk_view(
        "surfaces[node.surface].C < 0.0",
        "The eye is in front of the plane of surface {node.surface}: what is behind it comes first.",
    ),
    _walk_view(
        "True",
        "The eye is behind the plane of surface {node.surface}: what is in front of it comes first.",
    ),
    View(
        block="Paint what is in the plane, then go to the eye's side",
        row="(here, node.surface, numbers_of(pieces, node.pieces), 'painted', len(pieces))",
        tables=_TREE,
        marks="tuple(mark for k in node.pieces for mark in piece_marks(pieces[k]))",
        sentence="In the plane of node {here}, surface {numbers_of(pieces, node.pieces)} is painted.",
    ),
)
