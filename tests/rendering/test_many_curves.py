"""What is made of thousands of curves is made at once, and is what each curve has alone."""

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.algorithms import curves as texts
from workbench.document.model import Circle, Curve, CurvePoint, Line, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.memory import forget
from workbench.panels.stage import outline as outlining
from workbench.rendering import curves
from workbench.rendering.curves import polyline_of, polylines_of

SPLINES = "bezier_path", "bezier", "b_spline", "nurbs", "catmull_rom", "natural_cubic", "cardinal"


def curve(number, spline="bezier_path", count=4):
    places = np.random.default_rng(number).uniform(0, 40, (count, 2)).tolist()
    points = tuple(CurvePoint(f"p{number}_{k}", x, y) for k, (x, y) in enumerate(places))
    return Curve(f"f{number}", points, "bresenham_line", spline=spline)


def sheet_of(figures):
    return replace(blank_sheet().sheets[0], figures=tuple(figures))


@pytest.fixture(autouse=True)
def nothing_kept():
    forget()


def test_chains_of_many_curves_are_those_of_each():
    figures = [curve(k, SPLINES[k % 7], 1 + k % 9) for k in range(120)]
    figures += [replace(curve(200 + k), tolerance_px=0.01) for k in range(5)]
    sheet = sheet_of(figures)
    together = polylines_of(sheet, figures)
    forget()
    for figure, chain in zip(figures, together, strict=True):
        assert np.array_equal(chain, polyline_of(sheet, figure))


def test_chains_of_more_chords_than_are_made_at_once(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("workbench.geometry.curves.polyline._AT_ONCE", 40)
    controls = np.random.default_rng(1).uniform(0, 40, (30, 2, 4, 2))
    every = [texts.Pieces(np.arange(3.0), each) for each in controls]
    together = texts.polylines(every, 0.1)
    assert sum(map(len, together)) > 200
    for pieces, chain in zip(every, together, strict=True):
        assert np.array_equal(chain, texts.polyline(pieces, 0.1))


def test_curves_that_touch_are_not_joined():
    one = np.array([[[0.0, 0.0], [1.0, 4.0], [3.0, 4.0], [5.0, 0.0]]])
    other = one + np.array([5.0, 0.0])
    first, second = texts.polylines([texts.Pieces(np.arange(2.0), each) for each in (one, other)], 0.1)
    assert first[-1].tolist() == second[0].tolist() == [5.0, 0.0]


def test_one_changed_curve_of_many_is_made_alone(monkeypatch: pytest.MonkeyPatch):
    made, really = [], texts.polylines

    def counted(several, tolerance):
        made.append(len(several))
        return really(several, tolerance)

    figures = [curve(k) for k in range(300)]
    monkeypatch.setattr(curves.curves, "polylines", counted)
    polylines_of(sheet_of(figures), figures)
    assert made == [300]
    figures[7] = curve(1000)
    polylines_of(sheet_of(figures), figures)
    assert made == [300, 1]


def test_outlines_of_many_figures_are_made_at_once_and_are_those_of_each(monkeypatch: pytest.MonkeyPatch):
    calls, really = [], outlining.seen_segments

    def counted(sheet, flatness):
        calls.append(len(sheet.figures))
        return really(sheet, flatness)

    monkeypatch.setattr(outlining, "seen_segments", counted)
    figures = [curve(k) for k in range(30)]
    figures.append(Circle("c", (WorldPoint("cp", 20.0, 15.0),), "midpoint_circle", radius_world=9.0))
    figures.append(Line("l", (WorldPoint("l0", -500.0, 3.0), WorldPoint("l1", 4.0, 5.0)), "bresenham_line"))
    figures.append(Line("out", (WorldPoint("o0", 1e6, 1e6), WorldPoint("o1", 1e6, 2e6)), "bresenham_line"))
    sheet = sheet_of(figures)
    together = outlining.outlines(sheet, figures)
    assert calls == [33]
    forget()
    for figure, lines in zip(figures, together, strict=True):
        alone = outlining.outline(sheet, figure)
        assert len(alone) == len(lines)
        assert all(map(np.array_equal, alone, lines))
