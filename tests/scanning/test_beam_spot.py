"""The beam spot against the energy sent and the Gaussian that it is the integral of."""

import math

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from workbench.algorithms.scanning.beam_spot import beam_spot

place = st.one_of(st.integers(-8, 8).map(float), st.floats(-8, 8, allow_subnormal=False))
places = st.tuples(place, place)
sigmas = st.floats(0.6, 3.0)
Spot = dict[tuple[int, int], float]
few = settings(max_examples=40)


def spot(start: tuple[float, float], end: tuple[float, float], energy: float, sigma: float) -> Spot:
    return {(x, y): share for x, y, share in beam_spot(*start, *end, energy, sigma)}


def is_short(start: tuple[float, float], end: tuple[float, float], sigma: float) -> bool:
    """Whether a stroke is so short that the text takes it for its first point."""
    return math.dist(start, end) <= 1e-4 * max(sigma, 0.1)


def same(one: Spot, other: Spot, most: float) -> bool:
    return all(abs(one.get(p, 0.0) - other.get(p, 0.0)) <= most for p in {*one, *other})


@few
@given(places, places, st.floats(0.0, 1e6), st.one_of(sigmas, st.just(8.0)))
def test_the_pixels_together_get_the_energy_sent(start, end, energy, sigma) -> None:
    bound = 4.0 * math.exp(-2.0 * math.pi**2 * sigma**2) + 1.3e-4
    assert abs(math.fsum(spot(start, end, energy, sigma).values()) - energy) <= bound * energy


@few
@given(places, places, sigmas)
@example((0.0, -1.0), (0.0, -0.99999), 1.0)
def test_each_pixel_gets_the_gaussian_s_integral_along_the_stroke(start, end, sigma) -> None:
    found = spot(start, end, 1.0, sigma)

    def density(t: float, x: int, y: int) -> float:
        dx, dy = x - start[0] - t * (end[0] - start[0]), y - start[1] - t * (end[1] - start[1])
        return math.exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)) / (2 * math.pi * sigma * sigma)

    for x, y in list(found)[:: max(len(found) // 7, 1)]:
        true, _error = quad(density, 0.0, 1.0, (x, y), epsabs=1e-11, limit=200)
        assert found[x, y] == pytest.approx(true, abs=1e-5 if is_short(start, end, sigma) else 1e-8)


@few
@given(places, places, st.floats(0.0, 1.0), sigmas)
def test_a_stroke_in_two_parts_leaves_the_same(start, end, share, sigma) -> None:
    middle = tuple(a + share * (b - a) for a, b in zip(start, end, strict=True))
    whole = spot(start, end, 1.0, sigma)
    parts = spot(start, middle, share, sigma), spot(middle, end, 1.0 - share, sigma)
    both = {p: parts[0].get(p, 0.0) + parts[1].get(p, 0.0) for p in {*parts[0], *parts[1]}}
    assert same(whole, both, 1e-4)


@few
@given(places, places, sigmas)
@example((0.0, 0.0), (0.0, 2.0**-24), 1.0)
def test_a_stroke_backwards_leaves_the_same(start, end, sigma) -> None:
    most = 1e-5 if is_short(start, end, sigma) else 1e-12
    assert same(spot(start, end, 1.0, sigma), spot(end, start, 1.0, sigma), most)


@few
@given(places, sigmas, st.sampled_from([0.0, 1e-9, 1e-5]))
def test_a_stroke_without_length_is_a_round_spot(centre, sigma, length) -> None:
    """Each pixel gets the Gaussian of its distance from the centre, whatever its direction."""
    for (x, y), share in spot(centre, (centre[0] + length, centre[1]), 1.0, sigma).items():
        apart = math.hypot(x - centre[0], y - centre[1])
        round_share = math.exp(-apart * apart / (2 * sigma * sigma)) / (2 * math.pi * sigma * sigma)
        assert share == pytest.approx(round_share, abs=1e-5)
