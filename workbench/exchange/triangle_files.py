"""STL and GLB, read by trimesh: triangles, with the vertices that STL repeats joined again.

Triangles of an STL with coordinates that are no numbers are kept as such, to be counted.
"""

import io
from collections.abc import Callable

import numpy as np

from workbench.document.storage.content import Progress
from workbench.exchange.mesh_limits import Refuse
from workbench.exchange.mesh_reading import Raw
from workbench.geometry.meshes import Array, Faces, Index
from workbench.language import _

_STL_HEAD, _STL_ROW = 84, 50  # bytes


def reader(suffix: str) -> Callable[[bytes, Progress, Refuse], Raw]:
    """What reads files whose names end in ``suffix``; it raises ValueError."""

    def read(content: bytes, progress: Progress, refuse: Refuse) -> Raw:
        if suffix == ".stl":
            refuse(None, _announced(content))
        progress(0.1)
        try:
            with np.errstate(invalid="ignore"):  # of coordinates that are no numbers
                vertices, faces = _read(content, suffix)
        except MemoryError:
            raise
        except Exception as error:  # whatever a damaged file makes trimesh stumble over
            sentence = _("The file is not {kind}, or it is damaged; choose another file.")
            raise ValueError(sentence.format(kind={".stl": "an STL", ".glb": "a GLB"}[suffix])) from error
        progress(0.9)
        return Raw(vertices, Faces.of(faces))

    return read


def _announced(content: bytes) -> int:
    """How many triangles an STL has, by its head if that is true, else by its lines."""
    count = int.from_bytes(content[_STL_HEAD - 4 : _STL_HEAD], "little")
    if len(content) == _STL_HEAD + _STL_ROW * count:
        return count
    return content.count(b"endfacet") + content.count(b"ENDFACET")


def _read(content: bytes, suffix: str) -> tuple[Array, Index]:
    import trimesh

    if suffix == ".stl":
        return _read_stl(content)
    mesh = trimesh.load_scene(io.BytesIO(content), file_type=suffix[1:]).to_mesh()
    return np.asarray(mesh.vertices, np.float64), np.asarray(mesh.faces, np.int64)


def _read_stl(content: bytes) -> tuple[Array, Index]:
    import trimesh
    from trimesh.exchange.stl import load_stl

    loaded = load_stl(io.BytesIO(content))
    solids = loaded["geometry"].values() if "geometry" in loaded else [loaded]
    vertices, faces, count, lost = [np.zeros((0, 3))], [np.zeros((0, 3), np.int64)], 0, 0
    for solid in solids:
        mesh = trimesh.Trimesh(solid["vertices"], solid["faces"])
        lost += len(solid["faces"]) - len(mesh.faces)
        vertices.append(np.asarray(mesh.vertices, np.float64))
        faces.append(np.asarray(mesh.faces, np.int64).reshape(-1, 3) + count)
        count += len(vertices[-1])
    if lost:
        vertices.append(np.full((1, 3), np.nan))
        faces.append(np.full((lost, 3), count))
    return np.concatenate(vertices), np.concatenate(faces)
