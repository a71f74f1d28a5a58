"""What is marked and said where a curve meets itself: a touch once, a way back in one sentence."""

import numpy as np
import pytest

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import curve_through
from tests.panels.curves.docked import with_docks
from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.algorithms.marks import Word
from workbench.document.curves.pieces import pieces_of
from workbench.panels.curves.crossings import MOST_PIECES, crossing_marks, crossing_words
from workbench.widgets.canvas.drawing import Marker, PenStroke


def marked(pieces):
    """How many crosses, dashed stretches and words are drawn."""
    drawn = crossing_marks(pieces)
    return tuple(sum(isinstance(each, kind) for each in drawn) for kind in (Marker, PenStroke, Word))


def lines(*places):
    ends = np.array(places, float)
    return Pieces(np.arange(float(len(ends))), np.stack([ends[:-1], ends[1:]], axis=1))


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("spline", ["catmull_rom", "natural_cubic", "cardinal"])
def test_a_way_there_and_back_is_one_stretch_and_one_word(seed, spline):
    """It always goes on to the right, and then back, so that it meets itself nowhere else."""
    heights = np.random.default_rng(seed).uniform(0, 20, 12)
    there = np.column_stack([np.arange(12) * 6.0, heights])
    pieces = pieces_of(curve_through(*np.vstack([there, there[-2::-1]]).tolist(), spline=spline))
    assert marked(pieces) == (0, 1, 1)
    assert crossing_words(pieces).startswith("along itself from u = 0 to")


def test_a_closed_line_of_two_nodes_runs_along_itself():
    path = ((10, 10), (20, 14), (30, 18), (40, 22), (30, 18), (20, 14))
    pieces = pieces_of(curve_through(*path, spline="bezier_path", closed=True))
    assert marked(pieces) == (0, 1, 1)
    assert crossing_words(pieces) == "along itself from u = 0 to 1"


def test_many_stretches_have_one_word():
    """Up and down over a grid of few places, where nearly every line lies on others."""
    walk = np.random.default_rng(3).integers(0, 3, (120, 2)) * 10.0
    pieces = pieces_of(curve_through(*walk.tolist(), degree=1))
    crosses, strokes, words = marked(pieces)
    assert words == 1
    assert crosses + strokes <= 200
    assert crossing_words(pieces) == "100 or more"


def test_branches_that_meet_in_one_place_are_one_mark():
    """Three lines through the middle make three pairs; the corners beside them cross nothing."""
    star = lines((0, 0), (20, 20), (30, 10), (-10, 10), (-20, 30), (10, 30), (10, -10))
    assert marked(star)[0] == 1
    assert crossing_words(star) == "1 place"


@pytest.mark.parametrize("turn", [0.0, 0.4, 2.0])
def test_each_touch_is_one_mark(turn):
    """Twelve arches stand on a line, and touch it with their bottoms."""
    arches = [[(10 * k, 4), (10 * k + 5, -4), (10 * k + 10, 4)] for k in range(12)]
    back = [((120, 4), (140, 2)), ((140, 2), (140, 0)), ((140, 0), (-10, 0))]
    ends = [[a, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), b] for a, b in back]
    turned = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    pieces = Pieces(np.arange(16.0), np.array(arches + ends, float) @ turned.T + (50, 3))
    assert marked(pieces) == (12, 0, 0)


def test_what_is_marked_is_said_beside_the_measures(qtbot):
    loop = ((24.0, 10.0), (58.0, 40.0), (58.0, 10.0), (24.0, 40.0), (22.0, 20.0))
    panel = with_docks(qtbot, curve_through(*loop, spline="catmull_rom"))
    assert "crosses itself" not in panel.beside.insight.words.text()
    panel.beside.insight.boxes["crossings"].click()
    settle()
    assert "<td>1 place</td>" in panel.beside.insight.words.text()


def test_in_very_many_pieces_nothing_is_searched_and_that_is_said(monkeypatch):
    zigzag = [(10.0 + 7 * k % 41, 8.0 + 11 * k % 29) for k in range(MOST_PIECES + 2)]
    few, many = (pieces_of(curve_through(*zigzag[:n], spline="catmull_rom")) for n in (40, len(zigzag)))
    assert len(crossing_marks(few)) > 10
    monkeypatch.setattr(curves, "self_meetings", lambda *_given: pytest.fail("takes seconds"))
    assert crossing_marks(many) == []
    assert crossing_words(many) == "not searched for above 300 pieces"
