"""Parallel and perspective beside each other: the numbers of each row, by other ways."""

import math
import re

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.document.samples.examples import example
from workbench.document.scene.looking import projecting
from workbench.document.scene.model import Camera, Material, Object, Point3D, Scene
from workbench.document.scene.solids import AnySolid, Box, House
from workbench.rendering.scene.contrast import Contrast, Row, contrast

SLUGS = ["front", "isometric", "cavalier", "cabinet", "one-point", "two-point", "three-point"]


def scene_of(*solids: AnySolid, slug: str = "two-point") -> Scene:
    camera = projecting(Camera(look_at=Point3D(0.0, 0.0, 0.0), eye=Point3D(0.0, 0.0, 9.0)), slug, 2.0)
    return Scene(
        tuple(Object(f"o{k}", solid, "m1") for k, solid in enumerate(solids)), (Material("m1"),), (), camera
    )


def measured(scene: Scene) -> Contrast:
    both = contrast(scene)
    assert both is not None
    return both


def row(both: Contrast, feature: str) -> Row:
    return next(each for each in both.rows if each.feature == feature)


def numbers(text: str) -> list[float]:
    return [float(each) for each in re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text.replace("−", "-"))]


def test_units_are_as_long_as_the_course_says() -> None:
    kinds = dict(measured(scene_of(Box())).kinds)
    third = math.sqrt(2 / 3)
    assert kinds["isometric"] == pytest.approx((third, third, third))
    assert kinds["cavalier"] == pytest.approx((1, 1, 1))  # full depth
    assert kinds["cabinet"] == pytest.approx((1, 1, 0.5))  # half depth
    assert kinds["front"] == pytest.approx((1, 1, 0))
    assert kinds["dimetric"][2] == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("slug", "count"), [("front", 8), ("isometric", 0), ("cavalier", 12), ("cabinet", 8), ("two-point", 4)]
)
def test_as_many_edges_of_a_cube_are_in_true_length_as_lie_so(slug: str, count: int) -> None:
    """A cavalier drawing keeps all, although a parallel projection as such does not."""
    both = measured(scene_of(Box(), slug=slug))
    true = row(both, "True dimensions")
    assert numbers(true.parallel)[0] == count
    assert len(true.segments) == count
    assert numbers(true.perspective)[0] == 0


@pytest.mark.parametrize("slug", SLUGS)
def test_parallels_and_middles_stay_in_a_parallel_picture_only(slug: str) -> None:
    both = measured(scene_of(House(), slug=slug))
    assert numbers(row(both, "Parallel lines").parallel)[0] == 0
    assert numbers(row(both, "Parallel lines").perspective)[0] > 1
    assert numbers(row(both, "Ratios along a line").parallel) == [0.5]
    assert abs(numbers(row(both, "Ratios along a line").perspective)[0] - 0.5) > 0.01
    near, far = numbers(row(both, "Size with distance").parallel)
    assert near == far
    near, far = numbers(row(both, "Size with distance").perspective)
    assert near > far


def test_far_things_shrink_with_their_distance() -> None:
    """From (0, 0, 9) with the plane at 5 the box's sides at z = 1 and z = -1 are 8 and 10 away."""
    both = measured(scene_of(Box(), slug="one-point"))
    assert numbers(row(both, "Size with distance").perspective) == pytest.approx([5 / 8, 5 / 10])
    assert numbers(row(both, "Ratios along a line").perspective) == pytest.approx([5 / 9], abs=5e-4)
    assert row(both, "Vanishing points").perspective.startswith("1: z")
    assert row(both, "Vanishing points").parallel == "none"


def test_seen_by_either_projection_the_same_two_are_compared() -> None:
    scene = scene_of(Box(), slug="orthographic")
    both = measured(scene)
    other = measured(replace(scene, camera=both.perspective))
    assert (other.parallel, other.perspective) == (both.parallel, both.perspective)
    assert [each[:-1] for each in other.rows] == [each[:-1] for each in both.rows]


def test_where_nothing_is_before_the_camera_there_is_nothing_to_measure() -> None:
    scene = scene_of(Box())
    assert contrast(replace(scene, objects=())) is None
    assert contrast(replace(scene, camera=replace(scene.camera, near=50.0, far=60.0))) is None
    with pytest.raises(ValueError, match="eye"):
        contrast(replace(scene, camera=replace(scene.camera, eye=scene.camera.look_at)))


def test_what_was_measured_is_on_the_scene() -> None:
    scene = example("space-house").document.sheets[0].scene
    assert scene is not None
    both = measured(scene)
    first, second = row(both, "Parallel lines").segments
    along = [pair[1] - pair[0] for pair in (first, second)]
    assert np.cross(*along) == pytest.approx(np.zeros(3), abs=1e-9)
    for each in both.rows:
        assert each.segments.shape[1:] == (2, 3)
        assert np.isfinite(each.segments).all()
