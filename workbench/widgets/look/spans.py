"""Times as they are read."""

_US = "\N{MICRO SIGN}s"
_UNITS = ((1 / 3600, "h"), (1 / 60, "min"), (1.0, "s"), (1e3, "ms"), (1e6, _US), (1e9, "ns"))


def span_text(seconds: float) -> str:
    """A time with the unit that keeps it readable."""
    for factor, unit in _UNITS:
        if seconds * factor >= 1.0:
            return f"{seconds * factor:.3g} {unit}"
    return f"{seconds * 1e12:.3g} ps"
