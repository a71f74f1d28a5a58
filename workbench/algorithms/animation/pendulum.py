"""A pendulum by its equation, theta'' = -(g / l) sin(theta), without friction.

Its angle is an elliptic function of time; both are worked out by the arithmetic-geometric mean. Source:
Abramowitz and Stegun, Handbook of Mathematical Functions, 16.4 and 17.6.
"""

import math

_SMALL = 1e-15


def swing(amplitude: float, part: float) -> float:
    """The angle (radians) after the part ``part``, 0 to 1, of the way from one turning point to the other.

    It goes from ``amplitude``, above 0 and below pi, to its opposite.
    """
    modulus = math.sin(amplitude / 2.0)
    means, differences = _means(modulus)
    # In quarters of a period from the lowest point: 1, 0, -1
    phi = (1.0 - 2.0 * part) * 2.0 ** (len(means) - 1) * math.pi / 2.0
    for mean, difference in zip(reversed(means[1:]), reversed(differences[1:]), strict=True):
        phi = (phi + math.asin(difference / mean * math.sin(phi))) / 2.0
    return 2.0 * math.asin(modulus * math.sin(phi))


def lengthening(amplitude: float) -> float:
    """How many times as long as that of a very small swing the period of this ``amplitude`` (radians) is."""
    means, _differences = _means(math.sin(amplitude / 2.0))
    return 1.0 / means[-1]


def _means(modulus: float) -> tuple[list[float], list[float]]:
    """The arithmetic means on the way to the common one, and half the differences before each."""
    arithmetic, geometric, difference = 1.0, math.sqrt(1.0 - modulus * modulus), modulus
    means, differences = [arithmetic], [difference]
    while abs(difference) > _SMALL:
        difference = (arithmetic - geometric) / 2.0
        arithmetic, geometric = (arithmetic + geometric) / 2.0, math.sqrt(arithmetic * geometric)
        means.append(arithmetic)
        differences.append(difference)
    return means, differences
