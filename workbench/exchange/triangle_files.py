"""STL and GLB, read by trimesh: triangles, with the vertices that STL repeats joined again."""

import io
from collections.abc import Callable

import numpy as np

from workbench.document.storage.content import Progress
from workbench.exchange.mesh_reading import Raw
from workbench.geometry.meshes import Faces
from workbench.language import _


def reader(suffix: str) -> Callable[[bytes, Progress], Raw]:
    """What reads files whose names end in ``suffix``; it raises ValueError."""

    def read(content: bytes, progress: Progress) -> Raw:
        progress(0.1)
        try:
            vertices, faces = _read(content, suffix)
        except MemoryError:
            raise
        except Exception as error:  # whatever a damaged file makes trimesh stumble over
            sentence = _("The file is not {kind}, or it is damaged; choose another file.")
            raise ValueError(sentence.format(kind={".stl": "an STL", ".glb": "a GLB"}[suffix])) from error
        progress(0.9)
        return Raw(vertices, Faces.of(faces))

    return read


def _read(content: bytes, suffix: str) -> tuple[np.ndarray, np.ndarray]:
    import trimesh

    scene = trimesh.load_scene(io.BytesIO(content), file_type=suffix[1:])
    mesh = scene.to_mesh()
    return np.asarray(mesh.vertices, np.float64), np.asarray(mesh.faces, np.int64)
