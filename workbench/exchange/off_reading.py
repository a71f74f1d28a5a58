"""OFF, the Object File Format of Geomview, also with colours, normals or places in a texture (COFF ...)."""

import re

import numpy as np

from workbench.document.storage.content import Progress
from workbench.exchange.mesh_limits import Refuse, of_faces, of_vertices
from workbench.exchange.mesh_reading import Raw
from workbench.exchange.mesh_rows import rows_of, whole_numbers
from workbench.geometry.meshes import Faces
from workbench.language import _

_HEAD = re.compile(rb"(ST)?(C)?(N)?OFF\b", re.ASCII)
_LINE = re.compile(rb"\S[^\n]*")
_COMMENT = re.compile(rb"#[^\n]*")


def read_off(content: bytes, progress: Progress, refuse: Refuse) -> Raw:
    """What an OFF says. Raises: ValueError where it is none."""
    text = content.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    text = _COMMENT.sub(b"", text).replace(b"\t", b" ").lstrip()
    head = _HEAD.match(text)
    begin = head.end() if head else 0
    first_line = _LINE.search(text, begin)
    counts = rows_of([first_line.group()] if first_line else [])
    announced = len(counts.sizes) == 1 and counts.sizes[0] in (2, 3) and not (counts.numbers < 0).any()
    if not (head or text.strip().count(b"\n")) or not announced:
        raise ValueError(
            _("This is not an OFF file: it does not begin with the numbers of vertices and faces.")
        )
    if not (np.abs(counts.numbers) < 1e12).all():
        raise ValueError(_("The numbers of vertices and faces at the beginning of the file are too large."))
    vertex_count, face_count = (int(number) for number in counts.numbers[:2])
    refuse(vertex_count, face_count)
    lines = [line for line in text[begin:].split(b"\n") if line and not line.isspace()]
    if len(lines) < 1 + vertex_count + face_count:
        sentence = _("The file announces {vertices} and {faces}, but ends before that; get it again.")
        raise ValueError(sentence.format(vertices=of_vertices(vertex_count), faces=of_faces(face_count)))
    progress(0.2)
    vertex_rows = rows_of(lines[1 : 1 + vertex_count])
    points = np.full((vertex_count, 3), np.nan)
    whole = vertex_rows.sizes >= 3
    starts = vertex_rows.starts[whole]
    points[vertex_rows.lines[whole]] = vertex_rows.numbers[starts[:, None] + np.arange(3)]
    progress(0.5)
    face_rows = rows_of(lines[1 + vertex_count : 1 + vertex_count + face_count])
    first = np.full(len(face_rows.sizes), -1.0)
    some = face_rows.sizes > 0
    first[some] = face_rows.numbers[face_rows.starts[some]]
    good = (first >= 0) & (first < face_rows.sizes)
    sizes = first[good].astype(np.int64)
    ends = np.cumsum(sizes)
    within = np.arange(int(sizes.sum())) - np.repeat(ends - sizes, sizes)
    corners = face_rows.numbers[np.repeat(face_rows.starts[good] + 1, sizes) + within]
    progress(1.0)
    unread = vertex_count - int(whole.sum()) + face_count - int(good.sum())
    coloured = bool(head and head.group(2)) and vertex_count > 0
    return Raw(points, Faces(whole_numbers(corners, -1), ends), unread, coloured)
