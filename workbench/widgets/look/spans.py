"""Times as they are read, and as a sum has them."""

from fractions import Fraction

_US = "\N{MICRO SIGN}s"
_UNITS = ((1.0, "s"), (1e3, "ms"), (1e6, _US), (1e9, "ns"), (1e12, "ps"))
_LONG = ((1 / 3600, "h"), (1 / 60, "min"))


def span_text(seconds: float | Fraction) -> str:
    """A time with the unit that keeps it readable, up to hours."""
    return _in_units(seconds, (*_LONG, *_UNITS), 3)


def time_text(seconds: float | Fraction) -> str:
    """Four digits of a time, in seconds or less, as one goes on reckoning with it."""
    return _in_units(seconds, _UNITS, 4)


def _in_units(seconds: float | Fraction, units: tuple[tuple[float, str], ...], digits: int) -> str:
    """In the first unit of which it has one or more, else in the last."""
    value = float(seconds)
    factor, unit = next((each for each in units if abs(value) * each[0] >= 1.0), units[-1])
    return f"{value * factor:.{digits}g} {unit}" if value else "0 s"
