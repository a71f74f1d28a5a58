"""How far a figure has turned between two orientations: evenly, or on the straight way between their
quaternions or the entries of their matrices."""

import math


def turn_degrees(omega: float, t: float) -> float:
    """How far the figure has turned, degrees: twice the angle of the quaternions."""
    return 2.0 * math.degrees(t * omega)


def straight_turn_degrees(omega: float, t: float) -> float:
    """How far it would have turned by going straight along the chord, and bringing that to length 1."""
    return 2.0 * math.degrees(chord_angle(omega, t))


def turns_in_question(omega: float, t: float) -> tuple[float, ...]:
    """What a person who is asked first may choose from, degrees; nothing where all ways agree."""
    turns = (turn_degrees(omega, t), straight_turn_degrees(omega, t), turn_degrees(omega, t * t))
    different = sorted({rounded_degrees(turn) for turn in turns})
    return tuple(different) if len(different) > 1 else ()


def rounded_degrees(turn: float) -> float:
    """Degrees as they are asked for, with three digits behind the point."""
    return round(turn, 3) + 0.0


def entries_determinant(theta: float, t: float) -> float:
    """The determinant of the matrix whose entries are the part t of the way between those of two rotations,
    in the plane or in space, with the turn theta (radians) between them; 1 only at both ends.

    What lies along the axis keeps its length, what lies across it is the root of this as long.
    """
    return 1.0 - 2.0 * t * (1.0 - t) * (1.0 - math.cos(theta))


def chord_angle(angle: float, t: float) -> float:
    """The direction (radians) of what is the part t of the way along the chord of an angle."""
    return math.atan2(t * math.sin(angle), 1.0 - t + t * math.cos(angle))
