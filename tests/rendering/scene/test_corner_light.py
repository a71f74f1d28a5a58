"""The light of all corners at once is that of the text, point by point."""

from random import Random

import numpy as np
import pytest

from workbench.algorithms.shading.illumination import corner_lights
from workbench.algorithms.shading.model_parameters import lit_point
from workbench.rendering.scene.corner_light import corner_light


@pytest.mark.parametrize("by_halfway", [False, True], ids=["V.R", "N.H"])
def test_it_is_the_light_of_the_text(by_halfway: bool) -> None:
    """Lights in the point itself, behind it and far away, normals that are 0."""
    for number in range(60):
        chance = Random(number)
        _place, _normal, eye, lights, _material, *_rest = lit_point(chance)
        points = [lit_point(chance) for _point in range(8)]
        places, normals, materials = (np.array([point[k] for point in points]) for k in (0, 1, 4))
        given = places, normals, materials, eye, lights, by_halfway
        text = np.array(list(corner_lights(*given, np.zeros((0, 3)))))[:, 0]
        assert corner_light(*given) == pytest.approx(text, abs=1e-12)
