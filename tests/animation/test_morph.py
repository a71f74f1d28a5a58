"""Morphing against the course's rule for edges, counted and compared with shapely."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from shapely import LinearRing, LineString, Point

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.animation import morph
from workbench.engine.recorder import record

runs = arguments(catalogue.get("morph"))
Run = tuple[Any, ...]


def at(run: Run, t: float) -> np.ndarray:
    return np.array(list(morph(*run[:4], t)))


def edges(outline: np.ndarray, closed: bool) -> int:
    return len(outline) if closed else len(outline) - 1


@settings(max_examples=25)
@given(run=runs)
def test_at_its_ends_a_morph_is_the_keys(run: Run) -> None:
    """Every vertex of the key is one of its own, in order, and the others lie on the key's edges."""
    first, second, closed, shift, _t = run
    turned = np.roll(second, -(shift % len(second)), axis=0) if closed else second
    for outline, key in ((at(run, 0.0), first), (at(run, 1.0), turned)):
        corners = iter(outline.tolist())
        assert all(corner in corners for corner in key.tolist())
        if closed and len(key) > 2:
            line = LinearRing(key)
        else:
            line = LineString([*key, key[0]] if closed else key)
        for corner in outline:
            assert line.distance(Point(corner)) <= 1e-9


@settings(max_examples=25)
@given(run=runs)
def test_edges_are_shared_by_the_rule_of_the_course(run: Run) -> None:
    first, second, closed, *_rest = run
    most = max(edges(first, closed), edges(second, closed))
    fewest = min(edges(first, closed), edges(second, closed))
    simpler = first if edges(first, closed) == fewest else second
    t = 0.0 if simpler is first else 1.0
    # Along the simpler outline, with corners where its own vertices are
    outline = at((first, np.asarray(second), closed, 0, t), t)
    ring = [*outline.tolist(), outline[0].tolist()] if closed else outline.tolist()
    assert len(ring) - 1 == most
    pieces = [most // fewest + (edge < most % fewest) for edge in range(fewest)]
    ends = [*simpler.tolist(), simpler[0].tolist()] if closed else simpler.tolist()
    assert sum(pieces) == most
    start = 0
    for (a, b), count in zip(pairwise(ends), pieces, strict=True):
        np.testing.assert_allclose(ring[start : start + count + 1], np.linspace(a, b, count + 1), atol=1e-9)
        start += count


def test_five_edges_into_thirteen() -> None:
    entry = catalogue.get("morph")
    recording = record(entry.function, *entry.example)
    after = recording.after(len(recording) - 1)
    assert (after["first_edges"], after["second_edges"]) == (5, 13)
    assert (after["extra"], after["pieces"]) == (3, 2)


@settings(max_examples=25)
@given(run=runs)
def test_every_vertex_moves_evenly_on_a_line(run: Run) -> None:
    start, end, t = at(run, 0.0), at(run, 1.0), run[4]
    closed = run[2]
    assert len(start) == max(len(run[0]), len(run[1]))
    assert len(start) == max(edges(run[0], closed), edges(run[1], closed)) + (not closed)
    np.testing.assert_allclose(at(run, t), start + t * (end - start), atol=1e-9)


def test_an_outline_of_one_vertex_is_refused() -> None:
    with pytest.raises(ValueError, match="two vertices"):
        list(morph(np.array([[1.0, 1.0]]), np.array([[0.0, 0], [1, 0], [0, 1]]), True, 0, 0.5))
