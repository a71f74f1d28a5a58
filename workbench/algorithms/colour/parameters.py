"""What the texts of colour take, and colours that chance makes."""

from random import Random

from workbench.algorithms.entry import Parameter

RGB = (
    Parameter("r", "R", "float", 0.9, 0.0, 1.0, meaning="red, as it is coded"),
    Parameter("g", "G", "float", 0.6, 0.0, 1.0, meaning="green, as it is coded"),
    Parameter("b", "B", "float", 0.3, 0.0, 1.0, meaning="blue, as it is coded"),
)


def coded_rgb(chance: Random) -> tuple[float, float, float]:
    """Components of which some are often equal, none, or all there can be."""
    first = chance.random()
    others = [chance.choice((0.0, 1.0, first, chance.random())) for _component in range(2)]
    levels = [chance.choice((0.0, 1.0, first)), *others]
    chance.shuffle(levels)
    return levels[0], levels[1], levels[2]


def coded_hsv(chance: Random) -> tuple[float, float, float]:
    """Hues that are often a corner of the hexagon; greys, black and the purest colours among them."""
    hue = chance.choice((60.0 * chance.randint(0, 6), chance.uniform(0.0, 360.0)))
    s, v = (chance.choice((0.0, 1.0, chance.random())) for _share in range(2))
    return hue, s, v
