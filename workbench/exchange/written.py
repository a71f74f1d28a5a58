"""The table of everything that can be written without a window: kind, suffix, title, encoder.

What is drawn by Qt adds its rows to these in ``panels``; a new kind of file is one more row.
"""

from collections.abc import Sequence
from typing import Any

from workbench.document import DocumentError, Stored
from workbench.document.files import decode, encode
from workbench.exchange import meshes, tables
from workbench.exchange.frames import animation, each_png, one_png
from workbench.exchange.pictures import png
from workbench.exchange.point_lists import write_points
from workbench.exchange.svg_writing import Exported
from workbench.exchange.writing import Row, of_kind, whole
from workbench.language import _


def _document(stored: Stored) -> bytes:
    data = encode(stored)
    if decode(data) != stored:
        raise DocumentError("", _("What was written reads back differently, so nothing was saved."))
    return data


def _picture(content: Sequence[Any]) -> bytes:
    return png(*content)


def _drawing(content: Exported) -> bytes:
    return content.text.encode()


def _text(make: Any) -> Any:
    return whole(lambda content: make(content).encode())


def _mesh(make: Any) -> Any:
    return whole(lambda content: make(*content))


# kind         content
# document     Stored
# picture      (image, cell), as ``pictures.png`` takes them
# drawing      svg_writing.Exported
# table        tables.Table
# points       (n, 2) numbers
# mesh         (vertices, faces)
# step, run    frames.Frames
ROWS: tuple[Row, ...] = (
    Row("document", ".gwb", "Graphics Workbench", whole(_document), verify=decode),
    Row("picture", ".png", "PNG", whole(_picture)),
    Row("drawing", ".svg", "SVG", whole(_drawing)),
    Row("table", ".csv", "CSV", _text(tables.to_csv)),
    Row("table", ".json", "JSON", _text(tables.to_json)),
    Row("table", ".html", "HTML", _text(tables.to_html)),
    Row("points", ".csv", "CSV", _text(write_points)),
    Row("points", ".txt", "TXT", _text(lambda points: write_points(points, "\t"))),
    Row("mesh", ".obj", "OBJ", _mesh(meshes.obj)),
    Row("mesh", ".ply", "PLY", _mesh(meshes.ply)),
    Row("mesh", ".stl", "STL", _mesh(meshes.stl)),
    Row("step", ".png", "PNG", one_png),
    Row("run", ".png", "PNG", each_png, numbered=True),
    Row("run", ".gif", "GIF", animation),
)


def rows(kind: str) -> tuple[Row, ...]:
    """The ways in which one kind of content is written without a window."""
    return of_kind(ROWS, kind)
