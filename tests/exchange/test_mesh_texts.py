"""The texts of mesh files: as editors save them, and numbers that are none of ours."""

import codecs
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.exchange.mesh_reading import read_mesh
from workbench.exchange.mesh_rows import rows_of

PLY = (
    b"ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    b"element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    b"0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"
)
SAVED_AS: dict[str, Callable[[str], bytes]] = {
    "UTF-8 with its mark": lambda text: text.encode("utf-8-sig"),
    "UTF-16": lambda text: codecs.BOM_UTF16_LE + text.encode("utf-16-le"),
    "UTF-16, the other order": lambda text: codecs.BOM_UTF16_BE + text.encode("utf-16-be"),
    "returns": lambda text: text.replace("\n", "\r\n").encode(),
    "old returns": lambda text: text.replace("\n", "\r").encode(),
}


@pytest.mark.parametrize("how", SAVED_AS)
@pytest.mark.parametrize("suffix", [".obj", ".off", ".ply"])
def test_a_mesh_is_the_same_however_an_editor_saved_its_text(suffix: str, how: str) -> None:
    """The first line of an OBJ is a vertex: without it all faces would name the wrong ones."""
    points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    text = {
        ".obj": "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + "f 1 2 3\nf 1 3 4\n",
        ".off": f"OFF\n4 2 0\n{points}3 0 1 2\n3 0 2 3\n",
        ".ply": PLY.decode().replace("face 1", "face 2").replace("4 0 1 2 3", "3 0 1 2\n3 0 2 3"),
    }[suffix]
    mesh, notes = read_mesh(SAVED_AS[how](text), suffix)
    assert mesh.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    assert [face.tolist() for face in mesh.faces] == [[0, 1, 2], [0, 2, 3]]
    assert notes == ()


@given(st.lists(st.sampled_from(["1", "-2.5", "3e1", "0,5", "x", "nan", "4\f5", "6\v7", ""]), max_size=12))
def test_rows_of_numbers_stay_on_their_lines(words: list[str]) -> None:
    """Whatever parts or spoils the numbers of one line, the others keep theirs."""
    lines = [f"{word} {number}".encode() for number, word in enumerate(words)]
    rows = rows_of(lines)
    assert rows.sizes.sum() == len(rows.numbers)
    for line, start, size in zip(rows.lines.tolist(), rows.starts.tolist(), rows.sizes.tolist(), strict=True):
        read = rows.numbers[start : start + size].tolist()
        assert repr(read) == repr([float(word) for word in lines[line].split()])
    readable = [k for k, word in enumerate(words) if word not in ("0,5", "x")]
    assert rows.lines.tolist() == readable


def test_a_ply_may_name_two_properties_alike() -> None:
    """The first of them counts, also where faces are of different sizes."""
    text = PLY.replace(b"face 1", b"face 2").replace(
        b"indices\n", b"indices\nproperty list uchar int vertex_indices\n"
    )
    text = text.replace(b"4 0 1 2 3\n", b"4 0 1 2 3 3 0 1 3\n3 0 1 2 3 1 2 3\n")
    assert [face.tolist() for face in read_mesh(text, ".ply").mesh.faces] == [[0, 1, 2, 3], [0, 1, 2]]


@pytest.mark.parametrize(
    ("content", "suffix", "said"),
    [
        (b"v 0,5 0 0\nv 1,5 0 0\nv 0 1,5 0\nf 1 2 3\n", ".obj", "3 lines that cannot be read"),
        (b"OFF\n3 1 0\n0,5 0 0\n1,5 0 0\n0 1,5 0\n3 0 1 2\n", ".off", "3 lines that cannot be read"),
        (PLY.replace(b"1 0 0", b"1,5 0 0"), ".ply", "something other than numbers"),
        (PLY.replace(b"float x", b"list uchar float x"), ".ply", "have no x, y and z"),
        (PLY.replace(b"list uchar int", b"int"), ".ply", "faces of the file name no vertices"),
        (PLY[:-4], ".ply", "ends before the 1 entry that it announces as face"),
    ],
)
def test_what_would_be_another_mesh_is_refused(content: bytes, suffix: str, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        read_mesh(content, suffix)
