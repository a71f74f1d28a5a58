"""The texts on scanning, and that the tube does as they say."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.scanning.beam_spot import beam_spot
from workbench.algorithms.scanning.operations import DRAW, JUMP, MOVE
from workbench.algorithms.scanning.phosphor_decay import phosphor_decay
from workbench.algorithms.scanning.random_scan import random_scan
from workbench.algorithms.scanning.raster_scan import raster_scan
from workbench.display import Phosphor, RasterBeam, RasterTiming, Tube
from workbench.engine.observation import Step, Steps
from workbench.engine.recorder import record

P31 = Phosphor.named("P31")
pictures = (
    st.integers(1, 9)
    .flatmap(lambda w: st.lists(st.lists(st.integers(0, 2), min_size=w, max_size=w), min_size=1, max_size=7))
    .map(np.array)
)


def steps_of(slug: str, *arguments) -> list[Step]:
    """The steps of a text with a row of its hand table."""
    entry = catalogue.get(slug)
    return [step for step in Steps(entry, record(entry.function, *arguments)) if step.row]


NO_TABLE = np.empty(0, np.int64)
blanks = st.integers(0, 5)
fields = st.integers(1, 2)


def order_of_rows(height: int, count: int) -> list[int]:
    """The rows from the top as a frame of so many fields shows them."""
    return [line for field in range(count) for line in range(height) if line % count == field]


@given(pictures, blanks, blanks, fields)
@settings(max_examples=25, deadline=None)
def test_each_line_of_a_raster_takes_its_clocks_whatever_the_picture(image, h_blank, v_blank, count) -> None:
    height, width = image.shape
    arguments = image, NO_TABLE, h_blank, v_blank, count, 8.0, 6.0
    rows = [step.row for step in steps_of("raster_scan", *arguments)]
    shown = [row[1] for row in rows]
    assert shown == order_of_rows(height, count)
    starts = [row[4] // (width + h_blank) for row in rows]
    second = (height + v_blank + 1) // 2
    assert starts == [k // count + (second if k % count else 0) for k in shown]
    assert all(row[4] % (width + h_blank) == 0 for row in rows)
    entry = catalogue.get("raster_scan")
    last = list(Steps(entry, record(entry.function, *arguments)))[-1]
    frame = (width + h_blank) * (height + v_blank)
    assert "".join(part.text for part in last.sentence).endswith(f"lines took {frame} clocks.")


@given(pictures, blanks, blanks)
def test_a_raster_visits_each_lit_pixel_once_in_reading_order(image, h_blank, v_blank) -> None:
    visited = list(raster_scan(image, NO_TABLE, h_blank, v_blank, 1, 8.0, 6.0))
    rows, columns = np.nonzero(image[::-1])
    height = len(image)
    assert visited == [(x, height - 1 - r) for r, x in zip(rows.tolist(), columns.tolist(), strict=True)]


@given(pictures, blanks, blanks)
def test_two_fields_show_every_second_line_and_then_the_others(image, h_blank, v_blank) -> None:
    visited = list(raster_scan(image, NO_TABLE, h_blank, v_blank, 2, 8.0, 6.0))
    height, width = image.shape
    expected = [
        (x, height - 1 - line)
        for line in order_of_rows(height, 2)
        for x in range(width)
        if image[height - 1 - line, x]
    ]
    assert visited == expected


@given(pictures, st.lists(st.sampled_from([0, 1, 0xFF00, 0xFFFFFF]), max_size=4))
def test_what_the_table_makes_black_stays_dark(image, table) -> None:
    """An entry of the table decides; bits for which it has none are a colour themselves."""
    visited = set(raster_scan(image, np.array(table, np.int64), 0, 0, 1, 8.0, 6.0))
    for (y, x), bits in np.ndenumerate(image):
        colour = table[bits] if bits < len(table) else bits
        assert ((x, y) in visited) == (colour != 0)


@given(pictures, fields)
@settings(max_examples=25, deadline=None)
def test_the_raster_tube_scans_in_the_order_of_the_text(image, count) -> None:
    height, width = image.shape
    timing = replace(RasterTiming.synthesised(width, height, 60), interlaced=count == 2)
    tube = Tube((8, 8), (float(width), float(height)), [P31], spot_mm=0.5)
    beam = RasterBeam(tube, timing, (image > 0)[None].astype(float), (0.0, 0.0, float(width), float(height)))
    lit = []
    for clock in range(timing.clocks_per_frame):
        state = beam.state((clock + Fraction(1, 2)) / timing.pixel_clock_hz)
        if any(state.currents):
            lit.append((math.floor(state.x_mm), math.floor(state.y_mm)))
    assert lit == list(raster_scan(image, NO_TABLE, 0, 0, count, 8.0, 6.0))


def program(strokes: list[tuple[float, ...]]) -> np.ndarray:
    """MOVE, DRAW and JUMP for strokes (x0, y0, x1, y1), with a MOVE before each of them."""
    rows = [row for x0, y0, x1, y1 in strokes for row in ([MOVE, x0, y0, 0.0], [DRAW, x1, y1, 1.0])]
    return np.array([*rows, [JUMP, *strokes[-1][2:], 0.0]] if rows else [], float).reshape(-1, 4)


@given(
    st.lists(st.tuples(*[st.integers(0, 60)] * 4), max_size=6), *[st.sampled_from([0.0, 0.25, 1.0, 3.0])] * 3
)
def test_the_time_of_a_list_is_that_of_its_jumps_settles_and_strokes(
    strokes, pace, jump_pace, settle
) -> None:
    """Reckoned from the ends alone: the longer axis counts, and where the beam is it need not jump."""
    numbers = 1.0, 0.0, 0.0, pace, 0.0, jump_pace, settle, 0.0, 0.0
    assert list(random_scan(program(strokes), *numbers)) == strokes
    time, at = 0.0, tuple(strokes[-1][2:]) if strokes else ()
    rows = [step.row for step in steps_of("random_scan", program(strokes), *numbers)]
    for k, (x0, y0, x1, y1) in enumerate(strokes):
        if at != (x0, y0):
            time += max(abs(x0 - at[0]), abs(y0 - at[1])) * jump_pace + settle
        time += max(abs(x1 - x0), abs(y1 - y0)) * pace
        at = (x1, y1)
        assert rows[2 * k + 1][-1] == pytest.approx(time)


places = st.tuples(st.floats(12.0, 28.0), st.floats(12.0, 28.0))


@given(places, places, st.floats(0.7, 2.0))
@settings(max_examples=40, deadline=None)
def test_the_tube_deposits_what_the_text_says(a, b, sigma) -> None:
    tube = Tube((40, 40), (40.0, 40.0), [P31], spot_mm=sigma, reach=4.0)
    tube.deposit_stroke(a, b, 1.0)
    energy = tube.stored[0][0] * P31.terms[0].tau_s / P31.energy_fractions[0]
    text = np.zeros((40, 40))
    # Pixel 0 of the face has its centre at 0.5 mm.
    for x, y, share in beam_spot(a[0] - 0.5, a[1] - 0.5, b[0] - 0.5, b[1] - 0.5, 1.0, sigma):
        text[y, x] = share
    both = (text > 0) & (energy > 0)
    assert abs(energy - text)[both].max() < 1e-12
    assert abs(text.sum() - 1.0) < 4.0 * math.exp(-2.0 * math.pi**2 * sigma**2) + 1.3e-4


@given(st.floats(0.01, 20.0), st.integers(1, 30))
def test_decay_is_the_same_in_one_step_and_in_many(dt: float, steps: int) -> None:
    terms = np.array([[term.weight, term.tau_s * 1e3] for term in P31.terms])
    many = list(phosphor_decay(terms, dt, steps))
    one = list(phosphor_decay(terms, dt * steps, 1))
    assert len(many) == steps + 1
    assert math.isclose(many[-1][1], one[-1][1], rel_tol=1e-11, abs_tol=1e-300)
    for t, light in many:
        assert math.isclose(light, P31.intensity(t * 1e-3), rel_tol=1e-11, abs_tol=1e-300)


@given(st.floats(0.01, 20.0), st.integers(1, 12))
@settings(max_examples=25, deadline=None)
def test_what_was_given_off_and_what_is_stored_make_the_energy_of_the_hit(dt: float, count: int) -> None:
    terms = np.array([[term.weight, term.tau_s * 1e3] for term in P31.terms])
    steps = steps_of("phosphor_decay", terms, dt, count)
    assert len(steps) == count
    for step in steps:
        _k, _t, _light, emitted, stored = step.row
        assert math.isclose(emitted + stored, terms.prod(axis=1).sum(), rel_tol=1e-11)


@pytest.mark.parametrize("name", ["P1", "P31"])
def test_the_tube_fades_as_the_text_says(name: str) -> None:
    phosphor = Phosphor.named(name)
    tube = Tube((1, 1), (1.0, 1.0), [phosphor])
    tube.deposit(np.ones((1, 1)))
    start = tube.luminance().sum()
    terms = np.array([[term.weight, term.tau_s] for term in phosphor.terms])
    for t, light in phosphor_decay(terms, 1e-3, 8):
        tube.advance((Fraction(t).limit_denominator(1000) - tube.seconds) * 10**12)
        assert math.isclose(tube.luminance().sum() / start, light, rel_tol=1e-9)
