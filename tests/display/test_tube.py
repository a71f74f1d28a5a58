"""Energy, decay and time: nothing is lost, and how time is cut does not matter."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import special

from workbench.display import Phosphor, Tube
from workbench.display.error_function import erf, erfc_scaled
from workbench.display.spot import across_rows, along_row

P31 = Phosphor.named("P31")
SECOND = 10**12
places = st.tuples(st.floats(20.0, 40.0), st.floats(20.0, 40.0))


def tube(phosphor: Phosphor = P31, spot: float = 1.0) -> Tube:
    return Tube((60, 60), (60.0, 60.0), [phosphor], spot_mm=spot)


@given(st.floats(-30.0, 30.0))
def test_error_function_is_that_of_scipy(x: float) -> None:
    at = np.array([x])
    assert abs(erf(at)[0] - special.erf(x)) < 1e-15
    if x > -20.0:
        assert math.isclose(erfc_scaled(at)[0], special.erfcx(x), rel_tol=1e-12)


@given(places, places, st.floats(0.7, 2.0), st.floats(0.1, 10.0))
@settings(max_examples=60)
def test_a_stroke_leaves_all_its_energy(a, b, spot, energy) -> None:
    face = tube(spot=spot)
    face.deposit_stroke(a, b, energy)
    sampling = 4.0 * math.exp(-2.0 * math.pi**2 * spot**2)
    assert abs(face.deposited_energy() - energy) <= energy * (sampling + 1.3e-4)


@given(st.floats(5.0, 20.0), st.floats(0.5, 30.0), st.floats(0.05, 2.0))
def test_rows_integrated_over_the_pixels_leave_all_their_energy(start, length, spot) -> None:
    edges = np.linspace(-20.0, 80.0, 101)
    along = along_row(np.array([start, start + length]), edges, spot)
    across = across_rows(np.array([25.3]), edges, spot)
    assert abs((across @ along.T).sum() - 1.0) < 1e-12
    assert along.min() > -1e-12


@given(places, places, st.floats(0.05, 0.95), st.sampled_from([0, 10**6, 3 * 10**8, 10**10]))
@settings(max_examples=60, deadline=None)
def test_a_stroke_may_be_cut_anywhere(a, b, share, ticks) -> None:
    c = a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])
    length = math.dist(a, b)
    if min(share, 1.0 - share) * length < 0.5:
        return
    whole, cut = tube(), tube()
    whole.deposit_stroke(a, b, 1.0, ticks)
    first = math.dist(a, c) / length
    cut.deposit_stroke(a, c, first, Fraction(ticks) * Fraction(first))
    cut.deposit_stroke(c, b, 1.0 - first, ticks - Fraction(ticks) * Fraction(first))
    assert cut.ticks == whole.ticks
    assert abs(whole.stored[0] - cut.stored[0]).max() <= 1e-12 * whole.stored[0].max()
    assert abs(whole.exposure()[0] - cut.exposure()[0]).max() < 1e-12


@given(places, places)
def test_a_stroke_drawn_backwards_leaves_the_same(a, b) -> None:
    there, back = tube(), tube()
    there.deposit_stroke(a, b, 1.0)
    back.deposit_stroke(b, a, 1.0)
    assert abs(there.stored[0] - back.stored[0]).max() <= 1e-12 * there.stored[0].max()


def test_a_short_stroke_joins_the_dwell() -> None:
    dwell = tube()
    dwell.deposit_stroke((30.2, 30.1), (30.2, 30.1), 1.0)
    for length, allowed in ((0.1, 1e-3), (2e-4, 1e-8), (0.9e-4, 1e-8)):
        stroke = tube()
        stroke.deposit_stroke((30.2 - length / 2, 30.1), (30.2 + length / 2, 30.1), 1.0)
        assert abs(dwell.stored[0] - stroke.stored[0]).max() < allowed * dwell.stored[0].max()


@given(places, places, st.floats(-8.0, -2.3))
@settings(max_examples=25, deadline=None)
def test_decay_during_a_stroke_is_the_integral_over_its_moments(a, b, magnitude) -> None:
    if math.dist(a, b) < 1.0:
        return
    seconds = 10.0**magnitude
    face = tube()
    face.deposit_stroke(a, b, 1.0, Fraction(seconds) * SECOND)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    panels = 8
    expected = np.zeros_like(face.stored[0])
    columns, rows = np.arange(60) + 0.5, np.arange(60) + 0.5
    for panel in range(panels):
        for node, weight in zip(nodes, weights, strict=True):
            u = (panel + 0.5 + 0.5 * node) / panels
            x, y = a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1])
            spot = np.exp(-0.5 * (rows - y) ** 2)[:, None] * np.exp(-0.5 * (columns - x) ** 2)
            for k, (term, share) in enumerate(zip(P31.terms, P31.energy_fractions, strict=True)):
                left = math.exp(-seconds * (1.0 - u) / term.tau_s) * share / term.tau_s
                expected[k] += spot * (weight / panels * left / (4.0 * math.pi))
    assert abs(face.stored[0] - expected).max() < 1e-8 * expected.max()
    assert abs(face.emitted_energy() + face.stored_energy() - face.deposited_energy()) < 1e-12


@given(st.floats(0.1, 1.0), st.floats(0.5, 3.0))
def test_energy_is_proportional(energy, factor) -> None:
    one, more = tube(), tube()
    one.deposit_stroke((20, 20), (40, 33), energy)
    more.deposit_stroke((20, 20), (40, 33), energy * factor)
    assert np.allclose(more.stored[0], factor * one.stored[0], rtol=1e-12, atol=0.0)


@pytest.mark.parametrize("steps", [1, 7, 10_000])
def test_decay_is_exact_for_any_steps(steps: int) -> None:
    face = Tube((2, 2), (2.0, 2.0), [P31])
    face.deposit(np.ones((2, 2)))
    before = face.stored[0].copy()
    total = 3 * 10**9
    for _ in range(steps):
        face.advance(Fraction(total, steps))
    assert face.ticks == total
    for k, term in enumerate(P31.terms):
        expected = before[k] * math.exp(-0.003 / term.tau_s)
        assert np.allclose(face.stored[0][k], expected, rtol=2e-12, atol=0.0)


@given(st.lists(st.tuples(st.sampled_from(["hit", "wait"]), st.integers(1, 10**10)), max_size=40))
@settings(deadline=None)
def test_what_was_deposited_is_emitted_or_still_stored(events) -> None:
    face = tube(Phosphor.named("P7"))
    for what, amount in events:
        if what == "hit":
            face.deposit_stroke((20.0 + amount % 7, 25.0), (30.0, 22.0), amount * 1e-9, amount)
        else:
            face.advance(amount)
            face.exposure()
    deposited = face.deposited_energy()
    assert abs(face.stored_energy() + face.emitted_energy() - deposited) <= 1e-12 * max(deposited, 1e-12)


@pytest.mark.parametrize("name", ["P1", "P4", "P7", "P31", "P22G"])
def test_hits_superpose_and_commute(name: str) -> None:
    phosphor = Phosphor.named(name)
    a, b, both, swapped = (tube(phosphor) for _ in range(4))
    a.deposit_stroke((22, 22), (30, 31), 1.0)
    for face in (a, b, both, swapped):
        if face is both:
            face.deposit_stroke((22, 22), (30, 31), 1.0)
        if face is swapped:
            face.deposit_stroke((22, 22), (30, 31), 1.0)
        face.advance(5 * 10**8)
        if face is b or face is both or face is swapped:
            face.deposit_stroke((30, 22), (24, 31), 2.0)
        face.advance(7 * 10**8)
    assert np.allclose(both.stored[0], a.stored[0] + b.stored[0], rtol=1e-12, atol=1e-15)
    same, other = tube(phosphor), tube(phosphor)
    same.deposit_stroke((22, 22), (30, 31), 1.0)
    same.deposit_stroke((30, 22), (24, 31), 2.0)
    other.deposit_stroke((30, 22), (24, 31), 2.0)
    other.deposit_stroke((22, 22), (30, 31), 1.0)
    assert np.allclose(same.stored[0], other.stored[0], rtol=1e-12, atol=0.0)


@given(st.floats(0.7, 3.0))
def test_focus_changes_the_width_and_not_the_energy(spot: float) -> None:
    sharp, soft = tube(spot=0.7), tube(spot=spot)
    for face in (sharp, soft):
        face.deposit_stroke((25, 25), (35, 30), 1.0)
    allowed = 4.0 * math.exp(-2.0 * math.pi**2 * 0.49) + 1.3e-4
    assert abs(soft.deposited_energy() - sharp.deposited_energy()) < allowed
    if spot > 0.8:
        assert soft.stored[0].max() < sharp.stored[0].max()


@pytest.mark.parametrize("count", [1, 24, 144])
def test_an_even_stream_is_the_limit_of_many_hits(count: int) -> None:
    power = np.full((2, 2), 3.0)
    stream, hits = (Tube((2, 2), (2.0, 2.0), [P31]) for _ in range(2))
    for _ in range(count):
        stream.sustain(power, Fraction(SECOND, 50 * count))
    fine = 4000
    for _ in range(fine):
        hits.advance(Fraction(SECOND, 100 * fine))
        hits.deposit(power / (50 * fine))
        hits.advance(Fraction(SECOND, 100 * fine))
    assert stream.ticks == hits.ticks
    assert np.allclose(stream.stored[0], hits.stored[0], rtol=1e-3)
    assert abs(stream.stored_energy() + stream.emitted_energy() - stream.deposited_energy()) < 1e-12


def test_a_tube_says_what_it_cannot_be() -> None:
    with pytest.raises(ValueError, match="face"):
        Tube((0, 5), (1.0, 1.0), [P31])
    with pytest.raises(ValueError, match="gun"):
        Tube((5, 5), (1.0, 1.0), [])
    with pytest.raises(ValueError, match="forwards"):
        tube().advance(-1)
    with pytest.raises(ValueError, match="spot"):
        tube().deposit_stroke((1, 1), (2, 2), math.nan)
