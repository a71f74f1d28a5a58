"""Wavefront OBJ, as programs write it: faces v, v/t, v//n or v/t/n, counted from 1, or backwards from -1.

Groups, objects, materials, textures and normals are passed over. A vertex that cannot be read keeps its
number, so that the others keep theirs.
"""

import re
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from workbench.document.storage.content import Progress
from workbench.exchange.mesh_limits import Refuse
from workbench.exchange.mesh_reading import Raw
from workbench.exchange.mesh_rows import rows_of, whole_numbers
from workbench.geometry.meshes import Faces

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_BLOCK = 2**22
_BEYOND_VERTEX = re.compile(rb"/\S*")
_COMMENT = re.compile(rb"#[^\n]*")


def read_obj(content: bytes, progress: Progress, refuse: Refuse) -> Raw:
    """What an OBJ says. Raises: ValueError, by ``refuse``."""
    refuse(content.count(b"\nv "), content.count(b"\nf "))  # at once, but for what few write otherwise
    vertices: list[Array] = []
    corners: list[Index] = []
    sizes: list[Index] = []
    unread = before = faces = 0
    coloured = False
    for lines, share in _blocks(content):
        of_vertices = [line[2:] for line in lines if line[:2] == b"v "]
        of_faces = [number for number, line in enumerate(lines) if line[:2] == b"f "]
        if of_vertices:
            points, bad, more = _vertices(of_vertices)
            unread, coloured = unread + bad, coloured or more
            vertices.append(points)
        if of_faces:
            text = [lines[number][2:] for number in of_faces]
            here, some, bad = _faces(lines, text, of_faces, before)
            corners.append(here)
            sizes.append(some)
            unread, faces = unread + bad, faces + len(some)
        before += len(of_vertices)
        refuse(before, faces)
        progress(share)
    every = np.concatenate(corners or [np.zeros(0, np.int64)])
    ends = np.cumsum(np.concatenate(sizes or [np.zeros(0, np.int64)]))
    return Raw(np.concatenate(vertices or [np.zeros((0, 3))]), Faces(every, ends), unread, coloured)


def _blocks(content: bytes) -> Iterator[tuple[list[bytes], float]]:
    """The lines in lists, blanks before them and comments removed, and what share of all is then done."""
    begin = 0
    while begin < len(content):
        end = content.find(b"\n", begin + _BLOCK)
        while end > 0 and content[end - 2 : end].rstrip(b"\r").endswith(b"\\"):
            end = content.find(b"\n", end + 1)  # a line that goes on is not cut
        end = len(content) if end < 0 else end + 1
        text = content[begin:end].replace(b"\r\n", b"\n").replace(b"\r", b"\n").replace(b"\t", b" ")
        if b"\\\n" in text:
            text = text.replace(b"\\\n", b" ")
        if b"#" in text:
            text = _COMMENT.sub(b"", text)
        lines = text.split(b"\n")
        if text[:1] == b" " or b"\n " in text:
            lines = [line.lstrip() for line in lines]
        yield lines, end / len(content)
        begin = end


def _vertices(lines: list[bytes]) -> tuple[Array, int, bool]:
    """The vertices (n, 3), NaN where a line cannot be read; how many cannot, and whether one has a colour."""
    rows = rows_of(lines)
    points = np.full((len(lines), 3), np.nan)
    whole = rows.sizes >= 3
    if whole.all():
        points[rows.lines] = rows.columns(0, 3)
    else:
        starts = rows.starts[whole]
        points[rows.lines[whole]] = rows.numbers[starts[:, None] + np.arange(3)]
    return points, len(lines) - int(whole.sum()), bool((rows.sizes >= 6).any())


def _faces(lines: list[bytes], text: list[bytes], places: list[int], before: int) -> tuple[Index, Index, int]:
    """The corners of faces, from 0, how many each has, and how many lines cannot be read.

    ``places`` are the numbers of their lines; ``before`` vertices stand above the first line.
    """
    joined = b"\n".join(text)
    if b"/" in joined:
        text = _BEYOND_VERTEX.sub(b"", joined).split(b"\n")
    rows = rows_of(text)
    bad = len(text) - len(rows.lines)
    corners = whole_numbers(rows.numbers, 0)
    backwards = corners < 0
    found = corners - 1
    if backwards.any():
        above = before + np.cumsum([line[:2] == b"v " for line in lines])
        on_line = np.repeat(above[np.array(places)[rows.lines]], rows.sizes)
        found = np.where(backwards, corners + on_line, found)
    return found, rows.sizes, bad
