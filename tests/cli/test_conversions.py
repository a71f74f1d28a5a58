"""convert and surface: files in, files out, and the one line that says what is wrong."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from msgspec.structs import replace

from tests.cli.test_commands import printed, refused
from tests.document.views import seen_through
from workbench.__main__ import main
from workbench.document import load, save
from workbench.document.model import Curve, CurvePoint, Rectangle
from workbench.document.samples.examples import example_document
from workbench.document.samples.figures import document_of
from workbench.exchange.svg_paths import read_svg

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="2 3 48 24">{}</svg>'


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_an_svg_becomes_a_document_in_its_own_coordinates(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    data = "M 2 3 Q 5 6 7 8 A 4 3 0 0 1 9 9"
    (folder / "a.svg").write_text(SVG.format(f'<path d="{data}" stroke="red" fill="none"/><text/>'))
    said = printed(capsys, "convert", "a.svg", "-o", "a.gwb", "--tolerance", "0.001").splitlines()
    assert said[0].startswith("<path> in line 1 is approximated within ")
    assert said[1] == "Left out: 1 <text>."
    assert said[2:] == ["Lines are drawn one pixel wide and without dashes, along their centre."]
    sheet = load("a.gwb").sheets[0]
    assert sheet.name == "a"
    assert (sheet.width_px, sheet.height_px) == (200, 100)
    assert sheet.first_view.window_world == Rectangle(2, -27, 50, -3)
    (curve,) = sheet.figures
    first = [(p.x, p.y) for p in curve.points_world[:4]]
    assert np.allclose(first, [(2, -3), (4, -5), (17 / 3, -20 / 3), (7, -8)], rtol=1e-14)
    assert "Left out: 1 <text>.\n" in printed(capsys, "convert", "a.svg", "-o", "b.gwb", "--size", "60x30")
    assert load("b.gwb").sheets[0].width_px == 60


def test_a_document_goes_out_and_comes_back(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    points = tuple(CurvePoint("", 7.3 * k, 5.1 * (k % 2), weight=1.0 + k) for k in range(5))
    document = document_of("arch", 70, 30, [Curve("", points, "dda_line", 1, spline="nurbs")])
    window = Rectangle(-0.3, -0.7, 41.9, 17.3)
    document = replace(document, sheets=(seen_through(document.sheets[0], window_world=window),))
    save(document, "arch.gwb")
    said = printed(capsys, "convert", "arch.gwb", "-o", "arch.svg", "--tolerance", "0.01")
    assert said.startswith("f1 is approximated within 0.0")
    assert printed(capsys, "convert", "arch.svg", "-o", "again.gwb") == ""
    back = load("again.gwb").sheets[0]
    assert (back.width_px, back.height_px) == (70, 30)
    assert back.figures == document.sheets[0].figures


def test_points_become_a_curve(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    turn = np.linspace(0, 3, 60)
    rows = [f"{x:.4f};{y:.4f}" for x, y in zip(20 * turn, 9 * np.sin(turn), strict=True)]
    (folder / "points.csv").write_text("\n".join(["x;y", *rows]))
    said = printed(capsys, "convert", "points.csv", "-o", "curve.svg", "--tolerance", "0.05")
    assert "Bézier pieces pass within 0.0" in said
    sheet = example_document().sheets[0]
    (curve,) = read_svg((folder / "curve.svg").read_text(), sheet).figures
    assert isinstance(curve, Curve)
    assert curve.spline == "bezier_path"


def test_points_near_the_end_of_the_world_become_a_curve(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    (folder / "far.csv").write_text("999999,0\n1000000,999999\n999000,5\n")
    assert "pass exactly through all 3 points" in printed(capsys, "convert", "far.csv", "-o", "far.gwb")
    assert load(folder / "far.gwb").sheets[0].first_view.window_world.xmax == 1_000_000


def test_a_sheet_is_chosen(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    save(example_document(), "a.gwb")
    assert printed(capsys, "convert", "a.gwb", "-o", "a.svg", "--sheet", "1") == ""
    assert "no sheet 2" in refused(capsys, "convert", "a.gwb", "-o", "a.svg", "--sheet", "2")


def test_a_surface_becomes_a_mesh(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    said = printed(capsys, "surface", "sphere", "-o", "sphere.stl", "--tolerance", "0.05")
    mesh = trimesh.load_mesh(str(folder / "sphere.stl"))
    assert mesh.is_watertight
    assert f"{len(mesh.vertices)} vertices, {len(mesh.faces)} triangles, within 0.05." in said
    net = [[[float(i), float(j), float(i * j)] for j in range(4)] for i in range(5)]
    for given in ({"points": net}, {"points": net, "degrees": [3, 2]}):
        (folder / "net.json").write_text(json.dumps(given))
        printed(capsys, "surface", "net.json", "-o", "net.obj")
        mesh = trimesh.load_mesh(str(folder / "net.obj"))
        assert np.abs(mesh.vertices[:, 2] - mesh.vertices[:, 0] * mesh.vertices[:, 1]).max() < 12
        assert mesh.bounds.tolist() == [[0, 0, 0], [4, 3, 12]]


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("convert", "a.svg", "-o", "a.pdf"), "a.pdf: choose a name that ends in .gwb or .svg"),
        (("convert", "nowhere.svg", "-o", "a.gwb"), "There is no file nowhere.svg; choose another"),
        (("convert", "a.doc", "-o", "a.gwb"), "a.doc: this cannot be read"),
        (("convert", "broken.svg", "-o", "a.gwb"), "broken.svg: Line 1, column 61, <path>: command 2"),
        (("convert", "latin.csv", "-o", "a.gwb"), "latin.csv: Line 2, column 1: '\xe4' is not a number"),
        (("convert", "broken.csv", "-o", "a.gwb"), "broken.csv: Line 2, column 1: 'b' is not a number"),
        (("convert", "one.csv", "-o", "a.gwb"), "one.csv: There is 1 point, and 2"),
        (("convert", "tiny.csv", "-o", "a.gwb"), "tiny.csv: The points lie within 2e-09 of one another"),
        (("convert", "same.csv", "-o", "a.gwb"), "same.csv: All points are in one place"),
        (("convert", "a.svg", "-o", "a.gwb", "--tolerance", "0"), "The tolerance is 0"),
        (("convert", "a.svg", "-o", "a.gwb", "--tolerance", "nan"), "The tolerance is nan"),
        (("convert", "a.svg", "-o", "a.gwb", "--size", "0x5"), "each side has 1 to 4096"),
        (("convert", "a.svg", "-o", "a.gwb", "--size", "big"), "write it as 640x480"),
        (
            ("surface", "cube", "-o", "a.obj"),
            "There is no file cube; give a JSON file or one of",
        ),
        (("surface", "sphere", "-o", "a.fbx"), "a.fbx: choose a name that ends in .obj, .ply or .stl"),
        (("surface", "sphere", "-o", "a.obj", "--tolerance", "-1"), "The tolerance is -1"),
        (("surface", "x" * 300, "-o", "a.obj"), "cannot be read (File name too long); choose another file."),
        (("surface", "broken.json", "-o", "a.obj"), "broken.json is not JSON"),
        (("surface", "list.json", "-o", "a.obj"), "list.json holds no surface"),
        (("surface", "ragged.json", "-o", "a.obj"), "ragged.json holds no surface"),
        (("surface", "knots.json", "-o", "a.obj"), "knots.json: There are 3 knots, and 2 points"),
        (("surface", "far.json", "-o", "a.obj"), "points has a number that is not between -1e+06 and 1e+06"),
        (("surface", "steep.json", "-o", "a.obj"), "the surface has degree 99; it can be 1 to 15"),
        (("surface", "long.json", "-o", "a.obj"), "the surface has degree 29; it can be 1 to 15"),
    ],
)
def test_bad_input_is_named_in_one_line(
    capsys: pytest.CaptureFixture[str], folder: Path, words: tuple[str, ...], named: str
) -> None:
    (folder / "a.svg").write_text(SVG.format(""))
    (folder / "broken.svg").write_text(SVG.format('<path d="M 0 0 L 1"/>'))
    (folder / "broken.csv").write_text("1,2\nb,3\n")
    (folder / "tiny.csv").write_text("1e-9,0\n2e-9,1e-9\n3e-9,5e-10\n")
    (folder / "one.csv").write_text("1,2\n")
    (folder / "same.csv").write_text("1,2\n1,2\n")
    (folder / "latin.csv").write_bytes(b"1,2\n\xe4,3\n")
    (folder / "broken.json").write_text("{")
    (folder / "list.json").write_text("[1, 2]")
    (folder / "ragged.json").write_text('{"points": [[[0, 0, 0], [1, 1, 1]], [[2, 2, 2]]]}')
    net: Any = {"points": [[[0, 0, 0], [1, 1, 1]], [[2, 2, 2], [3, 3, 3]]], "degrees": [1, 1]}
    (folder / "far.json").write_text(json.dumps({"points": [[[0, 0, 0], [1, 1, 1e300]]] * 2}))
    (folder / "steep.json").write_text(json.dumps({**net, "degrees": [99, 1]}))
    (folder / "long.json").write_text(json.dumps({"points": net["points"] * 15}))
    (folder / "knots.json").write_text(json.dumps({**net, "u_knots": [0, 0, 1]}))
    assert named in refused(capsys, *words)
    assert not list(folder.glob("a.[gop]*"))


def test_what_cannot_be_written_is_no_bad_input(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    save(example_document(), "a.gwb")
    for target in ("nowhere/a.svg", "nowhere/a.gwb"):
        assert main(("convert", "a.gwb", "-o", target)) == 1
        assert "nowhere" in capsys.readouterr().err
    assert main(("surface", "sphere", "-o", "nowhere/a.obj")) == 1
