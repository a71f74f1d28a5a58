"""What a display processor can be told to do: the first number of each instruction of a display list."""

MOVE = 0
DRAW = 1
JUMP = 2
NAMES = ("MOVE", "DRAW", "JUMP")


def operation_name(operation: int) -> str:
    """What an operation is called."""
    return NAMES[operation]
