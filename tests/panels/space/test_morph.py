"""From one projection a scene goes to another by the matrices between; with Calm at once."""

from collections.abc import Iterator

import numpy as np
import pytest
from msgspec.structs import replace
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import settle
from workbench.document.samples.examples import example
from workbench.document.scene.looking import facing
from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.panels.space.morph import between
from workbench.panels.space.projection_page import ProjectionPage
from workbench.session.session import Session
from workbench.widgets.look.comfort import comfort


@pytest.fixture
def moving() -> Iterator[None]:
    comfort.set_calm(False)
    yield
    comfort.set_calm(True)


def seen(camera: Camera, point: tuple[float, float, float]) -> np.ndarray:
    """Where a camera sees a point, on the view plane."""
    x, y, _z, w = projection_matrix(camera) @ view_matrix(camera) @ (*point, 1.0)
    return np.array([x / w, y / w])


def test_the_way_begins_and_ends_at_its_projections() -> None:
    before = Camera()
    after = replace(before, projection="isometric")
    for point in ((1.0, 0.0, 0.0), (0.0, 1.0, 1.0), (-1.0, 2.0, 0.5)):
        np.testing.assert_allclose(seen(between(before, after, 0.0), point), seen(before, point), atol=1e-12)
        assert between(before, after, 1.0) == after
        apart = np.linalg.norm(seen(before, point) - seen(after, point))
        way = [seen(between(before, after, share), point) for share in np.linspace(0, 1, 9)]
        assert max(np.linalg.norm(np.diff(way, axis=0), axis=1)) < apart


def test_halfway_to_the_opposite_side_there_is_no_picture(qtbot: QtBot) -> None:
    front = facing(Camera("orthographic"), "front")
    with pytest.raises(ValueError, match="flattens space"):
        between(front, facing(front, "back"), 0.5)


@pytest.mark.parametrize("calm", [True, False])
def test_choosing_a_projection_goes_there_by_matrices_unless_all_is_calm(
    qtbot: QtBot, moving: None, calm: bool
) -> None:
    comfort.set_calm(calm)
    session = Session(document=example("space-house").document)
    page = ProjectionPage(session)
    qtbot.addWidget(page)
    page.resize(900, 500)
    page.show()
    settle()
    page.choose("isometric")
    page.refresh()
    assert page.eye.scene.camera.projection == ("isometric" if calm else "matrix")
    assert page.strip._camera.projection == "isometric"
    qtbot.waitUntil(lambda: page.eye.scene.camera.projection == "isometric", timeout=5_000)
    assert session.sheet.scene.camera.projection == "isometric"
    session.close()
