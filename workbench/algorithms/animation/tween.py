"""The frames between two keys: how far along each is, eased, and that part of the way.

n           number of frames between the keys
j           number of the frame, 0 at the first key and n + 1 at the second
t           the part of the time that is over, j / (n + 1)
part        the part of the way that is covered then: t, eased
value       what is keyed has this value in the frame
"""

from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.animation.easing_words import easing_formula, easing_title, way_text
from workbench.algorithms.animation.easings import BEZIER, EASE_IN, eased
from workbench.algorithms.animation.graph_marks import graph_marks
from workbench.algorithms.animation.parameters import BEZIER_HANDLES, frames_and_values
from workbench.algorithms.animation.refusals import refuse_keys
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import Mark
from workbench.algorithms.numerals import numeral


def tween(
    first_frame: int,
    second_frame: int,
    first: float,
    second: float,
    easing: int,
    x1: float,
    y1: float,
    x2: float,
    y2: float,
) -> Iterator[tuple[int, float]]:
    """Emit the value of every frame from one key to the next.

    Args: the frames and the values of both keys, the number of the easing (0 to 8, as in ``easings``), and
    the handles of a Bézier easing, 0 to 1 in x. Emits: (frame, value), both keys included.
    Raises: ValueError unless the second key comes after the first.
    Source: Hearn and Baker, Computer Graphics, C Version, section 16-5.
    """
    # Count the frames between the keys
    refuse_keys(first_frame, second_frame)
    n = second_frame - first_frame - 1

    # Show the first key as it is
    yield first_frame, first

    for j in range(1, n + 1):
        # Ease the time, and go that part of the way
        t = j / (n + 1)
        part = eased(easing, x1, y1, x2, y2, t)
        value = first + part * (second - first)
        yield first_frame + j, value

    # Show the second key as it is
    yield second_frame, second


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The graph of the value over the frames so far, between the two keys."""
    first_frame, second_frame, first, second, *_easing = arguments
    keys = np.array([(first_frame, first), (second_frame, second)], np.float64)
    yield from graph_marks(keys, emitted)


def values_in_question(first: float, second: float, value: float, t: float) -> tuple[str, ...]:
    """What a person who is asked first may choose from: the value, the one at even speed, and others."""
    shares = (t, 1.0 - t, t * t, 0.5)
    others = [numeral(first + share * (second - first)) for share in shares]
    return tuple(sorted({numeral(value), *others}))


def _arguments(chance: Random) -> tuple[Any, ...]:
    (first_frame, second_frame), (first, second) = frames_and_values(chance, 2)
    handles = chance.choice((0.0, 1.0, chance.random())), chance.uniform(-1.0, 2.0)
    others = chance.choice((0.0, 1.0, chance.random())), chance.uniform(-1.0, 2.0)
    return first_frame, second_frame, first, second, chance.randint(0, BEZIER), *handles, *others


_EASE = "Ease the time, and go that part of the way"
_ROW = "(j, first_frame + j, t, part, value)"
_PART = "eased(easing, x1, y1, x2, y2, j / (n + 1))"

ENTRY = Entry(
    function=tween,
    topic="animation",
    title="In-betweens of two keys",
    summary="Finds what fraction of the time has passed, eases it, and goes that fraction of the way.",
    parameters=(
        Parameter("first_frame", "frame_k", "int", 28, low=0, meaning="the frame of the first key"),
        Parameter(
            "second_frame",
            "frame_{k+1}",
            "int",
            40,
            low=1,
            meaning="the frame of the second key, which is later",
        ),
        Parameter("first", "P_k", "float", 46.0, meaning="the value at the first key"),
        Parameter("second", "P_{k+1}", "float", 10.0, meaning="the value at the second key"),
        Parameter(
            "easing",
            "easing",
            "int",
            EASE_IN,
            low=0,
            high=BEZIER,
            meaning="0 held, 1 linear, 2 in, 3 out, 4 in and out, 5 to 7 the same cubic, 8 Bézier",
        ),
        *BEZIER_HANDLES,
    ),
    arguments=_arguments,
    emits="points",
    emitted_columns=("frame", "value"),
    source="Hearn and Baker, Computer Graphics, C Version, section 16-5",
    columns=("j", "frame", "t", "eased t", "value"),
    view_functions=(easing_formula, easing_title, values_in_question, numeral, way_text),
    views=(
        View(
            block="Count the frames between the keys",
            sentence="From frame {first_frame} to frame {second_frame} there are {n} in-betweens.",
        ),
        View(
            block="Show the first key as it is",
            row="(0, first_frame, 0.0, 0.0, first)",
            sentence="Frame {first_frame} is a key: {first}.",
        ),
        View(
            block=_EASE,
            row=_ROW,
            options=f"values_in_question(first, second, first + {_PART} * (second - first), j / (n + 1))",
            answer="numeral(value)",
            sentence="Frame {first_frame + j} is in-between {j} of {n}: t = {j} / {n + 1} = {t}, and "
            "{easing_title(easing)} gives {easing_formula(easing, t)} = {part}; "
            "{way_text(first, second, part)} = {value}.",
        ),
        View(
            block="Show the second key as it is",
            row="(n + 1, second_frame, 1.0, 1.0, second)",
            sentence="Frame {second_frame} is the next key: {second}.",
        ),
    ),
    laws=(
        Law(
            "A key's frame shows exactly the key's value.",
            "animation/test_tween.py::test_a_key_s_frame_shows_exactly_the_key_s_value",
        ),
        Law(
            "Every in-between is the course's P_k + t (P_{k+1} − P_k) with its t eased, t = j / (n + 1).",
            "animation/test_tween.py::test_in_betweens_are_those_of_the_formula",
        ),
        Law(
            "An easing starts at 0 and ends at 1; eased by sine or cube, a value never turns back.",
            "animation/test_tween.py::test_a_value_never_turns_back",
        ),
    ),
    not_laws=("Easing changes which values are passed: it changes only when they are.",),
    questions=(9,),
    labs=("Animation: key frames and in-betweens",),
    marks=marks,
    frame="view",
    count="second_frame - first_frame + 1",
)
