"""What is said of a figure that is cut, or left out, before its algorithm begins."""

from msgspec.structs import replace

from workbench.document.model import AnyFigure, Circle, Polygon, Polyline, Rectangle
from workbench.document.samples.figures import document_of, line, points_at, polygon, seed_fill
from workbench.rendering.guard_band import cut_before
from workbench.rendering.raster import figure_calls


def said(figure: AnyFigure, clip: Rectangle | None = None) -> str:
    (sheet,) = document_of("", 40, 30, [figure], clip).sheets
    return cut_before(sheet, sheet.figures[0])


def test_a_line_says_where_its_algorithm_begins() -> None:
    far = line((100_000, 5), (3, 5))
    (sheet,) = document_of("", 40, 30, [far]).sheets
    assert figure_calls(sheet, sheet.figures[0])[0].arguments == (16_424, 5, 3, 5)
    assert said(far) == (
        "This line is cut 16,384 pixels beyond the picture: the algorithm draws it from (16,424; 5) to "
        "(3; 5)."
    )
    assert said(line((16_000, 5), (3, 5))) == ""
    assert said(line((100_000, 5), (99_000, 5))) == (
        "Nothing of this figure comes within 16,384 pixels of the picture."
    )


def test_of_a_polyline_it_is_said_how_much_is_cut() -> None:
    far = Polyline("", points_at((0, 0), (9, 9), (50_000, 9), (50_000, 50)), "bresenham_line", closed=True)
    assert "3 of its 4 segments are cut there" in said(far)


def test_what_a_window_clips_away_is_not_cut_besides() -> None:
    assert said(line((100_000, 5), (3, 5)), Rectangle(0.0, 0.0, 20.0, 20.0)) == ""


def test_a_polygon_says_that_its_corners_are_those_of_the_cut() -> None:
    assert said(polygon([[(2, 1), (8, 1), (5, 7)]], 1, "")) == ""
    far = polygon([[(2, 1), (8_000, 1), (5, 7)]], 1, "")
    assert "more than 256 pixels beyond the picture: it is cut there" in said(far)
    aside: Polygon = polygon([[(7_000, 1), (8_000, 1), (7_000, 7)]], 1, "")
    assert "Nothing of this figure comes within 256 pixels" in said(aside)


def test_a_circle_and_a_seed_that_are_too_far_are_not_drawn() -> None:
    circle = Circle("", points_at((3, 4)), "midpoint_circle", radius_world=9.0)
    assert said(circle) == ""
    assert said(replace(circle, radius_world=100_000.0)).startswith(
        "This figure is not drawn: it reaches 100,000 pixels, and 16,384 is the most."
    )
    assert "not drawn" in said(seed_fill((20_000, 3), 2, 1, ""))
