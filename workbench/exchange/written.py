"""The table of everything that can be written without a window: kind, suffix, title, encoder.

What is drawn by Qt adds its rows to these in ``panels``; a new kind of file is one more row.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from workbench.document.storage.files import pieces_of
from workbench.exchange import meshes, tables
from workbench.exchange.frames import animation, each_png, one_png
from workbench.exchange.pictures import png
from workbench.exchange.point_lists import write_points
from workbench.exchange.svg_writing import Exported
from workbench.exchange.tables import Table
from workbench.exchange.wireframe_svg import wireframe_svg
from workbench.exchange.writing import Encode, Progress, Put, Row, of_kind, whole

_TOLD_EVERY = 64


def _picture(content: Sequence[Any]) -> bytes:
    return png(*content)


def _drawing(content: Exported) -> bytes:
    return content.text.encode()


class _ToldRows(Sequence[tuple[Any, ...]]):
    """The rows of a table that tell, while they are gone through, how many are done."""

    def __init__(self, rows: Sequence[tuple[Any, ...]], told: Progress) -> None:
        self._rows, self._told = rows, told

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, number: Any) -> Any:
        return self._rows[number]

    def __iter__(self) -> Iterator[tuple[Any, ...]]:
        for number, row in enumerate(self._rows):
            if number % _TOLD_EVERY == 0:
                self._told(number, len(self._rows))
            yield row


def _table(make: Callable[[Table], str]) -> Encode:
    def encode(table: Table, put: Put, told: Progress) -> None:
        put(make(replace(table, rows=_ToldRows(table.rows, told))).encode())

    return encode


def _text(make: Callable[[Any], str]) -> Encode:
    return whole(lambda content: make(content).encode())


def _mesh(make: Callable[..., bytes]) -> Encode:
    return whole(lambda content: make(*content))


# kind         content
# document     Stored
# picture      (image, cell), as ``pictures.png`` takes them
# drawing      svg_writing.Exported
# table        tables.Table
# points       (n, 2) numbers
# mesh         (vertices, faces), faces as ``Faces.of`` takes them
# wireframe    (segments, window, size), as ``wireframe_svg`` takes them
# step, run    frames.Frames
ROWS: tuple[Row, ...] = (
    Row("document", ".gwb", "Graphics Workbench", whole(pieces_of)),
    Row("picture", ".png", "PNG", whole(_picture)),
    Row("drawing", ".svg", "SVG", whole(_drawing)),
    Row("table", ".csv", "CSV", _table(tables.to_csv)),
    Row("table", ".json", "JSON", _table(tables.to_json)),
    Row("table", ".html", "HTML", _table(tables.to_html)),
    Row("points", ".csv", "CSV", _text(write_points)),
    Row("points", ".txt", "TXT", _text(lambda points: write_points(points, "\t"))),
    Row("mesh", ".obj", "OBJ", _mesh(meshes.obj)),
    Row("mesh", ".ply", "PLY", _mesh(meshes.ply)),
    Row("mesh", ".stl", "STL", _mesh(meshes.stl)),
    Row("wireframe", ".svg", "SVG", whole(lambda content: wireframe_svg(*content))),
    Row("step", ".png", "PNG", one_png),
    Row("run", ".png", "PNG", each_png, numbered=True),
    Row("run", ".gif", "GIF", animation),
)


def rows(kind: str) -> tuple[Row, ...]:
    """The ways in which one kind of content is written without a window."""
    return of_kind(ROWS, kind)
