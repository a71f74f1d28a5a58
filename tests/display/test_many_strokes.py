"""A list of very many strokes, drawn by the compiled text in one call: the same picture, far sooner."""

import numpy as np
import pytest

from workbench.display import MmStroke, Phosphor, Tube, VectorBeam, VectorTiming
from workbench.display import vector_beam as module
from workbench.engine import compiled

TIMING = VectorTiming.named("teaching")


@pytest.fixture
def interpreted(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if the text were compiled and loaded, run as Python: the same text, without a compilation."""
    monkeypatch.setattr(module, "strokes_ready", lambda: True)


def list_of(count: int) -> list[MmStroke]:
    """Strokes from everywhere to near by, brighter and darker."""
    random = np.random.default_rng(7)
    begins = random.uniform(4.0, 36.0, (count, 2))
    ends = begins + random.uniform(-4.0, 4.0, (count, 2))
    currents = random.choice([0.25, 1.0], count)
    return [
        MmStroke(tuple(a), tuple(b), (c,))
        for a, b, c in zip(begins.tolist(), ends.tolist(), currents.tolist(), strict=True)
    ]


def tube_of() -> Tube:
    """A face of 40 mm with a spot of a millimetre."""
    return Tube((40, 40), (40.0, 40.0), [Phosphor.named("P31")], spot_mm=1.0)


@pytest.fixture
def exact() -> np.ndarray:
    """What 90 strokes leave, patch by patch."""
    return np.array(VectorBeam(tube_of(), list_of(90), TIMING).energy_per_frame())


def test_a_picture_of_many_strokes_is_that_of_its_patches(exact: np.ndarray, interpreted: None) -> None:
    at_once = VectorBeam(tube_of(), list_of(90), TIMING).energy_per_frame()
    assert np.abs(at_once - exact).max() < 0.01 * exact.max()
    assert at_once.sum() == pytest.approx(exact.sum(), rel=5e-3)


@pytest.mark.parametrize("frames", [0.3, 1.0, 2.5])
def test_what_is_played_of_many_strokes_glows_as_stroke_by_stroke(
    frames: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same time on two tubes: every stroke exact, and all that are over at once."""
    tubes = []
    for at_once in (False, True):
        monkeypatch.setattr(module, "strokes_ready", lambda ready=at_once: ready)
        tube = tube_of()
        beam = VectorBeam(tube, list_of(90), TIMING)
        beam.play(tube, int(frames * beam.list_ps))
        tubes.append(tube)
    exact, fast = tubes
    for term in range(len(exact.stored[0])):
        scale = exact.stored[0][term].max()
        assert np.abs(exact.stored[0][term] - fast.stored[0][term]).max() < 0.02 * scale
    assert fast.deposited_energy() == pytest.approx(exact.deposited_energy(), rel=5e-3)
    assert fast.emitted_energy() == pytest.approx(exact.emitted_energy(), rel=1e-2)


def test_nothing_is_compiled_on_the_way(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_arguments: object, **_named: object) -> None:
        raise AssertionError("the compiled text was asked for")

    monkeypatch.setattr(module, "strokes_ready", lambda: False)
    monkeypatch.setattr(compiled, "paint", refuse)
    assert VectorBeam(tube_of(), list_of(70), TIMING).energy_per_frame().any()
