"""render: meshes and scenes as pictures, and the one line that says what is wrong."""

import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tests.cli.test_commands import printed, refused
from tests.document.scene.scenes import full_document
from workbench.__main__ import main
from workbench.algorithms import solids
from workbench.cli import rendering, waiting
from workbench.document import load, save
from workbench.document.samples.examples import example_document
from workbench.engine.background import PATIENCE_S
from workbench.exchange.mesh_reading import read_mesh
from workbench.exchange.meshes import obj, ply, stl
from workbench.rendering import render_scene

# Meshes that everybody knows, in a folder beside the checkout; they are not part of the project
MODELS = Path(__file__).resolve().parents[3] / "shared" / "data" / "models"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "house.obj").write_bytes(obj(*solids.house()))
    save(full_document(), "scene.gwb")
    save(example_document(), "flat.gwb")
    return tmp_path


def pixels(path: Path | str) -> Any:
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB")).astype(int)[::-1]


def test_a_mesh_becomes_a_picture_and_its_depths(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    assert printed(capsys, "render", "house.obj", "-o", "a.png", "--size", "80x60", "--depth", "d.png") == ""
    image, depth = pixels("a.png"), pixels("d.png")
    assert image.shape == depth.shape == (60, 80, 3)
    seen = image.any(axis=2)
    assert 500 < seen.sum() < 60 * 80
    assert np.array_equal(seen, depth.any(axis=2))
    assert len(np.unique(image[seen], axis=0)) == 3  # two walls and half of the roof


def test_what_was_left_out_is_said(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    (folder / "b.obj").write_bytes(obj(*solids.house()) + b"f 1 2 99\n")
    said = printed(capsys, "render", "b.obj", "-o", "b.png", "--size", "80x60")
    assert said == "Left out: 1 face with a vertex that does not exist.\n"


def test_a_scene_is_drawn_in_the_window_of_its_sheet(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    printed(capsys, "render", "scene.gwb", "-o", "s.png")
    sheet = load("scene.gwb").sheets[0]
    assert sheet.scene is not None
    size, window = (sheet.width_px, sheet.height_px), sheet.first_view.window_world
    image, _depth = render_scene(sheet.scene, "depth_buffer", size, window=window)
    drawn = pixels("s.png")
    assert np.array_equal(drawn[..., 0] << 16 | drawn[..., 1] << 8 | drawn[..., 2], image)
    printed(capsys, "render", "scene.gwb", "-o", "t.png", "--projection", "cabinet", "--eye", "3,4,5")
    assert not np.array_equal(drawn, pixels("t.png"))


def test_lines_come_as_svg(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    printed(capsys, "render", "house.obj", "-o", "a.svg", "--size", "80x60", "--projection", "isometric")
    text = (folder / "a.svg").read_text()
    assert text.count("<path") == 15
    assert 'viewBox="0 0 80 60"' in text


def test_a_mesh_becomes_a_document_with_a_scene(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    printed(capsys, "convert", "house.obj", "-o", "h.gwb")
    scene = load("h.gwb").sheets[0].scene
    assert scene is not None
    (thing,) = scene.objects
    assert thing.name == "house"
    assert np.array_equal(thing.mesh.vertices, solids.house().vertices)
    printed(capsys, "render", "h.gwb", "-o", "h.png")
    assert pixels("h.png").any(axis=2).sum() > 500


@pytest.mark.parametrize("write", [obj, ply])
def test_a_mesh_is_written_with_its_faces_as_they_are(write: Any) -> None:
    house = solids.house()
    back = read_mesh(write(*house), f".{write.__name__}").mesh
    assert np.array_equal(back.vertices, house.vertices)
    assert [face.tolist() for face in back.faces] == [face.tolist() for face in house.faces]


def test_as_stl_it_has_triangles() -> None:
    back = read_mesh(stl(*solids.house()), ".stl").mesh
    assert back.faces.sizes.tolist() == [3] * 16
    assert len(back.vertices) == 10


@pytest.mark.parametrize("name", ["teapot.obj", "cow.obj", "suzanne.obj"])
def test_well_known_models_are_drawn(capsys: pytest.CaptureFixture[str], folder: Path, name: str) -> None:
    if not (MODELS / name).exists():
        pytest.skip(f"{name} is not on this computer")
    printed(capsys, "render", str(MODELS / name), "-o", "m.png", "--size", "160x120")
    assert 3_000 < pixels("m.png").any(axis=2).sum() < 160 * 120


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["none.obj", "-o", "a.png"], "There is no file none.obj; choose another."),
        (["house.obj", "-o", "a.gif"], "a.gif: choose a name that ends in .png or .svg."),
        (["flat.gwb", "-o", "a.png"], "flat.gwb: sheet 1 has no scene; choose one that has, or use draw."),
        (["scene.gwb", "-o", "a.png", "--sheet", "3"], "scene.gwb has one sheet, so there is no sheet 3."),
        (["house.obj", "-o", "a.png", "--eye", "1,2"], "'1,2' is not a point; write it as 4,3,8"),
        (["house.obj", "-o", "a.png", "--projection", "fish"], "There is no projection 'fish'"),
        (["house.obj", "-o", "a.png", "--visibility", "x"], ": There is no method for hidden surfaces 'x'"),
        (["house.obj", "-o", "a.png", "--shading", "x"], ": There is no shading 'x'; choose one of flat, "),
        (["house.obj", "-o", "a.svg", "--shading", "x"], ": There is no shading 'x'; choose one of flat, "),
        (["none.obj", "-o", "a.svg", "--visibility", "x"], ": There is no method for hidden surfaces 'x'"),
        (["house.obj", "-o", "a.png", "--eye", "1,1,1", "--look-at", "1,1,1"], "The eye is at the point"),
        (["text.txt", "-o", "a.png"], "this is neither a mesh nor a document; give one of .gwb, .obj"),
        (["empty.obj", "-o", "a.png"], "empty.obj: The file is empty; choose one with a mesh in it."),
        (["bad.gwb", "-o", "a.png"], "bad.gwb"),
    ],
)
def test_bad_input_is_named_in_one_line(
    capsys: pytest.CaptureFixture[str], folder: Path, words: list[str], said: str
) -> None:
    (folder / "text.txt").write_text("1 2\n")
    (folder / "empty.obj").write_text("")
    (folder / "bad.gwb").write_text("{}")
    line = refused(capsys, "render", *words)
    assert said in line
    assert not (folder / "a.png").exists()


def test_near_behind_far_is_refused_by_its_field(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    text = (folder / "scene.gwb").read_text()
    (folder / "scene.gwb").write_text(text.replace('"eye": {', '"near": 50.0, "far": 5.0, "eye": {', 1))
    line = refused(capsys, "render", "scene.gwb", "-o", "a.png")
    assert "sheets[0].scene.camera sees nothing (the near plane is at 50 and the far plane at 5" in line


def test_what_takes_long_says_so_meanwhile(
    capsys: pytest.CaptureFixture[str], folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(waiting, "AFTER_S", 0.0)
    monkeypatch.setattr(waiting, "EVERY_S", 60.0)
    draw = rendering.render_mesh

    def slow(*given: Any) -> Any:
        while "Still drawing" not in (said := capsys.readouterr().err):
            pass
        told.append(said)
        return draw(*given)

    told: list[str] = []
    monkeypatch.setattr(rendering, "render_mesh", slow)
    assert main(("render", "house.obj", "-o", "a.png", "--size", "80x60", "--visibility", "painter")) == 0
    assert told == [
        "Still drawing with painter; this may take minutes. depth_buffer is the fastest method.\n"
    ]
    assert pixels("a.png").any()


def test_what_fails_beside_is_told_here(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    with pytest.raises(ZeroDivisionError):
        waiting.telling(lambda: 1 // 0, "")


ENDLESS = """
import ctypes
import workbench.cli.waiting as waiting
waiting.AFTER_S = 0.0
waiting.telling(lambda: ctypes.CDLL(None).sleep(60), "begun")  # as deaf as compiled code
"""


@pytest.mark.skipif(sys.platform == "win32", reason="sends the signal of POSIX")
def test_ctrl_c_ends_at_once_what_cannot_be_stopped() -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", ENDLESS],
        stderr=subprocess.PIPE,
        # What is started in the background of a shell would not hear it
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    with process:
        assert process.stderr is not None
        assert process.stderr.readline() == b"begun\n"
        begun = time.monotonic()
        process.send_signal(signal.SIGINT)
        assert process.wait(30) == 130
        assert time.monotonic() - begun < PATIENCE_S / 2
