"""A smooth motion through several keys: a cubic between each two, with one slope at a key for both sides.

k               number of a key
to_key, on      the slopes, by frame, of the straight lines to a key and on to the next one
leaving         the slope with which the value leaves each key
arriving        the slope with which it comes to each key; the same unless a continuity is set
span            frames from this key to the next
t               the part of them that is over
value           what is keyed has this value in the frame
"""

from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.animation.graph_marks import graph_marks
from workbench.algorithms.animation.parameters import frames_and_values
from workbench.algorithms.animation.refusals import refuse_track
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import Mark


def spline_tween(
    frames: NDArray[Any],
    values: NDArray[Any],
    tensions: NDArray[Any],
    continuities: NDArray[Any],
    biases: NDArray[Any],
) -> Iterator[tuple[int, float]]:
    """Emit the value of every frame from the first key to the last, along a spline through all of them.

    Args: (n,) frames, ascending, values, and Kochanek and Bartels' three shapes at each key; with all of
    them 0 it is Catmull and Rom's spline. Emits: (frame, value). Raises: ValueError for keys out of order.
    Source: Kochanek and Bartels, 1984; Hearn and Baker, Computer Graphics, C Version, section 10-7.
    """
    # Take the slopes of the straight lines between the keys
    refuse_track(frames, values, tensions, continuities, biases)
    n = len(frames)
    slopes = [slope_after(frames, values, k) for k in range(n - 1)]
    leaving = slopes[:0]
    arriving = slopes[:0]

    for k in range(n):
        # Mix the slopes beside a key, the nearer key counting more
        to_key = slopes[max(k - 1, 0)]
        on = slopes[min(k, n - 2)]
        share = nearness(frames, k)
        leave, arrive = shaped(to_key, on, share, tensions[k], continuities[k], biases[k])
        leaving.append(leave)
        arriving.append(arrive)

    for k in range(n - 1):
        span = int(frames[k + 1]) - int(frames[k])
        for j in range(span):
            # Mix both keys and both slopes by Hermite's functions
            t = j / span
            h0, h1, h2, h3 = blends(t)
            along = span * (h2 * leaving[k] + h3 * arriving[k + 1])
            value = h0 * float(values[k]) + h1 * float(values[k + 1]) + along
            yield int(frames[k]) + j, value

    # Show the last key as it is
    yield int(frames[n - 1]), float(values[n - 1])


def slope_after(frames: NDArray[Any], values: NDArray[Any], k: int) -> float:
    """The slope, by frame, of the straight line from key k to the next."""
    return (float(values[k + 1]) - float(values[k])) / float(frames[k + 1] - frames[k])


def nearness(frames: NDArray[Any], k: int) -> float:
    """How much the line before key k counts, 0 to 1: the longer the way to the next key, the more."""
    if k == 0 or k == len(frames) - 1:
        return 0.5
    return float(frames[k + 1] - frames[k]) / float(frames[k + 1] - frames[k - 1])


def shaped(
    to_key: float, on: float, share: float, tension: float, continuity: float, bias: float
) -> tuple[float, float]:
    """The slopes, by frame, with which a value leaves a key and comes to it.

    With all shapes 0 both are those of the parabola through the key and its two neighbours.
    """
    tight = 1.0 - tension
    first = share * to_key
    second = (1.0 - share) * on
    leave = tight * ((1.0 + bias) * (1.0 - continuity) * first + (1.0 - bias) * (1.0 + continuity) * second)
    arrive = tight * ((1.0 + bias) * (1.0 + continuity) * first + (1.0 - bias) * (1.0 - continuity) * second)
    return leave, arrive


