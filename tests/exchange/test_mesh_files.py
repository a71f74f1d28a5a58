"""Mesh files as people have them are read as they are; what cannot be kept is left out and counted."""

import itertools
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import solids
from workbench.exchange.mesh_reading import ImportedMesh, read_mesh
from workbench.exchange.reading import Job, Reading
from workbench.geometry.meshes import Faces, Mesh, triangulated

# Meshes that everybody knows, in a folder beside the checkout; they are not part of the project
MODELS = Path(__file__).resolve().parents[3] / "shared" / "data" / "models"
CUBE = solids.cube()

Says = Callable[[str, str], str]


def faces_of(mesh: Mesh) -> list[list[int]]:
    return [face.tolist() for face in mesh.faces]


def same(mesh: Mesh, other: Mesh) -> None:
    assert np.array_equal(mesh.vertices, other.vertices)
    assert faces_of(mesh) == faces_of(other)


def obj(mesh: Mesh, corner: Callable[[int], str] = str, end: str = "\n") -> bytes:
    lines = [f"v {x} {y} {z}" for x, y, z in mesh.vertices.tolist()]
    lines += ["f " + " ".join(corner(k + 1) for k in face) for face in faces_of(mesh)]
    return (end.join(lines) + end).encode()


TWO = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
SQUARE = [[0, 1, 2, 3]]
# What people's files have: the text, its faces, what is said.
OBJS: dict[str, tuple[str, list[list[int]], str]] = {
    "places in a texture": (TWO + "vt 0 0\nf 1/1 2/1 3/1 4/1\n", SQUARE, ""),
    "normals": (TWO + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n", SQUARE, ""),
    "both": (TWO + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\n", SQUARE, ""),
    "backwards": (TWO + "f -4 -3 -2 -1\n", SQUARE, ""),
    "backwards in between": (
        "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nv 0 2 0\nf -3//-1 -2//-1 -1//-1 2/1\n",
        [[1, 2, 3], [3, 4, 5, 1]],
        "",
    ),
    "names and groups": (
        f"mtllib not there.mtl\no a cube of mine\n{TWO}g one two\nusemtl red paint\ns off\nf 1 2 3 4\n",
        SQUARE,
        "",
    ),
    "a line that goes on": (TWO + "f 1 2 \\\n3 4\n", SQUARE, ""),
    "tabs and returns": (TWO.replace(" ", "\t").replace("\n", "\r\n") + "f\t1\t2 3  4\r\n", SQUARE, ""),
    "old returns": ((TWO + "f 1 2 3 4\n").replace("\n", "\r"), SQUARE, ""),
    "blanks everywhere": ("  " + TWO.replace("\n", "  \n  ") + "f  1   2 3 4  \n\n\n", SQUARE, ""),
    "comments": ("# v 9 9 9\n" + TWO + "f 1 2 3 4 # the only one\n", SQUARE, ""),
    "no last line end": (TWO + "f 1 2 3 4", SQUARE, ""),
    "colours": (
        TWO.replace(" 0\n", " 0 1 0.5 0\n") + "f 1 2 3 4\n",
        SQUARE,
        "Left out: the colours of the vertices.",
    ),
    "a weight": (TWO.replace(" 0\n", " 0 1.0\n") + "f 1 2 3 4\n", SQUARE, ""),
    "numbers as C prints them": (
        "v +0. -0 0e0\nv 1. .0 0\nv 01 1 0.\nv 0 1.0e+00 -0\nf 1 2 3 4\n",
        SQUARE,
        "",
    ),
    "lines and points": (TWO + "l 1 2\np 1\nf 1 2 3 4\n", SQUARE, ""),
    "out of range": (
        TWO + "f 1 2 3 4\nf 1 2 5\nf 0 1 2\nf -9 1 2\nf 1 2 99999999999999999999\n",
        SQUARE,
        "Left out: 4 faces with vertices that do not exist.",
    ),
    "too few corners": (
        TWO + "f 1 2 3 4\nf 1 2\nf\nf 1\n",
        SQUARE,
        "Left out: 2 faces with fewer than 3 or more than 4,096 corners.",
    ),
    "no area": (
        TWO + "v 2 0 0\nf 1 2 3 4\nf 1 2 2\nf 1 2 5\n",
        SQUARE,
        "Left out: 2 faces without area.",
    ),
    "NaN": (
        TWO + "v nan 0 0\nv inf 0 0\nf 1 2 5\nf 1 2 3 4\nf 6 1 2\n",
        SQUARE,
        "Left out: 2 faces with coordinates that are not numbers or too large.",
    ),
    "letters": (
        TWO + "v a b c\nf 1 2 3 4\nf one two\nf 1 2 5\n",
        SQUARE,
        "Left out: 1 face with a coordinate that is not a number or too large, 2 lines that cannot be read.",
    ),
}


@pytest.mark.parametrize("name", OBJS)
def test_an_obj_as_people_have_them(name: str) -> None:
    text, faces, said = OBJS[name]
    mesh, notes = read_mesh(text.encode(), ".OBJ")
    assert faces_of(mesh) == faces
    assert "".join(notes) == said
    square = mesh.vertices[mesh.faces[0 if len(faces) == 1 else 1]]
    assert square.tolist()[1:3] == ([[1, 0, 0], [1, 1, 0]] if len(faces) == 1 else [[0, 1, 0], [0, 2, 0]])


@given(st.integers(0, 2**32 - 1))
def test_faces_are_counted_as_a_reader_of_single_lines_counts_them(seed: int) -> None:
    random = np.random.default_rng(seed)
    lines, vertices, faces = [], 0, []
    for _line in range(60):
        if random.random() < 0.5:
            lines.append("v {} {} {}".format(*random.random(3)))
            vertices += 1
            continue
        corners = random.integers(-vertices - 1, vertices + 2, random.integers(3, 6)).tolist()
        named = [k - 1 if k > 0 else vertices + k if k else -1 for k in corners]
        if len(set(named)) < len(named):
            continue
        lines.append("f " + " ".join(f"{k}{random.choice(['', '/1', '//2', '/3/-4'])}" for k in corners))
        faces.append(named)
    kept = [face for face in faces if all(0 <= k < vertices for k in face)]
    missing = len(faces) - len(kept)
    if not kept:
        with pytest.raises(ValueError, match="face"):
            read_mesh("\n".join(lines).encode(), ".obj")
        return
    mesh, notes = read_mesh("\n".join(lines).encode(), ".obj")
    assert faces_of(mesh) == kept
    assert (f"{missing} face" in "".join(notes)) == (missing > 0)


PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f"}


def ply(kind: str, mesh: Mesh, before: bool = False, count: str = "uchar", index: str = "int") -> bytes:
    """A PLY with further properties, and with an element before the others if asked for."""
    head = ["ply", f"format {kind} 1.0", "comment made by hand"]
    head += ["element camera 2", "property list uchar short what", "property float how"] if before else []
    head += [f"element vertex {len(mesh.vertices)}", "property uchar red", "property float x"]
    head += ["property float y", "property float z", f"element face {len(mesh.faces)}"]
    head += ["property float quality", f"property list {count} {index} vertex_indices"]
    head += ["property list uchar float texcoord", "element edge 1", "property int vertex1", "end_header\n"]
    rows: list[list[tuple[str, Any]]] = []
    if before:
        rows += [[("uchar", 1), ("short", -2), ("float", 1.5)], [("uchar", 0), ("float", 2.5)]]
    for x, y, z in mesh.vertices.tolist():
        rows.append([("uchar", 9), ("float", x), ("float", y), ("float", z)])
    for number, face in enumerate(faces_of(mesh)):
        texture = [("uchar", number % 3), *(("float", 0.5) for _k in range(number % 3))]
        rows.append([("float", 0.25), (count, len(face)), *((index, k) for k in face), *texture])
    rows.append([("int", 7)])
    text = "\n".join(head).encode()
    if kind == "ascii":
        return text + b"".join(b" ".join(str(v).encode() for _t, v in row) + b"\n" for row in rows)
    order = "<" if "little" in kind else ">"
    return text + b"".join(struct.pack(order + PLY_TYPES[t], v) for row in rows for t, v in row)


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize("make", [solids.cube, solids.house, solids.cone, solids.icosahedron])
@pytest.mark.parametrize("before", [False, True])
def test_a_ply_of_any_order_with_whatever_else_in_it(
    kind: str, make: Callable[[], Mesh], before: bool
) -> None:
    mesh = make()
    mesh = Mesh(np.round(mesh.vertices * 64) / 64, mesh.faces)
    for count, index in (("uchar", "int"), ("int", "uint"), ("char", "short"), ("ushort", "ushort")):
        read, notes = read_mesh(ply(kind, mesh, before, count, index), ".ply")
        same(read, mesh)
        assert notes == ("Left out: the colours of the vertices.",)


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize("make", [solids.cube, solids.house])
def test_a_ply_that_breaks_off_anywhere_is_refused(kind: str, make: Callable[[], Mesh]) -> None:
    whole = ply(kind, make(), before=True)
    for end in range(0, len(whole) - 40, 7):
        with pytest.raises(ValueError, match=r"\.$"):
            read_mesh(whole[:end], ".ply")


@pytest.mark.parametrize(
    "text",
    [
        "OFF\n4 1 0\n{}4 0 1 2 3\n",
        "# me\n\nOFF # it\r\n4 1 0\r\n\r\n{}4 0 1 2 3 255 0 0\n",
        "OFF 4 1 0\n{}4 0 1 2 3\n",
        "4 1\n{}4 0 1 2 3\n",
        "OFF\n4 3 0\n{}4 0 1 2 3\n3 0 1 4\n2 0 1\n",
    ],
)
def test_an_off_as_people_have_them(text: str) -> None:
    points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    mesh, _notes = read_mesh(text.format(points).encode(), ".off")
    same(mesh, Mesh(np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), Faces.of(SQUARE)))
    coloured = text.format(points.replace("\n", " 255 0 0 255\n")).replace("OFF", "COFF").encode()
    same(read_mesh(coloured, ".off").mesh, mesh)


@pytest.mark.parametrize("suffix", ["stl", "glb", "ply", "obj", "off"])
@pytest.mark.parametrize("make", [solids.torus, solids.bracket])
def test_what_trimesh_writes_is_read_with_its_volume_and_area(
    suffix: str, make: Callable[[], Mesh], tmp_path: Path
) -> None:
    mesh = make()
    judge = trimesh.Trimesh(mesh.vertices, triangulated(*mesh)[0], process=False)
    judge.export(tmp_path / f"a.{suffix}")
    read, notes = read_mesh((tmp_path / f"a.{suffix}").read_bytes(), f".{suffix}")
    back = trimesh.Trimesh(read.vertices, triangulated(*read)[0], process=False)
    assert back.is_watertight
    assert (back.volume, back.area) == pytest.approx((judge.volume, judge.area), rel=1e-5)
    assert "colour" in "".join(notes) or notes == ()


@pytest.mark.parametrize("name", ["teapot.obj", "cow.obj", "suzanne.obj"])
def test_well_known_models_are_read_as_trimesh_reads_them(name: str) -> None:
    if not (MODELS / name).exists():
        pytest.skip(f"{name} is not on this computer")
    content = (MODELS / name).read_bytes()
    mesh, notes = read_mesh(content, ".obj")
    lines = content.decode().split("\n")
    sizes = [len(line.split()) - 1 for line in lines if line.startswith("f ")]
    assert mesh.faces.sizes.tolist() == sizes or "Left out" in "".join(notes)
    judge = trimesh.load_mesh(MODELS / name, process=False)
    area = trimesh.Trimesh(mesh.vertices, triangulated(*mesh)[0], process=False).area
    assert area == pytest.approx(judge.area, rel=1e-3)
    assert mesh.vertices.min(axis=0) == pytest.approx(judge.bounds[0])


@pytest.mark.parametrize(
    ("content", "suffix", "said"),
    [
        (b"", ".obj", "The file is empty; choose one with a mesh in it."),
        (b" \n\t\n", ".off", "holds nothing but blanks or zero bytes"),
        (b"v 1 2 3\n", ".obj", "The file has no face"),
        (b"Dear reader,\nthis is a letter.\n", ".obj", "The file has no face"),
        (bytes(range(256)) * 40, ".obj", "The file has no face"),
        (b"v 0 0 0\nf 1 1 1\n", ".obj", r"No face of the file can be drawn \(1 face without area\)"),
        (b"Dear reader", ".ply", "This is not a PLY file"),
        (b"ply\nformat ascii 1.0\nend_header\n", ".ply", "has no vertices or no faces"),
        (b"ply\nelement vertex 1\nfly away\nend_header\n", ".ply", "is not known: 'fly away'"),
        (
            b"ply\nformat ascii 1.0\nelement vertex 1\nelement face 1\nend_header\n",
            ".ply",
            "have no x, y and z",
        ),
        (
            b"ply\nformat binary_little_endian 1.0\nelement vertex 999999\nproperty float x\n"
            b"property float y\nproperty float z\nelement face 1\nend_header\n",
            ".ply",
            "ends before the last of 999,999 entries that it announces as vertex",
        ),
        (
            b"ply\nformat ascii 1.0\nelement vertex 999999999999\nelement face 1\nend_header\n",
            ".ply",
            "999,999,999,999 vertices and 1 face; at most 4,000,000",
        ),
        (b"Dear reader", ".off", "not an OFF"),
        (b"OFF\n4 1 0\n0 0 0\n", ".off", "announces 4 vertices and 1 face, but ends before"),
        (b"OFF\n-4 1 0\n0 0 0\n", ".off", "does not begin with the numbers of vertices and faces"),
        (b"OFF\n1e300 1 0\n", ".off", "too large"),
        (b"OFF\nnan 1 0\n", ".off", "too large"),
        (b"Dear reader", ".stl", "The file has no face"),
        (b"glTF\x02\0\0\0", ".glb", "The file is not a GLB"),
        (b"v 0 0 0", ".doc", "ends in '.doc'"),
    ],
)
def test_what_is_no_mesh_is_refused_in_one_sentence(content: bytes, suffix: str, said: str) -> None:
    with pytest.raises(ValueError, match=said) as refused:
        read_mesh(content, suffix)
    assert str(refused.value).endswith(".")
    assert "\n" not in str(refused.value)


def test_a_child_reads_a_mesh_and_tells_how_far_it_is(tmp_path: Path) -> None:
    mesh = solids.sphere(1.0, 200, 100)
    (tmp_path / "a b.obj").write_bytes(obj(mesh, lambda k: f"{k}//{k}") + b"f 1 2 999999\n")
    shares: list[float] = []
    read = Reading(Job("mesh", str(tmp_path / "a b.obj"))).follow(shares.append)
    assert isinstance(read, ImportedMesh)
    same(read.mesh, mesh)
    assert read.notes == ("Left out: 1 face with a vertex that does not exist.",)
    assert shares == sorted(shares)
    assert len(shares) > 1


def test_500_mb_are_refused_before_they_are_read(tmp_path: Path, confined: Says) -> None:
    with (tmp_path / "large.obj").open("wb") as file:
        file.truncate(500 * 2**20)
    imports = "from workbench.exchange.reading import *"
    said = confined(imports, f"read_now(Job('mesh', {str(tmp_path / 'large.obj')!r}))")
    assert "has 524,288,000 bytes, but at most 268,435,456 can be opened" in said


MESH = "from workbench.exchange.mesh_reading import read_mesh"
HEAD = "b'ply\\nformat %s 1.0\\nelement vertex 3\\nproperty float x\\nproperty float y\\nproperty float z\\n"


@pytest.mark.parametrize(
    ("call", "said"),
    [
        ("read_mesh(b'v ' + b'1' * 10_000_000 + b' 0 0\\nf 1 1 1', '.obj')", "No face"),
        ("read_mesh(b'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf' + b' 1 2 3' * 500_000, '.obj')", "No face"),
        ("read_mesh(b'f 1 2 3\\\\\\n' * 100_000, '.obj')", "No face"),
        ("read_mesh(b'v a 0 0\\n' * 100_000 + b'f 1 2 3', '.obj')", "No face"),
        ("read_mesh(b'OFF\\n3999999 3999999 0\\n', '.off')", "ends before"),
        (
            f"read_mesh({HEAD % 'ascii'}element face 4000000\\nproperty list int int vertex_index\\n"
            "end_header\\n0 0 0 1 0 0 0 1 0\\n3 0 1 2\\n', '.ply')",
            "ends before the last",
        ),
        (
            f"read_mesh({HEAD % 'binary_big_endian'}element face 9\\nproperty list uint double "
            "vertex_index\\nend_header\\n' + b'\\xff' * 200, '.ply')",
            "ends before the last",
        ),
        ("read_mesh(b'solid ' + b'facet normal 0 0 1\\n' * 100_000, '.stl')", "has no face"),
    ],
)
def test_what_promises_much_takes_little(confined: Says, call: str, said: str) -> None:
    assert said in confined(MESH, call)


def test_mangled_meshes_are_read_or_refused_in_one_sentence() -> None:
    random = np.random.default_rng(5)
    refused: list[str] = []
    wholes = [
        (".obj", obj(solids.house(), lambda k: f"{k}/{k}//{k}")),
        (".ply", ply("ascii", solids.house())),
        (".ply", ply("binary_big_endian", solids.house())),
        (".off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    ]
    strange = [
        b"\0",
        b"nan",
        b"-1",
        b"1e999",
        b"\xff",
        b"/",
        b"\\\n",
        b" ",
        b"9" * 30,
        b"",
        b"\n",
        b"f ",
        b"#",
    ]
    for (suffix, whole), _turn in itertools.product(wholes, range(150)):
        content = bytearray(whole)
        for _change in range(random.integers(1, 4)):
            at = int(random.integers(len(content)))
            content[at : at + int(random.integers(0, 4))] = strange[random.integers(len(strange))]
        try:
            mesh, notes = read_mesh(bytes(content), suffix)
        except ValueError as refusal:
            refused.append(str(refusal))
            continue
        assert np.isfinite(mesh.vertices).all()
        assert 0 <= mesh.faces.corners.min() <= mesh.faces.corners.max() < len(mesh.vertices)
        assert all(note.endswith(".") for note in notes)
    assert 50 < len(refused) < 550
    assert all(sentence.endswith(".") for sentence in refused)
