"""Generated arguments for every entry of the catalogue, near-degenerate ones among them."""

from typing import Any

from hypothesis import strategies as st

from workbench.algorithms.entry import Entry, Parameter

# How far from 0 numbers are taken: so near that ties and equal coordinates are common, or farther.
REACHES = (9, 60)


def arguments(entry: Entry) -> st.SearchStrategy[tuple[Any, ...]]:
    """Arguments that the entry's own generator makes, or that are taken from its parameters' ranges.

    Raises TypeError where it has no generator and a parameter has no range.
    """
    if entry.arguments is not None:
        return st.randoms(use_true_random=False).map(entry.arguments)
    return st.one_of(
        *(st.tuples(*(_in_range(entry, p, reach) for p in entry.parameters)) for reach in REACHES)
    )


def _in_range(entry: Entry, parameter: Parameter, reach: int) -> st.SearchStrategy[Any]:
    """Values of one parameter: whole numbers, and for a real one those between them."""
    if parameter.kind == "bool":
        return st.booleans()
    if parameter.kind not in ("int", "float", "colour") or parameter.low is None or parameter.high is None:
        raise TypeError(
            f"{entry.slug} has no range for {parameter.name} and no generator: give the parameter low and "
            "high, or, if it has no range by nature, give the entry a function arguments(chance)."
        )
    if parameter.kind == "colour":
        return st.integers(0, 3)
    low, high = max(-reach, parameter.low), min(reach, parameter.high)
    if parameter.kind == "int":
        return st.integers(int(low), int(high))
    whole = st.integers(int(-(-low // 1)), int(high // 1)).map(float)
    return st.one_of(whole, st.floats(low, high, allow_subnormal=False))
