"""How much a refreshed phosphor flickers, in closed form, and whether an eye would see it.

Sources: Talbot-Plateau law; critical flicker frequency after Ferry and Porter with the constants of an ITT
study of raster terminals (60 Hz at 68.5 cd/m2 for a bright field, 10 Hz more for four times the luminance).
"""

import math

from workbench.display.phosphor import Phosphor

BRIGHT_FIELD_CD_M2 = 68.5
BRIGHT_LINES_CD_M2 = 274.0


def percent_flicker(tau_s: float, period_s: float) -> float:
    """(max - min) / (max + min) of one exponential refreshed every ``period_s``, 0 to 1."""
    return math.tanh(period_s / (2.0 * tau_s))


def flicker_index(tau_s: float, period_s: float) -> float:
    """The area above the mean over the whole area, for one exponential refreshed every ``period_s``."""
    kept = math.exp(-period_s / tau_s)
    mean = tau_s / period_s * (1.0 - kept)
    return (1.0 - mean + mean * math.log(mean)) / (1.0 - kept)


def modulation(phosphor: Phosphor, period_s: float) -> float:
    """Amplitude of the fundamental over the mean, 0 (steady) to 2 (pure flashes)."""
    omega = 2.0 * math.pi / period_s
    fundamental = sum(
        share / complex(1.0, omega * term.tau_s)
        for share, term in zip(phosphor.energy_fractions, phosphor.terms, strict=True)
    )
    return 2.0 * abs(fundamental)


def critical_frequency_hz(
    mean_cd_m2: float, modulation_of_light: float, reference_cd_m2: float = BRIGHT_FIELD_CD_M2
) -> float:
    """Refresh rate (Hz) below which flicker is predicted; 0 when nothing is modulated."""
    effective = mean_cd_m2 * modulation_of_light / (2.0 * reference_cd_m2)
    return max(0.0, 60.0 + 16.6 * math.log10(effective)) if effective > 0.0 else 0.0