def blends(t: float) -> tuple[float, float, float, float]:
    """Hermite's blending functions: of both values, and of both slopes."""
    rest = 1.0 - t
    return (1.0 + 2.0 * t) * rest * rest, t * t * (3.0 - 2.0 * t), t * rest * rest, -t * t * rest


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The keys, and the graph of the value over the frames so far."""
    frames, values, *_shapes = arguments
    yield from graph_marks(np.column_stack([frames, values]).astype(np.float64), emitted)


def _arguments(chance: Random) -> tuple[Any, ...]:
    frames, values = frames_and_values(chance, chance.randint(2, 6))
    shapes = [
        np.array([chance.choice((0.0, 0.0, 1.0, -1.0, chance.uniform(-1.0, 1.0))) for _key in frames])
        for _shape in range(3)
    ]
    return np.array(frames), np.array(values), *shapes


_SLOPES = "Mix the slopes beside a key, the nearer key counting more"
_BLEND = "Mix both keys and both slopes by Hermite's functions"
_TABLES = {
    "Slopes at the keys": (
        "[(frames[i], values[i], arriving[i], leaving[i]) for i in range(len(leaving))]",
        ("frame", "value", "arriving", "leaving"),
    )
}

ENTRY = Entry(
    function=spline_tween,
    topic="animation",
    title="Spline through keys",
    summary="Gives each key a slope computed from its neighbours, and joins the keys by cubics.",
    parameters=(
        Parameter("frames", "frame_k", "ints", np.array([0, 4, 6, 12]), meaning="the frames of the keys"),
        Parameter("values", "P_k", "floats", np.array([2.0, 10, 14, 6]), meaning="the values at the keys"),
        Parameter("tensions", "t_k", "floats", np.zeros(4), meaning="tension: 1 stops at the key"),
        Parameter("continuities", "c_k", "floats", np.zeros(4), meaning="continuity, the book's sign"),
        Parameter("biases", "b_k", "floats", np.zeros(4), meaning="bias: above 0 overshoots the key"),
    ),
    arguments=_arguments,
    emits="points",
    emitted_columns=("frame", "value"),
    source="Kochanek and Bartels, 1984; Hearn and Baker, Computer Graphics, C Version, section 10-7",
    columns=("frame", "t", "h_0", "h_1", "h_2", "h_3", "value"),
    views=(
        View(
            block="Take the slopes of the straight lines between the keys",
            sentence="{n} keys, and {n - 1} straight lines between them, whose slopes are per frame.",
        ),
        View(
            block=_SLOPES,
            tables=_TABLES,
            sentence="Key {k}, frame {frames[k]}: the slope is {to_key} per frame before it, which counts "
            "{share}, and {on} after; the value arrives with slope {arrive} and leaves with slope {leave}.",
        ),
        View(
            block=_BLEND,
            when="j == 0",
            row="(frames[k] + j, t, h0, h1, h2, h3, value)",
            tables=_TABLES,
            sentence="Frame {frames[k]} is a key: {value}.",
        ),
        View(
            block=_BLEND,
            row="(frames[k] + j, t, h0, h1, h2, h3, value)",
            tables=_TABLES,
            sentence="Frame {frames[k] + j}: t = {j} / {span} = {t}; {h0} · {values[k]} + "
            "{h1} · {values[k + 1]} + {span} · ({h2} · {leaving[k]} + {h3} · {arriving[k + 1]}) = {value}.",
        ),
        View(
            block="Show the last key as it is",
            row="(frames[n - 1], 1.0, 0.0, 1.0, 0.0, 0.0, values[n - 1])",
            sentence="Frame {frames[n - 1]} is the last key: {values[n - 1]}.",
        ),
    ),
    laws=(
        Law(
            "The spline passes through its keys, exactly.",
            "animation/test_spline_tween.py::test_a_spline_passes_through_its_keys",
        ),
        Law(
            "With all three 0 it is the Catmull-Rom spline over unequal distances in time: its slope "
            "at a key is that of the parabola through the key and its two neighbours.",
            "animation/test_spline_tween.py::test_without_shapes_the_slope_is_that_of_the_parabola",
        ),
        Law(
            "With continuity 0 the speed never jumps at a key, however unequal the distances in time.",
            "animation/test_spline_tween.py::test_the_speed_does_not_jump_at_a_key",
        ),
        Law(
            "Keys on a straight line in time give a uniform motion.",
            "animation/test_spline_tween.py::test_keys_on_a_line_make_an_even_motion",
        ),
    ),
    not_laws=("The value stays between the keys' values: a spline swings beyond them.",),
    questions=(9,),
    labs=("Animation: key frames and in-betweens",),
    marks=marks,
    frame="view",
)
