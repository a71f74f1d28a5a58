"""The table of phosphors: decay, colours, flicker."""

import math
import tomllib
from dataclasses import replace

import numpy as np
import pytest

from workbench.display import Phosphor, Term, phosphor_names
from workbench.display.flicker import critical_frequency_hz, flicker_index, modulation, percent_flicker
from workbench.paths import resource

RECORDS = {p["id"]: p for p in tomllib.loads(resource("phosphors.toml").read_text("utf-8"))["phosphor"]}


@pytest.mark.parametrize("name", phosphor_names())
def test_decay_times_are_those_of_the_table(name: str) -> None:
    phosphor = Phosphor.named(name)
    for key, fraction in (("t10_s", 0.1), ("t1_s", 0.01), ("t01_s", 0.001)):
        if "power_law" in RECORDS[name]:  # these terms fit the published law within 5 % of its intensity
            assert math.isclose(phosphor.intensity(RECORDS[name][key]), fraction, rel_tol=0.05)
        elif key in RECORDS[name]:
            assert math.isclose(phosphor.time_to(fraction), RECORDS[name][key], rel_tol=0.02)


@pytest.mark.parametrize("name", phosphor_names())
def test_shares_sum_to_one(name: str) -> None:
    phosphor = Phosphor.named(name)
    assert math.isclose(sum(t.weight for t in phosphor.terms), 1.0, abs_tol=1e-6)
    assert math.isclose(sum(phosphor.energy_fractions), 1.0, abs_tol=1e-12)
    stored = [t["energy_fraction"] for t in RECORDS[name]["terms"]]
    assert np.allclose(phosphor.energy_fractions, stored, atol=2e-4)
    for _, colour in phosphor.colours:
        assert max(colour) == 1.0


@pytest.mark.parametrize("name", phosphor_names())
def test_a_time_is_the_last_one_above_its_share_and_found_in_few_steps(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    phosphor, asked, intensity = Phosphor.named(name), [], Phosphor.intensity
    monkeypatch.setattr(Phosphor, "intensity", lambda one, t: asked.append(t) or intensity(one, t))
    for share in (0.1, 0.01, 0.001):
        time = phosphor.time_to(share)
        assert (
            intensity(phosphor, math.nextafter(time, 0.0))
            > share
            >= intensity(phosphor, math.nextafter(time, 1e9))
        )
    assert len(asked) < 3 * 80


def test_a_stretched_phosphor_keeps_its_light() -> None:
    slow = Phosphor.named("P31").stretched(10.0)
    assert math.isclose(slow.time_to(0.1), 0.0034, rel_tol=0.02)
    assert np.allclose(slow.energy_fractions, Phosphor.named("P31").energy_fractions)


def test_an_unknown_name_is_answered_with_near_ones() -> None:
    with pytest.raises(LookupError, match="P3"):
        Phosphor.named("P35")


@pytest.mark.parametrize(("tau", "period"), [(0.001, 1 / 60), (0.0651, 1 / 30), (0.0116, 1 / 60)])
def test_flicker_measures_of_a_sampled_waveform(tau: float, period: float) -> None:
    count = 400_000
    t = (np.arange(count) + 0.5) * (period / count)
    light = np.exp(-t / tau) / (1.0 - math.exp(-period / tau)) / tau
    mean = light.mean()
    low, high = math.exp(-period / tau), 1.0
    one = replace(Phosphor.named("P1"), terms=(Term(1.0, tau),))
    assert math.isclose(percent_flicker(one, period), (high - low) / (high + low), rel_tol=1e-9)
    assert math.isclose(percent_flicker(one, period), math.tanh(period / (2.0 * tau)), rel_tol=1e-9)
    above = np.maximum(light - mean, 0.0).sum() / light.sum()
    assert math.isclose(flicker_index(one, period), above, rel_tol=1e-4)


@pytest.mark.parametrize(
    ("name", "at_60", "at_30"),
    [("P1", 0.45, 0.81), ("P4", 1.41, 1.56), ("P31", 1.20, 1.37), ("P7", 0.36, 0.43)],
)
def test_modulation_is_that_of_the_sampled_light(name: str, at_60: float, at_30: float) -> None:
    phosphor = Phosphor.named(name)
    for period, printed in ((1 / 60, at_60), (1 / 30, at_30)):
        count = 200_000
        t = (np.arange(count) + 0.5) * (period / count)
        light = sum(
            share / term.tau_s * np.exp(-t / term.tau_s) / -math.expm1(-period / term.tau_s)
            for share, term in zip(phosphor.energy_fractions, phosphor.terms, strict=True)
        )
        wave = abs((light * np.exp(-2j * math.pi * t / period)).mean()) * 2 / light.mean()
        assert math.isclose(modulation(phosphor, period), wave, rel_tol=1e-4)
        assert abs(wave - printed) < 0.006


def test_the_eye_fuses_at_the_printed_rates() -> None:
    assert math.isclose(critical_frequency_hz(68.5, 2.0), 60.0)
    assert math.isclose(critical_frequency_hz(4 * 68.5, 2.0), 70.0, abs_tol=0.01)
    assert critical_frequency_hz(100.0, 0.0) == 0.0
