"""Numbers as sentences, tables and formulas show them."""


def numeral(value: float) -> str:
    """Six significant digits and a true minus sign; zero has none."""
    return f"{float(str(value)) + 0.0:.6g}".replace("-", "−")
