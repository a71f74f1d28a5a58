"""A list of very many strokes, drawn by the compiled text in one call: the same picture, far sooner."""

import numpy as np
import pytest

from workbench.algorithms.scanning.beam_strokes import beam_strokes
from workbench.display import MmStroke, Phosphor, Tube, VectorBeam, VectorTiming
from workbench.display import vector_beam as module
from workbench.display.blurred_strokes import blur_strokes
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
    for count in (70, 900):
        assert VectorBeam(tube_of(), list_of(count), TIMING).energy_per_frame().any()


@pytest.mark.parametrize("sigma_px", [0.7, 1.1, 3.0])
def test_a_blurred_list_looks_like_that_of_the_text(sigma_px: float) -> None:
    random = np.random.default_rng(3)
    strokes = np.empty((60, 5))
    strokes[:, 0:2] = random.uniform(-5.0, 65.0, (60, 2))  # some of it beyond the face
    strokes[:, 2:4] = strokes[:, 0:2] + random.uniform(-24.0, 24.0, (60, 2)) * random.choice([0, 1], (60, 2))
    strokes[:, 4] = random.uniform(0.2, 1.0, 60) * (0.5 + np.hypot(*(strokes[:, 2:4] - strokes[:, :2]).T))
    exact, blurred = np.zeros((50, 60)), np.zeros((50, 60))
    for _spans in beam_strokes(exact, strokes, sigma_px):
        pass
    blur_strokes(blurred, strokes, sigma_px)
    assert np.abs(blurred - exact).max() < 0.12 * exact.max()
    assert np.abs(blurred - exact).mean() < 0.01 * exact.max()
    assert blurred.sum() == pytest.approx(exact.sum(), rel=5e-3)


def test_a_long_list_takes_no_longer_than_its_dots_before_it_is_compiled(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Not one of many thousands of pieces is added up by itself, whether averaged or played."""

    def by_itself(*arguments: object) -> object:
        singly.append(1)
        assert len(singly) <= 16  # at the ends of the time that is played
        return marks(*arguments)

    singly: list[int] = []
    marks = VectorBeam._marks_of
    monkeypatch.setattr(module, "strokes_ready", lambda: False)
    monkeypatch.setattr(VectorBeam, "_marks_of", by_itself)
    beam = VectorBeam(tube_of(), list_of(5_000), TIMING)
    assert beam.energy_per_frame().sum() > 0.0
    assert singly == []
    beam.play(tube_of(), beam.frame_ps // 3)
    assert "pieces" not in vars(beam), "a value was made of every piece"
