"""OFF, the Object File Format of Geomview, also with colours, normals or places in a texture (COFF ...)."""

import re

import numpy as np

from workbench.document.storage.content import Progress
from workbench.exchange.mesh_reading import Raw, refuse_counts
from workbench.exchange.mesh_rows import rows_of, whole_numbers
from workbench.geometry.meshes import Faces
from workbench.language import _

_HEAD = re.compile(rb"(ST)?(C)?(N)?OFF\b", re.ASCII)
_COMMENT = re.compile(rb"#[^\n]*")


def read_off(content: bytes, progress: Progress) -> Raw:
    """What an OFF says. Raises: ValueError where it is none."""
    text = content.removeprefix(b"\xef\xbb\xbf").replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    text = _COMMENT.sub(b"", text).replace(b"\t", b" ").lstrip()
    head = _HEAD.match(text)
    lines = [line for line in text[head.end() if head else 0 :].split(b"\n") if line and not line.isspace()]
    counts = rows_of(lines[:1])
    if not (head or len(lines) > 1) or len(counts.sizes) != 1 or counts.sizes[0] not in (2, 3):
        raise ValueError(
            _("This is not an OFF file: it does not begin with the numbers of vertices and faces.")
        )
    if not (np.abs(counts.numbers) < 1e12).all():
        raise ValueError(_("The numbers of vertices and faces at the beginning of the file are too large."))
    vertex_count, face_count = (int(number) for number in counts.numbers[:2])
    refuse_counts(vertex_count, face_count)
    if vertex_count < 0 or face_count < 0 or len(lines) < 1 + vertex_count + face_count:
        sentence = _("The file announces {vertices:,} vertices and {faces:,} faces, but ends before that.")
        raise ValueError(sentence.format(vertices=vertex_count, faces=face_count))
    progress(0.2)
    of_vertices = rows_of(lines[1 : 1 + vertex_count])
    points = np.full((vertex_count, 3), np.nan)
    whole = of_vertices.sizes >= 3
    starts = of_vertices.starts[whole]
    points[of_vertices.lines[whole]] = of_vertices.numbers[starts[:, None] + np.arange(3)]
    progress(0.5)
    of_faces = rows_of(lines[1 + vertex_count : 1 + vertex_count + face_count])
    first = np.full(len(of_faces.sizes), -1.0)
    some = of_faces.sizes > 0
    first[some] = of_faces.numbers[of_faces.starts[some]]
    good = (first >= 0) & (first < of_faces.sizes)
    sizes = first[good].astype(np.int64)
    ends = np.cumsum(sizes)
    within = np.arange(int(sizes.sum())) - np.repeat(ends - sizes, sizes)
    corners = of_faces.numbers[np.repeat(of_faces.starts[good] + 1, sizes) + within]
    progress(1.0)
    unread = vertex_count - int(whole.sum()) + face_count - int(good.sum())
    coloured = bool(head and head.group(2)) and vertex_count > 0
    return Raw(points, Faces(whole_numbers(corners, -1), ends), unread, coloured)
