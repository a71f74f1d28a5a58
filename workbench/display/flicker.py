"""How much a refreshed phosphor flickers, in closed form and as measured, and whether an eye would see it.

Sources: Talbot-Plateau law; critical flicker frequency after Ferry and Porter with the constants of an ITT
study of raster terminals (60 Hz at 68.5 cd/m2 for a bright field, 10 Hz more for four times the luminance).
"""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.scanning.phosphor_decay import phosphor_decay
from workbench.display.phosphor import Phosphor

Floats = NDArray[np.float64]

BRIGHT_FIELD_CD_M2 = 68.5

EYE_S = 0.05
"""What comes later than this after a hit is seen beside the next place of something that moves."""

SMEAR_SHARE = 0.1
"""A phosphor smears when more than this share of its light comes later than that: a rule of thumb."""

_BISECTIONS = 80


_PLACES = 33
_MOST_STRETCHED = 100.0


class Zones(NamedTuple):
    """``seconds`` (n,) to 10 % of the light, ascending, and for each the rate from which it is steady, Hz.

    From ``smear_s`` on what moves leaves a trail; infinite where nothing does.
    """

    seconds: tuple[float, ...]
    fusion_hz: tuple[float, ...]
    smear_s: float


class Flicker(NamedTuple):
    """Percent flicker 0 to 1, flicker index 0 to 1, modulation of the fundamental 0 to 2."""

    percent_flicker: float
    flicker_index: float
    modulation: float


def refreshed_terms(phosphor: Phosphor, period_s: float) -> tuple[tuple[float, float], ...]:
    """For each term the light it has just after a hit that is repeated every ``period_s``, and its tau (s).

    Of the light's mean: what one hit brings, and what all hits before have left.
    """
    return tuple(
        (share * period_s / term.tau_s / -math.expm1(-period_s / term.tau_s), term.tau_s)
        for term, share in zip(phosphor.terms, phosphor.energy_fractions, strict=True)
    )


def light_over_refresh(phosphor: Phosphor, period_s: float, steps: int) -> Floats:
    """Seconds after a hit that is repeated every ``period_s``, and the light then, over its mean: (n + 1, 2).

    The text ``phosphor_decay`` is what steps it, from the refreshed terms on. It is run as it is: sooner than
    its compiled reading would be loaded.
    """
    terms = np.array(refreshed_terms(phosphor, period_s))
    return np.array(list(phosphor_decay(terms, period_s / steps, steps)), np.float64)


def _light(phosphor: Phosphor, period_s: float, t: float) -> float:
    """The same at one time within the period, both its ends included."""
    return math.fsum(fresh * math.exp(-t / tau_s) for fresh, tau_s in refreshed_terms(phosphor, period_s))


def percent_flicker(phosphor: Phosphor, period_s: float) -> float:
    """(max - min) / (max + min) of a phosphor refreshed every ``period_s``, 0 to 1."""
    most, least = _light(phosphor, period_s, 0.0), _light(phosphor, period_s, period_s)
    return (most - least) / (most + least)


def flicker_index(phosphor: Phosphor, period_s: float) -> float:
    """The area above the mean over the whole area, for a phosphor refreshed every ``period_s``, 0 to 1.

    The light falls from hit to hit, so that it lies above its mean until it passes it once.
    """
    terms = refreshed_terms(phosphor, period_s)
    low, high = 0.0, period_s
    for _step in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        above = math.fsum(fresh * math.exp(-middle / tau_s) for fresh, tau_s in terms) > 1.0
        low, high = (middle, high) if above else (low, middle)
    given = math.fsum(
        share * math.expm1(-low / term.tau_s) / math.expm1(-period_s / term.tau_s)
        for term, share in zip(phosphor.terms, phosphor.energy_fractions, strict=True)
    )
    return given - low / period_s


def modulation(phosphor: Phosphor, period_s: float) -> float:
    """Amplitude of the fundamental over the mean, 0 (steady) to 2 (pure flashes)."""
    omega = 2.0 * math.pi / period_s
    fundamental = sum(
        share / complex(1.0, omega * term.tau_s)
        for share, term in zip(phosphor.energy_fractions, phosphor.terms, strict=True)
    )
    return 2.0 * abs(fundamental)


