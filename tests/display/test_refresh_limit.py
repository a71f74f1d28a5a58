"""How many lines there are until it flickers: asked line by line, and by the formula."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display import Phosphor, VectorTiming, phosphor_names, vector_displays
from workbench.display.flicker import critical_frequency_hz, modulation
from workbench.display.list_time import list_time
from workbench.display.refresh_limit import EYE_CD_M2, LineTime, longest_steady_s
from workbench.rendering.display_program import equal_lines, program_of

SIZE = (64, 48)


def flickers(guns: tuple[Phosphor, ...], period_s: float) -> bool:
    """Asked at this rate alone: whether the light, as it is modulated then, would have to come more often."""
    strongest = max(modulation(gun, period_s) for gun in guns)
    return 1.0 / period_s < critical_frequency_hz(EYE_CD_M2, strongest)


@pytest.mark.parametrize("name", phosphor_names())
def test_the_longest_steady_time_parts_steady_from_flickering(name: str) -> None:
    guns = (Phosphor.named(name),)
    longest = longest_steady_s(guns)
    assert not math.isnan(longest)
    if math.isinf(longest):
        assert not flickers(guns, 10.0)
    else:
        assert longest > 1e-3
        assert not flickers(guns, longest * (1 - 1e-9))
        assert flickers(guns, longest * (1 + 1e-9))


@pytest.mark.parametrize("display", vector_displays())
@pytest.mark.parametrize("name", ["P1", "P31", "P39"])
@given(length=st.integers(2, 60), refresh=st.sampled_from([60, 75, 120]))
@settings(max_examples=8, deadline=None)
def test_dragged_line_by_line_and_by_formula_it_is_the_same(display, name, length, refresh) -> None:
    """The greatest n whose list, timed instruction by instruction, is steady: found by halving."""
    guns, timing, units = (Phosphor.named(name),), VectorTiming.named(display), 14.4
    shortest = timing.shortest_frame_ps(refresh)
    line = LineTime.of(timing, length * units)

    def steady(lines: int) -> bool:
        program = program_of(equal_lines(lines, float(length), SIZE))
        return not flickers(guns, list_time(program.rows, units, timing, shortest).frame_ps * 1e-12)

    most = line.most_lines(longest_steady_s(guns), shortest)
    assert most is not None
    low, high = 0, 2 * most + 4
    assert not steady(high)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if steady(middle) else (low, middle)
    # Rounding to whole picoseconds is all that may lie between them
    assert low == most or (abs(low - most) == 1 and most > 2000)


def test_the_exam_sum() -> None:
    """Lines of 1000 units at 0.1 us a unit, as much for the jump, 5 us to settle: 205 us each."""
    timing = VectorTiming.own(0.0, 0.1, 0.1, 5.0)
    line = LineTime.of(timing, 1000.0)
    assert line.total_ps == 205_000_000
    assert line.most_lines(1 / 50, 0) == 97  # 20 ms over 205 us
    assert line.most_lines(1 / 50, 25_000_000_000) == 0
    assert line.most_lines(math.inf, 0) is None
    assert line.frame_ps(97, 0) == 97 * 205_000_000


def test_an_empty_list_takes_the_shortest_frame() -> None:
    time = list_time(np.empty((0, 4)), 1.0, VectorTiming.named("teaching"), 7)
    assert (time.frame_ps, time.list_ps, len(time.each_ps)) == (7, 0, 0)
