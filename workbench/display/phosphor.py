"""Phosphors: the decay of their light as a sum of exponentials, and their colours.

After a hit at time 0 the intensity is I(t)/I(0) = sum_k weight_k exp(-t / tau_k). The share of all emitted
light that belongs to term k is its *energy fraction*, weight_k tau_k over the sum of these.
"""

import math
import tomllib
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cache
from typing import Any

from workbench.language import _
from workbench.paths import resource

Rgb = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Term:
    """One exponential: share of the initial intensity, time constant in seconds, layer it glows in."""

    weight: float
    tau_s: float
    layer: str = "all"


@dataclass(frozen=True, slots=True)
class Phosphor:
    """What a screen is coated with. ``colours`` is the linear sRGB of each layer, largest channel 1.

    ``decay_source`` is the key of where its decay was read (``source_text``), ``uncertain_fields`` names what
    of it rests on memory or on an assumption; ``uncertain`` tells whether the decay itself does.
    """

    name: str
    colour_name: str
    use: str
    terms: tuple[Term, ...]
    colours: tuple[tuple[str, Rgb], ...]
    t10_s: float
    uncertain: bool = False
    note: str = ""
    decay_kind: str = ""
    decay_source: str = ""
    uncertain_fields: tuple[str, ...] = ()

    @staticmethod
    def named(name: str) -> "Phosphor":
        """The phosphor of that designation, as "P31". Raises LookupError with close matches."""
        table = _table()
        if name not in table:
            close = get_close_matches(name, table, n=3, cutoff=0.3) or list(table)[:3]
            sentence = _("There is no phosphor {name}. Try one of {close}.")
            raise LookupError(sentence.format(name=name, close=", ".join(close)))
        return table[name]

    @property
    def energy_fractions(self) -> tuple[float, ...]:
        """Share of all emitted light per term; they sum to 1."""
        total = math.fsum(term.weight * term.tau_s for term in self.terms)
        return tuple(term.weight * term.tau_s / total for term in self.terms)

    def intensity(self, t: float) -> float:
        """I(t)/I(0), t seconds after the hit."""
        return math.fsum(term.weight * math.exp(-t / term.tau_s) for term in self.terms)

    def time_to(self, fraction: float) -> float:
        """Seconds until the intensity has fallen to ``fraction`` of its start (0 < fraction < 1)."""
        low, high = 0.0, max(term.tau_s for term in self.terms)
        while self.intensity(high) > fraction:
            high *= 2.0
        while low < (middle := 0.5 * (low + high)) < high:
            low, high = (middle, high) if self.intensity(middle) > fraction else (low, middle)
        return middle

    def stretched(self, factor: float) -> "Phosphor":
        """Every time constant multiplied by ``factor``; the light per hit is unchanged."""
        terms = tuple(replace(term, tau_s=term.tau_s * factor) for term in self.terms)
        return replace(self, terms=terms, t10_s=self.t10_s * factor)

    def colour_of(self, term: Term) -> Rgb:
        """Linear sRGB of the layer in which a term glows."""
        return dict(self.colours)[term.layer]


def doubts(phosphor: Phosphor) -> str:
    """What of it is uncertain, as a person reads it; "" where nothing is."""
    titles = {
        "t10_s": _("time to 10 %"),
        "decay_kind": _("law of decay"),
        "terms": _("course of the decay"),
        "terms beyond 51 ms": _("decay after 51 ms"),
        "terms beyond 66 ms": _("decay after 66 ms"),
        "split of terms between the layers": _("share of each layer"),
        "xy": _("colour"),
        "xy_afterglow": _("colour of the afterglow"),
    }
    return ", ".join(titles.get(name, name) for name in phosphor.uncertain_fields)


def names() -> tuple[str, ...]:
    """The designations of all phosphors, in the order of the table."""
    return tuple(_table())


def linear_from_srgb(packed: int) -> Rgb:
    """Linear RGB, 0 to 1, of a colour 0xRRGGBB (IEC 61966-2-1)."""

    def channel(value: int) -> float:
        v = value / 255.0
        return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4

    return channel((packed >> 16) & 255), channel((packed >> 8) & 255), channel(packed & 255)


def source_text(key: str) -> str:
    """What is cited under a key of ``Phosphor.decay_source``; the key itself where nothing is."""
    return _sources().get(key, key)


def _colours(record: dict[str, Any]) -> tuple[tuple[str, Rgb], ...]:
    main = linear_from_srgb(int(record["srgb_hue"][1:], 16))
    if "srgb_hue_afterglow" not in record:
        return (("all", main),)
    return ("flash", main), ("afterglow", linear_from_srgb(int(record["srgb_hue_afterglow"][1:], 16)))


@cache
def _file() -> dict[str, Any]:
    with resource("phosphors.toml").open("rb") as file:
        return tomllib.load(file)


@cache
def _sources() -> dict[str, str]:
    return dict(_file()["sources"])


@cache
def _table() -> dict[str, Phosphor]:
    records = _file()["phosphor"]
    return {
        record["id"]: Phosphor(
            name=record["id"],
            colour_name=record["colour"],
            use=record["use"],
            terms=tuple(Term(t["weight"], t["tau_s"], t["layer"]) for t in record["terms"]),
            colours=_colours(record),
            t10_s=record["t10_s"],
            uncertain=record["uncertain"],
            note=record["note"],
            decay_kind=record["decay_kind"],
            decay_source=record["decay_source"],
            uncertain_fields=tuple(record["uncertain_fields"]),
        )
        for record in records
    }
