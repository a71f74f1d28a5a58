"""What the depth sort shows of its blocks."""

from workbench.algorithms.entry import View
from workbench.algorithms.visibility.depth_tests import Waiting
from workbench.algorithms.visibility.pieces import Piece
from workbench.algorithms.visibility.surface_marks import piece_marks
from workbench.algorithms.visibility.surface_words import answer

COLUMNS = ("P", "Q", "test", "Foley's", "passed", "so")

_MARKS = "(*piece_marks(P, 'data2'), *piece_marks(pieces[q], 'accent'))"
_TABLES = {
    "Order, the next to be painted last": (
        "order_rows(order, pieces, marked)",
        ("surface", "cuts", "least z", "greatest z", "marked"),
    )
}


def order_rows(
    order: list[Waiting], pieces: list[Piece], marked: list[int]
) -> list[tuple[int, int, float, float, str]]:
    """The pieces that are not painted yet: surface, how often cut, depths, and whether it is marked."""
    rows = []
    for _z_far, k in order:
        box = pieces[k].box
        rows.append((pieces[k].number, len(pieces[k].cuts), box.z_near, box.z_far, answer(k in marked)))
    return rows


VIEW_FUNCTIONS = (answer, order_rows, piece_marks)


def _test_views(title: str, number: int, foley: str, holds: str, fails: str) -> tuple[View, View]:
    """The views of a test that P passes, or else leads to the next one."""
    block = f"Test {number} ({foley}): {title}"
    after = f"test {number + 1}" if number < 4 else "swap or split"
    options = f"({holds!r}, {fails!r})"

    def view(when: str, passed: str, so: str, sentence: str) -> View:
        return View(
            block=block,
            when=when,
            row=f"(P.number, pieces[q].number, '{number}', '{foley.removeprefix('Foley ')}', '{passed}', "
            f"'{so}')",
            tables=_TABLES,
            options=options,
            answer=repr(sentence),
            marks=_MARKS,
            sentence=f"P is of surface {{P.number}}, Q of {{pieces[q].number}}: {sentence}"
            + (", so P may be painted before Q." if passed == "yes" else "."),
        )

    return view("passed", "yes", "next Q", holds), view("True", "no", after, fails)


def _swap_view(when: str, so: str, sentence: str) -> View:
    return View(
        block="Swap: Q goes to the end and is marked, unless it was marked already",
        when=when,
        row=f"(P.number, Q.number, 'swap', '3\u2032, 4\u2032', answer(split == -1), {so!r})",
        tables=_TABLES,
        options="('swap', 'split')",
        answer=repr(so.split()[0]),
        marks=_MARKS,
        sentence=sentence,
    )


def _split_view(when: str, sentence: str) -> View:
    return View(
        block="Split the one that the other's plane or edge cuts",
        when=when,
        row="(P.number, Q.number, 'split', '', '', f'surface {pieces[split].number} in two')",
        tables=_TABLES,
        marks="(*piece_marks(pieces[front], 'data2'), *piece_marks(pieces[behind], 'data3'))",
        sentence=sentence,
    )


VIEWS = (
    View(
        block="Sort the surfaces by their greatest depth, the farthest last",
        tables=_TABLES,
        sentence="{len(order)} surfaces in order of their greatest depths, the farthest last.",
    ),
    View(
        block="Compare the depths of P with those of the next piece, Q",
        when="z_far < P.box.z_near",
        sentence="Q, of surface {pieces[q].number}, ends at z = {z_far}, before P, of surface "
        "{P.number}, begins: P may be painted before it.",
    ),
    *_test_views(
        "their boxes do not overlap in x, or in y",
        1,
        "Foley 1, 2",
        "their boxes do not overlap",
        "their boxes overlap",
    ),
    *_test_views(
        "P is wholly behind the plane of Q",
        2,
        "Foley 3",
        "P is wholly behind the plane of Q",
        "P is not wholly behind the plane of Q",
    ),
    *_test_views(
        "Q is wholly in front of the plane of P",
        3,
        "Foley 4",
        "Q is wholly in front of the plane of P",
        "Q is not wholly in front of the plane of P",
    ),
    *_test_views(
        "their projections do not overlap",
        4,
        "Foley 5",
        "their projections do not overlap",
        "their projections overlap",
    ),
    _swap_view(
        "split == -1",
        "swap",
        "With P, of surface {P.number}, and Q, of {Q.number}, exchanged a test is passed: Q goes to the end, "
        "to be painted first, and is marked.",
    ),
    _swap_view(
        "q in marked",
        "split",
        "Q, of surface {Q.number}, bears a mark: moved before, it would be for ever. P or Q is split.",
    ),
    _swap_view(
        "True",
        "split",
        "Exchanged, P, of surface {P.number}, and Q, of {Q.number}, pass no test either: neither may be "
        "painted before the other, so one is split.",
    ),
    _split_view(
        "plane.number >= 0",
        "The plane of surface {plane.number} splits surface {pieces[split].number} in two; both go back into "
        "the order by their greatest depths.",
    ),
    _split_view(
        "True",
        "No plane cuts either, as in a cycle of several: the edge of the other, seen from the eye, splits "
        "surface {pieces[split].number} in two.",
    ),
    View(
        block="Paint P",
        row="(P.number, '', 'paint', '', '', 'next P')",
        tables=_TABLES,
        marks="piece_marks(P, 'data2')",
        sentence="P, of surface {P.number}, passed a test with each of the others: it is painted.",
    ),
)
