"""The four relations of a surface to a square, and what area subdivision paints."""

import numpy as np

from tests.visibility.exact_scenes import HEIGHT, KINDS, WIDTH, arrays, at, piercing, scenes
from workbench.algorithms.visibility import area_subdivision
from workbench.algorithms.visibility.squares import INSIDE, OUTSIDE, SURROUNDING, Square, relation
from workbench.algorithms.visibility.surfaces import covers, in_view, surfaces_of


def test_each_pixel_is_painted_once() -> None:
    for kind in KINDS:
        for scene in scenes(kind, 12):
            image = np.zeros((HEIGHT, WIDTH), np.int64)
            painted = [
                (x, y)
                for y, left, right, _surface in area_subdivision(image, *arrays(scene))
                for x in range(left, right + 1)
            ]
            covered = [(x, y) for y in range(HEIGHT) for x in range(WIDTH) if at(scene, x, y)]
            assert sorted(painted) == sorted(covered)


def test_the_relations_hold_at_every_pixel() -> None:
    """Also whether an inside one is covered nowhere else. Area subdivision stops by them."""
    seen = set()
    for scene in scenes(piercing, 40):
        surfaces = surfaces_of(*arrays(scene)[:2])
        for surface in (surfaces[number] for number in in_view(surfaces)):
            for size in (1, 4, 8):
                for x in range(0, 16, size):
                    square = Square(x, size, size, [])
                    centres = [(x + i, size + j) for i in range(size) for j in range(size)]
                    covered = [covers(surface, *centre) for centre in centres]
                    lies = relation(surface, square)
                    seen.add(lies)
                    if lies == SURROUNDING:
                        assert all(covered)
                    elif lies == OUTSIDE:
                        assert not any(covered)
                    elif lies == INSIDE:
                        elsewhere = {(i, j) for i in range(-3, 20) for j in range(-3, 20)} - set(centres)
                        assert not any(covers(surface, *centre) for centre in elsewhere)
                    if all(covered):
                        assert lies == SURROUNDING
    assert len(seen) == 4
