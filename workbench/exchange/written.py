"""The table of everything that can be written without a window: kind, suffix, title, encoder.

What is drawn by Qt adds its formats to these in ``panels``; a new kind of file is one more format.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from workbench.document.storage.files import pieces_of
from workbench.exchange import meshes, tables
from workbench.exchange.frames import animation, each_png, one_png
from workbench.exchange.moving_sheets import contact_sheet
from workbench.exchange.pictures import png
from workbench.exchange.point_lists import write_points
from workbench.exchange.svg_writing import Exported
from workbench.exchange.tables import Table
from workbench.exchange.wireframe_svg import wireframe_svg
from workbench.exchange.writing import Encode, FileFormat, Progress, Put, of_kind, whole

if TYPE_CHECKING:
    from workbench.exchange.diagrams import Derivation

_TOLD_EVERY = 64


def _picture(content: Sequence[Any]) -> bytes:
    return png(*content)


def _drawing(content: Exported) -> bytes:
    return content.text.encode()


def _derivation(content: Derivation) -> bytes:
    from workbench.exchange.diagram_svg import write_diagram

    return write_diagram(content).encode()


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
# animation    moving_sheets.MovingSheet, and the same as one picture of many: contacts
# derivation   diagrams.Derivation
FORMATS: tuple[FileFormat, ...] = (
    FileFormat("document", ".gwb", "Graphics Workbench", whole(pieces_of)),
    FileFormat("picture", ".png", "PNG", whole(_picture)),
    FileFormat("drawing", ".svg", "SVG", whole(_drawing)),
    FileFormat("table", ".csv", "CSV", _table(tables.to_csv)),
    FileFormat("table", ".json", "JSON", _table(tables.to_json)),
    FileFormat("table", ".html", "HTML", _table(tables.to_html)),
    FileFormat("points", ".csv", "CSV", _text(write_points)),
    FileFormat("points", ".txt", "TXT", _text(lambda points: write_points(points, "\t"))),
    FileFormat("mesh", ".obj", "OBJ", _mesh(meshes.obj)),
    FileFormat("mesh", ".ply", "PLY", _mesh(meshes.ply)),
    FileFormat("mesh", ".stl", "STL", _mesh(meshes.stl)),
    FileFormat("wireframe", ".svg", "SVG", whole(lambda content: wireframe_svg(*content))),
    FileFormat("step", ".png", "PNG", one_png),
    FileFormat("run", ".png", "PNG", each_png, numbered=True),
    FileFormat("run", ".gif", "GIF", animation),
    FileFormat("animation", ".gif", "GIF", animation),
    FileFormat("animation", ".png", "PNG", each_png, numbered=True),
    FileFormat("contacts", ".png", "PNG", contact_sheet),
    FileFormat("derivation", ".svg", "SVG", whole(_derivation)),
)


def formats(kind: str) -> tuple[FileFormat, ...]:
    """The ways in which one kind of content is written without a window."""
    return of_kind(FORMATS, kind)
