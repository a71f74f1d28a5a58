"""The ideal outline that lies over the pixels."""

import numpy as np
import pytest

from workbench.document.edits import add_figure
from workbench.document.model import Circle, WorldPoint
from workbench.document.samples.examples import blank_sheet, example
from workbench.memory import forget
from workbench.panels.stage.outline import clipped_outlines, figure_at, outline, outlines


def test_the_ideal_circle_has_no_corners_that_are_seen():
    circle = Circle("f1", (WorldPoint("p1", 30.0, 24.0),), "midpoint_circle", radius_world=20.0)
    sheet = add_figure("s1", circle)(blank_sheet(64, 48)).sheets[0]
    (around,) = outline(sheet, sheet.figures[0])
    middles = (around[1:] + around[:-1]) / 2
    assert np.abs(np.hypot(*(middles - (30, 24)).T) - 20).max() < 0.006


def test_a_filled_circle_is_met_within_and_an_outline_only_on_it():
    place = (WorldPoint("p1", 30.0, 24.0),)
    for algorithm, met in (("midpoint_circle", False), ("circle_fill", True)):
        circle = Circle("f1", place, algorithm, radius_world=12.0)
        sheet = add_figure("s1", circle)(blank_sheet(64, 48)).sheets[0]
        assert (figure_at(sheet, 31.0, 25.0, 1.0) is not None) == met
        assert figure_at(sheet, 42.0, 24.0, 1.0) is not None
        assert figure_at(sheet, 50.0, 24.0, 1.0) is None


@pytest.mark.parametrize("make", [outlines, clipped_outlines])
@pytest.mark.parametrize("slug", ["house", "curve-letter", "clip", "view-house"])
def test_outlines_that_are_made_at_once_are_those_of_each_figure(make, slug):
    sheet = example(slug).document.sheets[0]
    forget()
    at_once = make(sheet, sheet.figures)
    forget()
    for figure, curves in zip(sheet.figures, at_once, strict=True):
        (alone,) = make(sheet, [figure])
        assert len(alone) == len(curves)
        assert all(map(np.array_equal, alone, curves))