def in_closed_form(phosphor: Phosphor, period_s: float) -> Flicker:
    """All three of one hit every ``period_s``."""
    measures = percent_flicker, flicker_index, modulation
    return Flicker(*(measure(phosphor, period_s) for measure in measures))


def measured(seconds: Floats, light: Floats, energies: Floats) -> Flicker:
    """The same of what a place of the face gave off in one period.

    Args: times (n + 1,), ascending over one whole period; the light at them (n + 1,); the energy given off
    between them (n,). A place that gave off nothing does not flicker.
    """
    total, spans = float(energies.sum()), np.diff(seconds)
    if total <= 0.0:
        return Flicker(0.0, 0.0, 0.0)
    most, least = float(light.max()), float(light.min())
    mean = total / float(spans.sum())
    above = np.maximum(energies - mean * spans, 0.0).sum()
    turns = 2.0 * math.pi * (seconds - seconds[0]) / float(spans.sum())
    # The light of a span is taken as even over it
    waves = np.diff(np.exp(-1j * turns)) / (-1j * np.diff(turns))
    fundamental = abs((energies * waves).sum())
    return Flicker((most - least) / (most + least), float(above) / total, 2.0 * float(fundamental) / total)


def critical_frequency_hz(
    mean_cd_m2: float, modulation_of_light: float, reference_cd_m2: float = BRIGHT_FIELD_CD_M2
) -> float:
    """Refresh rate (Hz) below which flicker is predicted; 0 when nothing is modulated."""
    effective = mean_cd_m2 * modulation_of_light / (2.0 * reference_cd_m2)
    return max(0.0, 60.0 + 16.6 * math.log10(effective)) if effective > 0.0 else 0.0


def fusion_hz(phosphor: Phosphor, mean_cd_m2: float) -> float:
    """The refresh rate (Hz) from which this phosphor looks steady; 0 where it does at any.

    A faster refresh modulates the light less, so that there is one rate at which the prediction is met.
    """
    low, high = 0.0, critical_frequency_hz(mean_cd_m2, 2.0)
    for _step in range(_BISECTIONS // 2):
        middle = 0.5 * (low + high)
        if middle <= 0.0:
            return 0.0
        seen = critical_frequency_hz(mean_cd_m2, modulation(phosphor, 1.0 / middle)) > middle
        low, high = (middle, high) if seen else (low, middle)
    return high if low > 0.0 else 0.0


def share_later(phosphor: Phosphor, seconds: float) -> float:
    """Share of the light of a hit that comes later than this, 0 to 1."""
    return math.fsum(
        share * math.exp(-seconds / term.tau_s)
        for term, share in zip(phosphor.terms, phosphor.energy_fractions, strict=True)
    )


def smears(phosphor: Phosphor) -> bool:
    """Whether what moves leaves a trail that is seen, by the rule of thumb of ``SMEAR_SHARE``."""
    return share_later(phosphor, EYE_S) > SMEAR_SHARE


@lru_cache(maxsize=32)
def zones(phosphor: Phosphor, mean_cd_m2: float) -> Zones:
    """Where a phosphor, a hundred times faster to a hundred times slower than it is, flickers and smears."""
    factors = np.geomspace(1.0 / _MOST_STRETCHED, _MOST_STRETCHED, _PLACES).tolist()
    slower = [phosphor.stretched(factor) for factor in factors]
    low, high = factors[0], factors[-1]
    for _step in range(_BISECTIONS // 2):
        middle = math.sqrt(low * high)
        low, high = (low, middle) if smears(phosphor.stretched(middle)) else (middle, high)
    smear_s = phosphor.t10_s * high if smears(slower[-1]) else math.inf
    return Zones(
        tuple(one.t10_s for one in slower), tuple(fusion_hz(one, mean_cd_m2) for one in slower), smear_s
    )
