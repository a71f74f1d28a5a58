"""How long a random-scan display takes for a stroke, a jump and the settling after it, in whole picoseconds.

Distances are in units of the display's addressable grid, the larger of the two components, as its counters
run.
"""

import tomllib
from dataclasses import dataclass, replace
from difflib import get_close_matches
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.language import _
from workbench.paths import resource

TEACHING = "teaching"
"""The display whose numbers can be typed."""

_PS_PER_US = 1_000_000


@dataclass(frozen=True, slots=True)
class VectorTiming:
    """A speed model: start + (distance beyond a knee) x slope; picoseconds and grid units.

    ``uncertain`` names what of its data is not confirmed, ``note`` tells more of it.
    """

    name: str
    grid: int
    start_ps: int
    ps_per_unit: float
    knee_units: int = 0
    jump_start_ps: int = 0
    jump_ps_per_unit: float = 0.0
    settle_ps: int = 0
    dwell_ps: int = 0
    min_frame_ps: int = 0
    uncertain: tuple[str, ...] = ()
    note: str = ""

    @staticmethod
    def own(start_us: float, pace_us: float, jump_pace_us: float, settle_us: float) -> "VectorTiming":
        """The teaching display with these numbers, of a stroke and of a jump, in microseconds."""
        return replace(
            VectorTiming.named(TEACHING),
            start_ps=round(start_us * _PS_PER_US),
            ps_per_unit=pace_us * _PS_PER_US,
            jump_ps_per_unit=jump_pace_us * _PS_PER_US,
            settle_ps=round(settle_us * _PS_PER_US),
            dwell_ps=round(settle_us * _PS_PER_US),
            min_frame_ps=0,
            uncertain=(),
        )

    @property
    def numbers_us(self) -> tuple[float, ...]:
        """t_0, N_0, c, t_j, c_j, t_s and t_d, as the text ``random_scan`` takes them, in microseconds."""
        return (
            self.start_ps / _PS_PER_US,
            float(self.knee_units),
            self.ps_per_unit / _PS_PER_US,
            self.jump_start_ps / _PS_PER_US,
            self.jump_ps_per_unit / _PS_PER_US,
            self.settle_ps / _PS_PER_US,
            self.dwell_ps / _PS_PER_US,
        )

    def shortest_frame_ps(self, refresh_hz: Fraction) -> int:
        """The least time of a picture: one over the rate asked for, or what the display itself needs."""
        return max(int(Fraction(10**12) / refresh_hz), self.min_frame_ps)

    @staticmethod
    def named(name: str) -> "VectorTiming":
        """The display with that id, as "ibm-2250-3". Raises LookupError with close matches."""
        table = _table()
        if name not in table:
            close = get_close_matches(name, table, n=3, cutoff=0.3) or list(table)[:3]
            sentence = _("There is no vector display {name}. Try one of {close}.")
            raise LookupError(sentence.format(name=name, close=", ".join(close)))
        return table[name]

    def stroke_ps(self, dx_units: float, dy_units: float) -> int:
        """Time for one lit stroke; a stroke without length lasts as long as the display dwells on a point."""
        distance = max(abs(dx_units), abs(dy_units))
        if distance == 0.0:
            return max(self.start_ps, self.dwell_ps, 1)
        return max(1, self.start_ps + round(self.ps_per_unit * max(distance - self.knee_units, 0.0)))

    def strokes_ps(self, distances: NDArray[Any]) -> NDArray[np.int64]:
        """As ``stroke_ps`` for many strokes, given the longer of the two ways of each in units, (n,)."""
        ramp = self.start_ps + np.rint(self.ps_per_unit * np.maximum(distances - self.knee_units, 0.0))
        point = max(self.start_ps, self.dwell_ps, 1)
        return np.where(distances == 0.0, point, np.maximum(ramp, 1)).astype(np.int64)

    def jumps_ps(self, distances: NDArray[Any]) -> NDArray[np.int64]:
        """As ``jump_ps`` for many movements, likewise; without the settling."""
        ramp = self.jump_start_ps + np.rint(
            self.jump_ps_per_unit * np.maximum(distances - self.knee_units, 0.0)
        )
        return np.where(distances == 0.0, 0, ramp).astype(np.int64)

    def jump_ps(self, dx_units: float, dy_units: float) -> int:
        """Time for a blanked movement; none when the beam is there already."""
        distance = max(abs(dx_units), abs(dy_units))
        if distance == 0.0:
            return 0
        return self.jump_start_ps + round(self.jump_ps_per_unit * max(distance - self.knee_units, 0.0))


def doubts(timing: VectorTiming) -> str:
    """What of it is not confirmed, as a person reads it; "" where all is."""
    titles = {
        "us_per_unit": _("the time for each unit"),
        "t0_us": _("the time before the beam moves"),
        "grid": _("the number of units across"),
        "full_width_cycles_at_max_velocity": _("the time across the face at full speed"),
        "speed_units_per_s": _("the speed of a stroke"),
        "jump_units_per_s": _("the speed of a jump"),
        "settle_us": _("the time to settle"),
    }
    return ", ".join(titles[name] for name in timing.uncertain)


def vector_displays() -> tuple[str, ...]:
    """The ids of the displays whose speed is known as a function of distance."""
    return tuple(_table())


def _us(record: dict[str, Any], key: str) -> int:
    return round(float(record.get(key, 0.0)) * _PS_PER_US)


def _ramp(record: dict[str, Any]) -> VectorTiming:
    start, slope = _us(record, "t0_us"), record["us_per_unit"] * _PS_PER_US
    return VectorTiming(
        name=record["name"],
        grid=record.get("grid", [1024])[0],
        start_ps=start,
        ps_per_unit=slope,
        knee_units=record.get("knee_units", 0),
        jump_start_ps=start,
        jump_ps_per_unit=slope,
        dwell_ps=_us(record, "dwell_us_per_point"),
        min_frame_ps=round(record.get("min_frame_ms", 0.0) * 1000 * _PS_PER_US),
    )


def _cycles(record: dict[str, Any]) -> VectorTiming:
    """Integrators run at the highest velocity for a whole number of cycles, here for as many as it takes."""
    cycle, velocity = record["cycle_ns"] * 1000, record["velocity_range"][1]
    return VectorTiming(
        name=record["name"],
        grid=record["full_width_cycles_at_max_velocity"] * velocity,
        start_ps=0,
        ps_per_unit=cycle / velocity,
        jump_ps_per_unit=cycle / velocity,
        min_frame_ps=round(record["frame_cycles"] * cycle),
    )


def _free(record: dict[str, Any]) -> VectorTiming:
    settle = _us(record, "settle_us")
    return VectorTiming(
        name=record["name"],
        grid=record["grid"][0],
        start_ps=0,
        ps_per_unit=1e12 / record["speed_units_per_s"],
        jump_ps_per_unit=1e12 / record["jump_units_per_s"],
        settle_ps=settle,
        dwell_ps=settle,
        min_frame_ps=round(1e12 / record["max_refresh_hz"]),
    )


@cache
def _table() -> dict[str, VectorTiming]:
    with resource("video-timings.toml").open("rb") as file:
        records = tomllib.load(file)["vector"]
    makers = {"ramp": _ramp, "ramp-knee": _ramp, "cycles": _cycles, "free": _free}
    return {
        r["id"]: replace(
            makers[r["model"]](r), uncertain=tuple(r["uncertain_fields"]), note=r.get("note", "")
        )
        for r in records
        if r["model"] in makers
    }
