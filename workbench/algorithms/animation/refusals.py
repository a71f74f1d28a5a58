"""What stands at the door of the texts; compiled, a sentence holds no numbers."""

from typing import Any

from numpy.typing import NDArray


def refuse_keys(first_frame: int, second_frame: int) -> None:
    """Raise ValueError unless the second key comes after the first."""
    if second_frame <= first_frame:
        raise ValueError("The second key needs a later frame than the first; move one of them in time.")


def refuse_track(
    frames: NDArray[Any],
    values: NDArray[Any],
    tensions: NDArray[Any],
    continuities: NDArray[Any],
    biases: NDArray[Any],
) -> None:
    """Raise ValueError unless there are two keys or more, in ascending frames, with all numbers of each."""
    count = len(frames)
    if count < 2:
        raise ValueError("A spline needs at least two keys; set another one.")
    if len(values) != count or len(tensions) != count or len(continuities) != count or len(biases) != count:
        raise ValueError("Give a value, a tension, a continuity and a bias for each key.")
    for k in range(count - 1):
        if frames[k + 1] <= frames[k]:
            raise ValueError("Each key needs a later frame than the one before; move one of them in time.")


def refuse_outlines(first: NDArray[Any], second: NDArray[Any]) -> None:
    """Raise ValueError unless both have two vertices at least."""
    if len(first) < 2 or len(second) < 2:
        raise ValueError("An outline needs at least two vertices; draw another one.")


def refuse_in_betweens(n: int) -> None:
    """Raise ValueError unless this is a number of in-betweens."""
    if n < 0:
        raise ValueError("The number of in-betweens cannot be negative; give 0 or more.")


def refuse_quaternion(length: float) -> None:
    """Raise ValueError unless a quaternion of this length is an orientation."""
    if not (1e-150 < length < 1e150):
        raise ValueError("This quaternion is not an orientation; give one that is finite and not zero.")
