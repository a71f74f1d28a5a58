"""How far a figure has turned between two quaternions: evenly, or on the straight way between them."""

import math


def turn_degrees(omega: float, t: float) -> float:
    """How far the figure has turned, degrees: twice the angle of the quaternions."""
    return 2.0 * math.degrees(t * omega)


def straight_turn_degrees(omega: float, t: float) -> float:
    """How far it would have turned by going straight along the chord, and bringing that to length 1."""
    return 2.0 * math.degrees(math.atan2(t * math.sin(omega), 1.0 - t + t * math.cos(omega)))


def turns_in_question(omega: float, t: float) -> tuple[float, ...]:
    """What a person who is asked first may choose from, degrees; nothing where all ways agree."""
    turns = (turn_degrees(omega, t), straight_turn_degrees(omega, t), turn_degrees(omega, t * t))
    different = sorted({rounded_degrees(turn) for turn in turns})
    return tuple(different) if len(different) > 1 else ()


def rounded_degrees(turn: float) -> float:
    """Degrees as they are asked for, with three digits behind the point."""
    return round(turn, 3) + 0.0
