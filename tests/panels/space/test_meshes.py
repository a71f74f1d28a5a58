"""Mesh files come into the scene; scenes leave the program as pictures, lines and meshes."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from msgspec.structs import replace
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from tests.panels.space.by_hand import scene_of, shown
from workbench.document.samples.examples import blank_sheet
from workbench.document.scene.model import Scene
from workbench.document.sheet_edits import add_sheet
from workbench.exchange.reading import AT_ONCE
from workbench.exchange.written import formats
from workbench.panels.space.panel import SpacePanel
from workbench.panels.space.projection_page import ProjectionPage
from workbench.session.session import Session
from workbench.shell import scene_exports


def imported(
    qtbot: QtBot, session: Session, path: Path, meanwhile: Callable[[], object] = lambda: None
) -> list[str]:
    panel = SpacePanel(session)
    keep_until_the_end(qtbot, panel)
    said: list[str] = []
    panel.meshes.take_file(path, said.append, said.append)
    meanwhile()
    qtbot.waitUntil(lambda: not session.incoming.busy, timeout=20_000)
    return [sentence for sentence in said if sentence]


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".stl", ".off", ".glb"])
def test_a_mesh_comes_onto_a_sheet_of_its_own_in_one_step(qtbot: QtBot, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"ball{suffix}"
    trimesh.creation.icosphere(subdivisions=1).export(path)
    session = Session(document=blank_sheet())
    (said,) = imported(qtbot, session, path)
    assert f"ball{suffix} is in the scene." in said
    assert len(session.document.sheets) == 2
    scene = session.sheet.scene
    assert scene is not None
    assert session.state.thing == scene.objects[0].id
    vertices = scene.objects[0].mesh.vertices
    assert np.hypot(*np.abs(vertices).max(axis=0)[:2]) == pytest.approx(2**0.5, abs=0.2)
    session.undo_stack.undo()
    assert len(session.document.sheets) == 1
    session.close()


def test_a_mesh_comes_beside_what_is_in_the_scene_and_what_was_left_out_is_said(
    qtbot: QtBot, tmp_path: Path
) -> None:
    path = tmp_path / "part.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n", encoding="utf-8")
    session = Session()
    session.open_example("space-isometric")
    shown_anew: list[bool] = []
    session.opened.connect(lambda: shown_anew.append(True))
    (said,) = imported(qtbot, session, path)
    assert not shown_anew  # what is stepped and selected on the sheet stays so
    assert len(session.document.sheets) == 1
    assert session.sheet.scene is not None
    assert [thing.name for thing in session.sheet.scene.objects] == ["Cube", "part"]
    assert said.startswith("part.obj is in the scene. Left out: ")
    session.close()


def test_a_mesh_is_shown_where_it_went_although_another_sheet_was_looked_at_while_it_was_read(
    qtbot: QtBot, tmp_path: Path
) -> None:
    path = tmp_path / "part.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n#" + AT_ONCE * " ", encoding="utf-8")
    session = Session()
    session.open_example("space-isometric")
    first = session.sheet.id
    session.apply(add_sheet(replace(blank_sheet().sheets[0], scene=Scene())), "Add")
    empty = next(sheet.id for sheet in session.document.sheets if sheet.id != first)
    session.show_sheet(first)

    def look_elsewhere() -> None:
        assert session.incoming.busy
        session.show_sheet(empty)

    assert imported(qtbot, session, path, look_elsewhere) == ["part.obj is in the scene."]
    assert session.sheet.id == first
    assert session.sheet.scene is not None
    assert [thing.name for thing in session.sheet.scene.objects] == ["Cube", "part"]
    assert session.state.thing == session.sheet.scene.objects[1].id
    session.close()


def test_a_file_that_is_no_mesh_changes_nothing(qtbot: QtBot, tmp_path: Path) -> None:
    path = tmp_path / "bad.obj"
    path.write_text("f 1 2 99\n", encoding="utf-8")
    session = Session(document=blank_sheet())
    (said,) = imported(qtbot, session, path)
    assert said.startswith("bad.obj was not imported: ")
    assert not session.dirty
    session.close()


def test_what_is_exported_is_read_again(qtbot: QtBot, tmp_path: Path) -> None:
    pages = shown(qtbot)
    page: ProjectionPage = next(pages)
    scene: Scene = scene_of(page)
    whole, faces = scene_exports._mesh(scene, "")
    assert len(whole) == sum(len(thing.mesh.vertices) for thing in scene.objects)
    for file_format in formats("mesh"):
        path = tmp_path / f"scene{file_format.suffix}"
        parts: list[bytes] = []
        file_format.encode((whole, faces), parts.append, lambda *_share: None)
        path.write_bytes(b"".join(parts))
        read = trimesh.load(path, force="mesh")
        assert np.allclose(read.bounds, [whole.min(axis=0), whole.max(axis=0)], atol=1e-5)
    chimney, _faces = scene_exports._mesh(scene, "o2")
    assert np.allclose([chimney.min(axis=0), chimney.max(axis=0)], [[0.55, 2.4, -1.05], [1.05, 3.8, -0.55]])
    segments, window, size = scene_exports._wireframe(scene)
    assert len(segments) == 15 + 12 + 8
    assert (segments[:, [0, 2]] >= window.xmin).all()
    assert (segments[:, [0, 2]] <= window.xmax).all()
    image, _cell = scene_exports._picture(scene)
    assert image.shape == size[::-1]
    assert image[0, 0] == 0xFFFFFF
    assert (image != 0xFFFFFF).mean() > 0.2
    next(pages, None)
