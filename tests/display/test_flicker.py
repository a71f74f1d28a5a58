"""Flicker by formula, as measured from the light of a tube, and as the text on decay steps it."""

import math
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms.scanning.phosphor_decay import phosphor_decay
from workbench.display import Phosphor, phosphor_names
from workbench.display.flicker import (
    critical_frequency_hz,
    fusion_hz,
    in_closed_form,
    light_over_refresh,
    measured,
    modulation,
    refreshed_terms,
    share_later,
    smears,
    zones,
)
from workbench.display.light_probe import probed_light
from workbench.display.setup import TubeSetup

names = st.sampled_from(phosphor_names())
periods = st.floats(1 / 120, 1 / 10)
DOT = np.zeros((48, 64), np.uint32)
DOT[24, 30] = 0xFFFFFF


def light_of_hits(phosphor: Phosphor, period: float, seconds: np.ndarray) -> np.ndarray:
    """All hits there ever were, added up in closed form; 1 is the mean."""
    light = np.zeros_like(seconds)
    for term, share in zip(phosphor.terms, phosphor.energy_fractions, strict=True):
        kept = np.exp(-np.mod(seconds, period) / term.tau_s) / -math.expm1(-period / term.tau_s)
        light += share * period / term.tau_s * kept
    return light


@given(names, periods, st.integers(1, 30))
@settings(max_examples=60)
def test_the_text_steps_the_light_of_a_steady_refresh(name: str, period: float, steps: int) -> None:
    phosphor = Phosphor.named(name)
    terms = np.array(refreshed_terms(phosphor, period))
    rows = list(phosphor_decay(terms, period / steps, steps))
    light = light_of_hits(phosphor, period, np.array([t for t, _light in rows[:-1]]))
    assert np.allclose([each for _t, each in rows[:-1]], light, rtol=1e-9)
    assert np.allclose(light_over_refresh(phosphor, period, steps), rows, rtol=1e-12)
    # One more hit makes up for what has faded: the light is then as it was after the hit before
    fresh = sum(
        share * period / term.tau_s
        for share, term in zip(phosphor.energy_fractions, phosphor.terms, strict=True)
    )
    assert math.isclose(rows[-1][1] + fresh, rows[0][1], rel_tol=1e-9)


@given(names, periods)
@settings(max_examples=40)
def test_formula_and_sampled_light_agree(name: str, period: float) -> None:
    phosphor = Phosphor.named(name)
    edges = np.concatenate([[0.0], np.geomspace(1e-9, 1.0, 6000)]) * period
    light = light_of_hits(phosphor, period, edges)
    terms = np.array(refreshed_terms(phosphor, period))
    light[-1] = (terms[:, 0] * np.exp(-period / terms[:, 1])).sum()  # just before the next hit
    given_off = sum(
        fresh * tau * -np.expm1(-np.diff(edges) / tau) * np.exp(-edges[:-1] / tau) for fresh, tau in terms
    )
    formula, sampled = in_closed_form(phosphor, period), measured(edges, light, given_off)
    assert math.isclose(sampled.percent_flicker, formula.percent_flicker, rel_tol=1e-6)
    assert math.isclose(sampled.flicker_index, formula.flicker_index, rel_tol=1e-3, abs_tol=1e-6)
    assert math.isclose(sampled.modulation, formula.modulation, rel_tol=1e-3)


@pytest.mark.parametrize("name", ["P1", "P4", "P7", "P31", "P39", "P22G"])
@pytest.mark.parametrize("rate", [30.0, 60.0])
def test_the_light_of_the_simulated_tube_flickers_as_the_formula_says(name: str, rate: float) -> None:
    """A dot alone: what its neighbours' lines add at other moments is not there."""
    seen = measured(*probed_light(DOT, TubeSetup(name, rate), (30, 24)))
    formula = in_closed_form(Phosphor.named(name), 1.0 / rate)
    assert math.isclose(seen.flicker_index, formula.flicker_index, rel_tol=0.02)
    assert math.isclose(seen.modulation, formula.modulation, rel_tol=0.01)
    assert math.isclose(seen.percent_flicker, formula.percent_flicker, rel_tol=0.05)


def test_the_table_of_the_physics_page() -> None:
    """Percent flicker, index and modulation at 60 Hz, as they are printed there."""
    printed = {
        "P1": (61, 0.17, 0.45),
        "P4": (100, 0.60, 1.41),
        "P31": (99, 0.50, 1.20),
        "P22G": (100, 0.75, 1.73),
        "P39": (13, 0.03, 0.08),
        "P7": (92, 0.15, 0.36),
        "P38": (2, 0.005, 0.012),
    }
    for name, (percent, index, depth) in printed.items():
        found = in_closed_form(Phosphor.named(name), 1 / 60)
        assert abs(100.0 * found.percent_flicker - percent) < 0.6
        assert abs(found.flicker_index - index) < 0.006
        assert abs(found.modulation - depth) < 0.006


def test_a_dark_place_does_not_flicker() -> None:
    assert measured(*probed_light(DOT, TubeSetup(), (3, 3))) == (0.0, 0.0, 0.0)


@given(names, st.floats(1.0, 2000.0))
@settings(max_examples=40)
def test_below_the_fusion_frequency_it_flickers_and_above_it_is_steady(name: str, cd_m2: float) -> None:
    phosphor, fusion = Phosphor.named(name), fusion_hz(Phosphor.named(name), cd_m2)
    for rate, flickers in ((0.98 * fusion, True), (1.02 * max(fusion, 1.0), False)):
        if rate > 0.5:
            seen = critical_frequency_hz(cd_m2, modulation(phosphor, 1.0 / rate)) > rate
            assert seen == flickers


@given(names, st.floats(10.0, 500.0))
@settings(max_examples=20, deadline=None)
def test_the_map_goes_from_fast_and_flickering_to_slow_and_smearing(name: str, cd_m2: float) -> None:
    phosphor, found = Phosphor.named(name), zones(Phosphor.named(name), cd_m2)
    assert list(found.seconds) == sorted(found.seconds)
    assert all(
        later <= earlier + 1e-6 for earlier, later in zip(found.fusion_hz, found.fusion_hz[1:], strict=False)
    )
    if math.isfinite(found.smear_s):
        factor = found.smear_s / phosphor.t10_s
        assert smears(phosphor.stretched(1.001 * factor))
        assert not smears(phosphor.stretched(0.999 * factor)) or factor < 0.0101


def test_which_phosphors_smear() -> None:
    """The shares of the physics page that are still to come after 50 ms, and the rule of thumb."""
    later = {name: share_later(Phosphor.named(name), 0.05) for name in ("P31", "P1", "P39", "P2", "P7")}
    printed = {"P31": 0.02, "P1": 0.03, "P39": 0.46, "P2": 0.56, "P7": 0.64}
    assert all(abs(later[name] - share) < 0.01 for name, share in printed.items())
    assert [name for name in later if smears(Phosphor.named(name))] == ["P39", "P2", "P7"]


def test_the_light_is_there_without_the_compiler() -> None:
    """To load it would hold the window when the page is first seen."""
    code = (
        "import sys\n"
        "from workbench.display.flicker import light_over_refresh\n"
        "from workbench.display.phosphor import Phosphor\n"
        "assert len(light_over_refresh(Phosphor.named('P31'), 1 / 60, 240)) == 241\n"
        "assert not {'numba', 'workbench.engine.compiled'} & set(sys.modules), 'loaded'\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
