"""Phosphor decay: light fades as a sum of exponentials, each exact for any time step.

terms           weight and time constant of each exponential
states          what each term still gives of light
light           all terms together
emitted         light given off so far; with what is still stored it makes all the energy of the hit
"""

import math
from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import MOST_SPOTS, Mark, Spot, Stroke


def phosphor_decay(terms: NDArray[Any], dt: float, steps: int) -> Iterator[tuple[float, float]]:
    """Emit time and light after a hit at time 0, in equal steps.

    Args: (n, 2) weights and time constants, weights not negative; length of a step, in the same unit; how
    many steps. Emits: (t, light). Source: energy balance of a sum of first-order decays.
    """
    # Take the hit: each term starts with its weight
    states = [float(term[0]) for term in terms]
    light = 0.0
    for state in states:
        light += state
    emitted = 0.0
    t = 0.0
    yield t, light

    for k in range(steps):
        # Let every term fade
        light = 0.0
        stored = 0.0
        for j in range(len(states)):
            tau = float(terms[j, 1])
            kept = 0.0
            if tau > 0.0:
                kept = math.exp(-dt / tau)
                emitted += states[j] * tau * (1.0 - kept)
            states[j] *= kept
            stored += states[j] * tau
            light += states[j]

        # Show the light that is left
        t = (k + 1) * dt
        yield t, light


def marks(
    _arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The light over time so far; the last step is ringed."""
    if len(emitted) > 1:
        yield Stroke(np.asarray(emitted, np.float64), "data1", "medium")
    for t, light in emitted.tolist() if len(emitted) <= MOST_SPOTS else ():
        yield Spot(t, light, "data1", "dot", "small")
    if len(emitted):
        t, light = emitted[-1].tolist()
        yield Spot(t, light, "accent", "ring", "large")


_P31 = np.array([[0.942464, 0.1163], [0.05172, 2.001], [0.005816, 18.18]])


def _terms_and_steps(chance: Random) -> tuple[Any, ...]:
    """Up to three terms, some of no weight or of no duration, and steps that are far shorter or longer."""
    terms = [
        [
            chance.choice((0.0, 1.0, chance.random())),
            chance.choice((0.0, 1e-6, 1.0, chance.uniform(0.0, 60.0))),
        ]
        for _term in range(chance.randint(0, 3))
    ]
    dt = chance.choice((0.0, 1e-9, 1.0, 1e6, chance.uniform(0.0, 60.0)))
    return np.array(terms, np.float64).reshape(-1, 2), dt, chance.randint(0, 12)


ENTRY = Entry(
    function=phosphor_decay,
    topic="scanning",
    title="Phosphor decay",
    summary="Every step multiplies by exp(−dt/τ), so ten short steps end where one long step does.",
    parameters=(
        Parameter("terms", "w_k, τ_k", "points", _P31, meaning="weight and time constant in ms: P31"),
        Parameter("dt", "dt", "float", 0.5, 0.0, 1e6, "ms", "length of a step"),
        Parameter("steps", "n", "int", 12, 0, 100000, "", "number of steps"),
    ),
    arguments=_terms_and_steps,
    emits="points",
    source="Sum of exponentials fitted to the decay table of Tektronix, 1966",
    emitted_columns=("t", "light"),
    columns=("k", "t (ms)", "light", "emitted", "stored"),
    views=(
        View(
            block="Let every term fade",
            tables={"Terms": ("[(j, states[j]) for j in range(len(states))]", ("k", "light"))},
            sentence="In {dt} ms each term keeps exp(−dt/τ) of its light; together {light} is left.",
        ),
        View(
            block="Show the light that is left",
            row="(k, t, light, emitted, stored)",
            sentence="At {t} ms the light is {light}; {emitted} was given off, {stored} is still to come.",
        ),
    ),
    laws=(
        Law(
            "One step of n dt and n steps of dt leave the same light.",
            "scanning/test_scanning.py::test_decay_is_the_same_in_one_step_and_in_many",
        ),
        Law(
            "What was given off and what is stored make the energy of the hit, at every step.",
            "scanning/test_scanning.py::test_what_was_given_off_and_what_is_stored_make_the_energy_of_the_hit",
        ),
        Law(
            "From what all hits before have left it steps the closed form of a steady refresh.",
            "display/test_flicker.py::test_the_text_steps_the_light_of_a_steady_refresh",
        ),
    ),
    questions=(6,),
    labs=("Phosphor and persistence",),
    marks=marks,
    frame="view",
)
