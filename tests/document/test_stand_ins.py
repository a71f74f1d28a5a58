"""Algorithms that a file names and this version lacks: kept, served by others, and told of."""

import json
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from tests.document.views import seen_through
from workbench.document import DocumentError
from workbench.document.edits import set_clipper
from workbench.document.model import LINE_CLIPPERS, POLYGON_CLIPPERS, Document, Rectangle
from workbench.document.samples.figures import document_of, line, polygon
from workbench.document.stand_ins import stand_ins
from workbench.document.storage.files import Stored, decode, encode
from workbench.rendering import frame_buffer
from workbench.rendering.clipping import clipper_of


def of_tomorrow() -> tuple[Document, Document]:
    """A clipped line and a polygon, and the same as a newer version has written them."""
    figures = [line((-5, 3), (60, 40)), line((2, 2), (9, 4)), polygon([[(-4, 4), (30, 9), (70, 50)]], 2, "")]
    document = document_of("Clipped", 40, 30, figures)
    sheet = seen_through(document.sheets[0], clip_world=Rectangle(5.0, 5.0, 25.0, 20.0))
    document = replace(document, sheets=(sheet,))
    lines = [replace(figure, algorithm="line_of_tomorrow") for figure in sheet.figures[:2]]
    newer = replace(
        sheet,
        figures=(*lines, sheet.figures[2]),
        line_clipper="clip_lines_tomorrow",
        polygon_clipper="clip_areas_tomorrow",
    )
    return document, replace(document, sheets=(newer,))


def test_they_are_kept_and_the_first_of_their_kind_serves() -> None:
    plain, newer = of_tomorrow()
    read = decode(encode(Stored(newer))).document
    assert read == newer
    (sheet,) = read.sheets
    assert np.array_equal(frame_buffer(sheet), frame_buffer(plain.sheets[0]))
    assert [clipper_of(sheet, figure) for figure in sheet.figures] == [
        LINE_CLIPPERS[0],
        LINE_CLIPPERS[0],
        POLYGON_CLIPPERS[0],
    ]


def test_what_serves_is_told_once_for_each_of_them() -> None:
    plain, newer = of_tomorrow()
    assert stand_ins(plain.sheets) == []
    assert stand_ins(newer.sheets) == [
        "2 figures ask for line_of_tomorrow, which this version lacks; Bresenham's line draws them, and the "
        "file keeps the name.",
        "A sheet asks for clip_lines_tomorrow to clip with, which this version lacks; Cohen-Sutherland "
        "clips instead, and the file keeps the name.",
        "A sheet asks for clip_areas_tomorrow to clip with, which this version lacks; Sutherland-Hodgman "
        "clips instead, and the file keeps the name.",
    ]
    many = [line((0, 0), (k, 9), algorithm=f"line_{k}") for k in range(40)]
    assert stand_ins(document_of("Many", 9, 9, many).sheets)[-1] == "And 36 more like these."


def test_what_is_compared_is_kept_too() -> None:
    written: dict[str, Any] = json.loads(encode(Stored(of_tomorrow()[0])))
    written["session"]["compare"] = "other_line"
    stored = decode(json.dumps(written).encode())
    assert stored.session.compare == "other_line"
    assert decode(encode(stored)) == stored


@pytest.mark.parametrize("slug", ["clip_of_tomorrow", "bresenham_line", "sutherland_hodgman"])
def test_none_of_them_is_ever_chosen(slug: str) -> None:
    document = of_tomorrow()[0]
    if slug in POLYGON_CLIPPERS:
        chosen = set_clipper("s1", slug)(document).sheets[0]
        assert (chosen.line_clipper, chosen.polygon_clipper) == (LINE_CLIPPERS[0], slug)
    else:
        with pytest.raises(DocumentError, match=r"line_clipper is .*, which cannot clip lines"):
            set_clipper("s1", slug)(document)


def test_a_clipper_takes_the_place_of_the_one_of_the_same_figures() -> None:
    (sheet,) = set_clipper("s1", LINE_CLIPPERS[1])(of_tomorrow()[0]).sheets
    assert (sheet.line_clipper, sheet.polygon_clipper) == (LINE_CLIPPERS[1], POLYGON_CLIPPERS[0])
