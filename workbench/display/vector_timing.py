"""How long a random-scan display takes for a stroke, a jump and the settling after it, in whole picoseconds.

Distances are in units of the display's addressable grid, the larger of the two components, as its counters
run.
"""

import tomllib
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from typing import Any

from workbench.language import _
from workbench.paths import resource

_PS_PER_US = 1_000_000


@dataclass(frozen=True, slots=True)
class VectorTiming:
    """A speed model: start + (distance beyond a knee) x slope; picoseconds and grid units."""

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

    def jump_ps(self, dx_units: float, dy_units: float) -> int:
        """Time for a blanked movement; none when the beam is there already."""
        distance = max(abs(dx_units), abs(dy_units))
        if distance == 0.0:
            return 0
        return self.jump_start_ps + round(self.jump_ps_per_unit * max(distance - self.knee_units, 0.0))


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
    makers = {"ramp": _ramp, "ramp-knee": _ramp, "free": _free}
    return {r["id"]: makers[r["model"]](r) for r in records if r["model"] in makers}
