"""The radii of a figure are told and set by its kind."""

from workbench.document.model import Circle, Ellipse
from workbench.document.samples.figures import line, points_at

ROUND = Circle("c", points_at((1, 2)), "midpoint_circle", radius_world=3.0)
LONG = Ellipse("e", points_at((1, 2)), "midpoint_ellipse", radius_x_world=3.0, radius_y_world=5.0)


def test_each_kind_tells_its_radii_and_takes_others():
    assert ROUND.radii_world == (3.0, 3.0)
    assert ROUND.with_radii(4.0, 7.0).radius_world == 4.0
    assert LONG.radii_world == (3.0, 5.0)
    assert LONG.with_radii(4.0, 7.0).radii_world == (4.0, 7.0)


def test_a_figure_without_radii_has_none_and_stays():
    straight = line((0, 0), (3, 4))
    assert straight.radii_world == (0.0, 0.0)
    assert straight.with_radii(1.0, 2.0) is straight
