"""The path of a figure over all frames is where every single frame has it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.document.motion.moving import HOUSE, keyed_numbers, sheet_of, still, track, with_tracks
from workbench.document.model import AnyFigure, Sheet
from workbench.document.motion.evaluation import at
from workbench.document.motion.model import Track
from workbench.document.motion.tracks import motion_of
from workbench.document.samples.examples import example
from workbench.panels.animate.path import alone, path_of
from workbench.rendering import figure_map

HOUSE_NOW = tuple(number for corner in HOUSE for number in corner)


def one_by_one(sheet: Sheet, figure: AnyFigure, point: str) -> list[tuple[float, float]]:
    """The path by frames worked out singly."""
    places = []
    for frame in range(motion_of(sheet).frames):
        seen = at(sheet, frame)
        now = next(each for each in seen.figures if each.id == figure.id)
        chosen = [(each.x, each.y) for each in now.points_world if not point or each.id == point]
        x, y = np.mean(np.array(chosen), axis=0).tolist()
        places.append(figure_map(seen, now).point(x, y))
    return places


@pytest.mark.parametrize("slug", ["animate-ball", "animate-letter", "animate-clock", "animate-pendulum"])
def test_in_the_examples(slug: str) -> None:
    sheet = example(slug).document.sheets[0]
    for figure in sheet.figures:
        for point in ("", figure.points_world[0].id):
            path = path_of(alone(sheet, figure), point)
            np.testing.assert_allclose(path, one_by_one(sheet, figure, point), rtol=1e-12, atol=1e-9)


@given(keyed_numbers(), st.booleans())
def test_of_any_track(own: Track, outlined: bool) -> None:
    later = tuple(number + 5.0 for number in HOUSE_NOW)
    far = track(
        "f1/p1/y", (0, (5.0,)), (9, (2e7,)), (20, (1.0,)), easing="spline"
    )  # beyond what a place may be
    moved = track("f2/points_world", (3, HOUSE_NOW), (17, later), easing="ease_in")
    sheet = sheet_of(own, far, *([moved] if outlined else []))
    for figure in sheet.figures:
        path = path_of(alone(sheet, figure))
        np.testing.assert_allclose(path, one_by_one(sheet, figure, ""), rtol=1e-12, atol=1e-9)


def test_where_nothing_moves_it_stays() -> None:
    sheet = with_tracks(still(), track("f1/radius_world", (0, (1.0,)), (9, (3.0,)))).sheets[0]
    assert not np.ptp(path_of(alone(sheet, sheet.figures[0])), axis=0).any()


def test_of_a_million_frames_a_few_hundred_are_looked_at() -> None:
    tracks = [track("f1/p1/x", (0, (1.0,)), (999_999, (31.0,)))]
    sheet = with_tracks(still(), *tracks, frames=1_000_000).sheets[0]
    path = path_of(alone(sheet, sheet.figures[0]))
    assert 300 <= len(path) <= 600
    assert path[-1][0] == pytest.approx(31.0, abs=0.1)
