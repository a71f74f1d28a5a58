"""Meshes that are too large are refused by the heads of their files, in a sentence that names the limit."""

import tracemalloc
from pathlib import Path

import numpy as np
import pytest

from workbench.algorithms import solids
from workbench.document.errors import DocumentError
from workbench.document.scene import meshes as kept_meshes
from workbench.document.scene.meshes import blob_of, mesh_of
from workbench.exchange import mesh_limits, triangle_files
from workbench.exchange.mesh_reading import read_mesh
from workbench.exchange.meshes import stl
from workbench.exchange.reading import Job, read_now
from workbench.geometry.meshes import Faces, Mesh

XYZ = b"property float x\nproperty float y\nproperty float z\n"
CORNERS = b"property list uchar int vertex_indices\nend_header\n"


def ply_head(form: bytes, vertices: object, faces: object) -> bytes:
    head = b"ply\nformat %b 1.0\nelement vertex %b\n%belement face %b\n%b"
    return head % (form, str(vertices).encode(), XYZ, str(faces).encode(), CORNERS)


BYTES = (
    "The mesh has 3,000,000 vertices and 1,000,000 faces, which take at least 88,000,000 bytes; a picture "
    "can keep at most 67,108,864. Choose a simpler one."
)
TRIANGLES = (
    "The mesh has 3,000,000 faces; a scene can have at most 1,500,000 triangles. Choose a simpler one."
)
HEADS = {
    "binary.ply": (ply_head(b"binary_little_endian", 1_000_000, 3_000_000), TRIANGLES),
    "text.ply": (ply_head(b"ascii", 3_000_000, 1_000_000), BYTES),
    "text.off": (b"OFF\n# made by hand\n\n1000000 3000000 0\n", TRIANGLES),
}


@pytest.mark.parametrize("name", HEADS)
def test_a_head_that_announces_too_much_is_enough(name: str, tmp_path: Path) -> None:
    """Nothing follows it, which would be said if it were read."""
    head, sentence = HEADS[name]
    (tmp_path / name).write_bytes(head)
    with pytest.raises(ValueError, match="The mesh has ") as said:
        read_now(Job("mesh", str(tmp_path / name)))
    assert str(said.value) == sentence
    with pytest.raises(ValueError, match="ends before"):  # where it need not be kept
        read_mesh(head, Path(name).suffix)


def text_stl(facets: int, corner: str = "0 0 0") -> bytes:
    rows = f"vertex {corner}\nvertex 1 0 0\nvertex 0 1 0\n"
    facet = f"facet normal 0 0 1\nouter loop\n{rows}endloop\nendfacet\n"
    return ("solid a\n" + facet * facets + "endsolid a\n").encode()


@pytest.mark.parametrize("content", [stl(*solids.sphere(1.0, 20, 10)), text_stl(400)], ids=["bytes", "text"])
def test_an_stl_is_refused_by_the_number_of_its_triangles(
    content: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mesh_limits, "MOST_TRIANGLES", 200)

    def fail(*_given: object) -> None:
        raise AssertionError("it is read")

    monkeypatch.setattr(triangle_files, "_read", fail)
    count = "400" if content.startswith(b"solid") else "360"
    said = (
        rf"^The mesh has {count} triangles; a scene can have at most 200 triangles\. Choose a simpler one\.$"
    )
    with pytest.raises(ValueError, match=said):
        read_mesh(content, ".stl", to_keep=True)


def test_an_obj_is_refused_by_the_number_of_its_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mesh_limits, "MAX_BLOB_BYTES", 1_000)
    text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n" * 10 + b"f 1 2 3\n" * 60
    shares: list[float] = []
    said = "has 29 vertices and 60 faces, which take at least 1,656 bytes; a picture can keep at most 1,000"
    with pytest.raises(ValueError, match=said):
        read_mesh(text, ".obj", shares.append, to_keep=True)
    assert shares == []


def test_polygons_that_are_too_large_are_said_to_be_the_mesh(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_meshes, "MAX_BLOB_BYTES", 100)
    square = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
    said = "the mesh takes 148 bytes, but at most 100 can be kept; choose a simpler one"
    with pytest.raises(DocumentError, match=said):
        read_mesh(square, ".obj", to_keep=True)
    mesh = read_mesh(square, ".obj").mesh
    with pytest.raises(DocumentError, match=said):
        blob_of(mesh)
    monkeypatch.undo()
    assert len(blob_of(mesh)) == 148


def test_a_text_stl_says_what_is_wrong_with_its_coordinates() -> None:
    with pytest.raises(ValueError, match=r"\(1 face with a coordinate that is not a number or too large\)"):
        read_mesh(text_stl(1, "0 0 nan"), ".stl")
    both = text_stl(1, "0 0 nan") + text_stl(2, "0 0 inf") + text_stl(1)
    mesh, notes = read_mesh(both, ".stl")
    assert len(mesh.faces) == 1
    assert len(mesh.vertices) == 3
    assert notes == ("Left out: 3 faces with coordinates that are not numbers or too large.",)


@pytest.mark.parametrize("suffix", [".obj", ".off", ".ply", ".stl", ".glb"])
def test_zero_bytes_are_not_called_empty(suffix: str) -> None:
    with pytest.raises(
        ValueError, match="The file holds nothing but blanks or zero bytes; choose one with a mesh"
    ):
        read_mesh(bytes(1_000), suffix)
    with pytest.raises(ValueError, match="The file is empty"):
        read_mesh(b"", suffix)


@pytest.mark.parametrize("count", ["1000000000000", "9" * 5_000])
def test_too_large_a_count_of_a_ply_is_what_is_said(count: str) -> None:
    said = (
        "announces too many entries: 'element vertex [0-9]{13,}', and at most 4,000,000 vertices and as many"
    )
    with pytest.raises(ValueError, match=said):
        read_mesh(ply_head(b"ascii", count, 1), ".ply")


def test_zeros_before_a_count_are_no_digits_too_many() -> None:
    content = ply_head(b"ascii", "0" * 5_000 + "3", 1) + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    assert len(read_mesh(content, ".ply").mesh.faces) == 1


def test_the_bytes_of_a_mesh_are_made_with_few_copies() -> None:
    rng = np.random.default_rng(1)
    mesh = Mesh(rng.normal(size=(50_000, 3)), Faces.of(rng.integers(0, 50_000, (100_000, 3))))
    blob_of(mesh)
    tracemalloc.start()
    try:
        blob = blob_of(mesh)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 2.7 * len(blob)
    assert np.array_equal(mesh_of(blob).faces.corners, mesh.faces.corners)
