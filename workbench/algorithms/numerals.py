"""Numbers as sentences, tables and formulas show them: in one way, so that each is found again elsewhere."""

import math
import re

_DECIMALS = 4
_HUGE = 1e15
_ROUNDING = 1e-12
_NEGATIVE = re.compile(r"(?:(?<!\w)|(?<=\de))-(?=\d|inf\b)")  # before a number, or in its power of ten


def decimal(value: float) -> str:
    """A number as the course writes it: whole ones without a point, others to four decimals at most.

    Those too small for that, and huge ones, have four significant digits and a power of ten.
    """
    if isinstance(value, int):
        return str(value)
    if not math.isfinite(value) or 0 < abs(value) < 10**-_DECIMALS or abs(value) >= _HUGE:
        return f"{value:.4g}"
    text = f"{value:.{_DECIMALS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def numeral(value: float) -> str:
    """The same with a true minus sign."""
    return decimal(float(value)).replace("-", "−")


def with_minus(text: str) -> str:
    """A text with numbers in it, their hyphens as true minus signs; those of words stay."""
    return _NEGATIVE.sub("−", text)


def settled(*values: float) -> tuple[float, ...]:
    """The numbers, each 0 that is only what rounding left beside the largest of them, or beside 1."""
    least = _ROUNDING * max(1.0, *(abs(value) for value in values))
    return tuple(0.0 if abs(value) < least else value for value in values)
