"""What the texts of animation take, and keys that chance makes."""

from random import Random

from workbench.algorithms.entry import Parameter

BEZIER_HANDLES = (
    Parameter("x1", "x_1", "float", 0.25, low=0, high=1, meaning="of a Bézier easing: x of its first handle"),
    Parameter("y1", "y_1", "float", 0.1, meaning="y of its first handle"),
    Parameter("x2", "x_2", "float", 0.25, low=0, high=1, meaning="x of its second handle"),
    Parameter("y2", "y_2", "float", 1.0, meaning="y of its second handle"),
)


def frames_and_values(chance: Random, count: int) -> tuple[list[int], list[float]]:
    """Ascending frames, often side by side, and values, now and then equal ones."""
    frames = [chance.randint(0, 30)]
    while len(frames) < count:
        frames.append(frames[-1] + chance.choice((1, 1, 2, 3, chance.randint(1, 12))))
    return frames, [
        chance.choice((0.0, 10.0, float(chance.randint(-9, 9)), chance.uniform(-1e3, 1e3))) for _key in frames
    ]
