"""Looking around: turning, the six sides, and the projections that can be chosen."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.algorithms.projection import STANDARD_VIEWS, classify, standard_view
from workbench.document.errors import DocumentError
from workbench.document.samples.examples import example
from workbench.document.scene.looking import facing, kind_of, kinds, orbited, projecting, turn_of, turned_to
from workbench.document.scene.model import Camera, Point3D
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.document.state import SessionState, check_state, cleaned, seen_scene, with_look

angles = st.floats(-7.0, 7.0)
SLUGS = [kind.slug for kind in kinds()]
FAMILY = {
    "one-point": "one-point perspective",
    "two-point": "two-point perspective",
    "three-point": "three-point perspective",
    "isometric": "isometric",
    "dimetric": "dimetric",
    "trimetric": "trimetric",
    "cavalier": "cavalier",
    "cabinet": "cabinet",
    **dict.fromkeys(STANDARD_VIEWS, "orthographic"),
}


def away(camera: Camera) -> float:
    return math.dist(camera.eye.xyz, camera.look_at.xyz)


@given(st.lists(st.tuples(angles, angles), min_size=1, max_size=4))
def test_whoever_goes_round_stays_as_far_away_with_a_level_horizon(turns: list[tuple[float, float]]) -> None:
    camera = Camera(look_at=Point3D(1.0, -2.0, 0.5))
    distance = away(camera)
    for d_theta, d_phi in turns:
        camera = orbited(camera, d_theta, d_phi)
    assert away(camera) == pytest.approx(distance)
    right, up, _forward = view_matrix(camera)[:3, :3]
    assert abs(right[1]) < 1e-9
    assert up[1] > -1e-9


@given(angles)
def test_nothing_flips_at_a_pole(theta: float) -> None:
    """Up to the pole, on beyond it, and back again: the picture turns by no more than was asked for."""
    camera = turned_to(Camera(), theta, math.radians(80.0))
    before = view_matrix(camera)[:3, :3]
    for d_phi in (9.5, 0.4, 5.0, 5.0, -0.2, -9.8):
        camera = orbited(camera, 0.0, math.radians(d_phi))
        after = view_matrix(camera)[:3, :3]
        assert np.abs(after - before).max() < 0.2
        assert np.allclose(after[0], before[0], atol=1e-6)  # what is right stays right
        before = after
    assert math.degrees(turn_of(camera)[1]) == pytest.approx(80.0)


@pytest.mark.parametrize("side", STANDARD_VIEWS)
def test_each_side_is_seen_as_the_course_has_it(side: str) -> None:
    seen = view_matrix(facing(Camera(projection="orthographic"), side))[:3, :3]
    assert np.allclose(seen, standard_view(side)[:3, :3], atol=1e-9)


@pytest.mark.parametrize("slug", SLUGS)
@pytest.mark.parametrize("radius", [1e-3, 2.0, 500.0])
def test_a_projection_that_is_chosen_is_the_one_that_is_had(slug: str, radius: float) -> None:
    camera = projecting(Camera(look_at=Point3D(0.5, 1.0, -2.0)), slug, radius)
    assert kind_of(camera) == slug
    view = view_matrix(camera)
    assert classify(projection_matrix(camera) @ view, view).name == FAMILY.get(
        slug, classify(projection_matrix(camera) @ view, view).name
    )
    # All that reaches so far is between the near and the far plane.
    depth = away(camera)
    assert camera.near <= max(depth - radius, radius / 100, 1e-3)
    assert camera.far >= depth + radius


def test_an_axonometric_view_that_is_turned_stays_parallel() -> None:
    turned = orbited(projecting(Camera(), "isometric", 2.0), 0.1, 0.0)
    assert turned.projection == "axonometric"
    assert kind_of(turned) == "trimetric"
    assert kind_of(orbited(turned, -0.1, 0.0)) == "isometric"


def test_an_eye_at_what_it_looks_at_is_refused_and_put_right_by_a_projection() -> None:
    here = Camera(eye=Point3D(1.0, 1.0, 1.0), look_at=Point3D(1.0, 1.0, 1.0))
    for turn in (lambda: orbited(here, 0.1, 0.0), lambda: turned_to(here, 0.0, 0.0)):
        with pytest.raises(ValueError, match="eye is at the point"):
            turn()
    for slug in SLUGS:
        if slug not in ("matrix", "orthographic"):
            assert kind_of(projecting(here, slug, 2.0)) == slug
    with pytest.raises(LookupError):
        projecting(here, "fisheye", 1.0)


# What the session keeps of it


def test_a_look_holds_until_the_scene_has_another_camera() -> None:
    document = example("space-house").document
    (sheet,) = document.sheets
    assert sheet.scene is not None
    looked = orbited(sheet.scene.camera, 0.3, 0.1)
    state = check_state(SessionState(sheet="s1", looks=with_look(SessionState(), sheet, looked)), document)
    seen = seen_scene(state, sheet)
    assert seen is not None
    assert seen.camera == looked
    other = replace(sheet, scene=replace(sheet.scene, camera=replace(looked, distance=9.0)))
    assert seen_scene(state, other) == other.scene
    assert with_look(state, sheet, sheet.scene.camera) == with_look(state, sheet, None) == {}


def test_looks_and_chosen_objects_of_what_has_gone_are_left_out() -> None:
    document, other = example("space-house").document, example("line").document
    looks = with_look(SessionState(), document.sheets[0], Camera())
    state = SessionState(sheet="s1", looks=looks, thing="o2")
    assert check_state(state, document) is state
    left = cleaned(state, other)
    assert left.thing == ""
    gone = replace(other, sheets=(replace(other.sheets[0], id="s7"),))
    assert cleaned(state, gone).looks == {}
    for bad, words in (
        (replace(state, thing="o9"), "thing"),
        (replace(state, looks={"s9": looks["s1"]}), "looks"),
    ):
        with pytest.raises(DocumentError, match=words):
            check_state(bad, document)
    blind = replace(looks["s1"], camera=Camera(near=5.0, far=1.0))
    with pytest.raises(DocumentError, match="sees nothing"):
        check_state(replace(state, looks={"s1": blind}), document)
