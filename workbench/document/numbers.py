"""The numbers that several structs of a document share."""

from workbench.document.fields import Number

MAX_COORDINATE = 1_000_000.0


def coordinate(label: str, symbol: str = "", unit: str = "world") -> Number:
    """A number that may be negative, as large as pictures have use for."""
    return Number(
        label=label,
        symbol=symbol or label,
        low=-MAX_COORDINATE,
        high=MAX_COORDINATE,
        unit=unit,
        keyed=True,
    )


COORDINATE = coordinate("x")
