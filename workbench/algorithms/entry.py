"""What an algorithm declares about itself at the foot of its module.

A titled comment (``# Choose the nearer row``) on a line of its own opens a block of the text. A block is
entered when a line of it runs and left when a line of another block, or the header of a loop that holds
titled blocks, runs next in the same frame. Views are Python expressions over the locals of such a visit:

* the plain names are the values when the block is *left*;
* ``before.name`` is the value when it was *entered*;
* ``candidates`` and ``options`` are evaluated on entering, over the plain names: they are shown before the
  choice.

Texts for people are plain strings here and are translated where they are shown.
"""

import copy
from collections.abc import Callable, Generator, Iterator, Mapping
from dataclasses import dataclass, field
from random import Random
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.beside import Beside
from workbench.algorithms.counted import Counted, Kept
from workbench.algorithms.marks import Frame, MarksFunction, no_marks

CALLS = "calls"
"""Under this name a text that calls itself has the variables of each call under way, the first call first."""

Emits = Literal["pixels", "coverage", "spans", "fragments", "points", "segments", "cells", "cubes"]
Space = Literal["", "object space", "image space", "object and image space"]
Kind = Literal["int", "float", "bool", "colour", "image", "depth", "points", "floats", "ints", "matrix"]


class Law(NamedTuple):
    """What always holds, in a sentence, and the test that proves it, as pytest names it under ``tests/``."""

    sentence: str
    proof: str


def _everywhere(*_arguments: Any) -> bool:
    return True


class DrawnBy(NamedTuple):
    """The slug of an entry that draws for another one with the same parameters, since it is faster.

    ``law``, one of the other's, says and proves where both paint the same pixels. ``holds`` tells it of the
    arguments of a call; where all of them are numbers, also of arrays (n,) of those of many, and gives (n,).
    """

    slug: str
    law: Law
    holds: Callable[..., Any] = _everywhere


@dataclass(frozen=True, slots=True)
class Parameter:
    """One argument of the function: its name there, how the course writes it, its range and an example.

    An ``image`` is an integer array (h, w), a ``depth`` buffer a float64 array (h, w), ``points`` a
    float64 array (n, 2) or (n, 3), ``floats`` a float64 array (m,), ``ints`` an integer array, a ``matrix`` a
    float64 array (rows, columns). ``low`` and ``high`` bound a number, both included.
    """

    name: str
    label: str
    kind: Kind
    example: Any
    low: float | None = None
    high: float | None = None
    unit: str = ""
    meaning: str = ""


@dataclass(frozen=True, slots=True)
class View:
    """What one block shows when it is left (see the module's text for the names an expression may use).

    ``candidates``, ``chosen`` and ``rejected`` give pixels, as a sequence of (x, y). ``row`` gives one
    row of the hand table, a tuple as long as ``Entry.columns``: such a visit is one *step*. ``tables``
    maps a title to an expression for a local structure and to its column headings. ``sentence`` is a
    template: each ``{expression}`` is replaced by its value and becomes a link, to the variable it names
    or, for a pair, to the pixel. ``considers`` is the pixel that this block tests without always drawing
    it, for *Why this pixel?*. ``options`` are the texts that a person who is asked first may choose from, as
    they stand on entering, and ``answer`` is the right one: where a choice is no pixel. ``when`` tells
    several views of one block apart: the first that holds is shown; where it changes, a decision changed.
    ``marks`` gives what is drawn of this block over ``Entry.marks``, as a sequence of marks.
    """

    block: str
    when: str = "True"
    candidates: str = "()"
    chosen: str = "()"
    rejected: str = "()"
    row: str = ""
    tables: Mapping[str, tuple[str, tuple[str, ...]]] = field(default_factory=dict)
    sentence: str = ""
    considers: str = ""
    options: str = "()"
    answer: str = ""
    marks: str = "()"


@dataclass(frozen=True, slots=True)
class Entry:
    """One algorithm of the catalogue.

    ``columns`` heads the hand table as the course writes it: ``p_k`` is shown with a subscript.
    ``emitted_columns`` names what is emitted, where that is more or other than what ``emits`` tells.
    ``view_functions`` are plain functions that the views may call, beside what the text itself knows.
    ``laws`` are what the tests of this entry prove, ``not_laws`` what one might believe and is
    not so. ``questions`` are those of the paper it serves, ``next_rung`` the slug of the next one on the
    ladder, ``tie`` the book whose tie it follows. ``works_in`` is where a method for hidden surfaces
    compares. ``writes`` names the image argument that the text itself writes in place (then a painting sink
    writes nothing). ``compiles`` is empty, or says why this text is stepped only. ``extent`` is an expression
    over the parameters for a box (x_min, y_min, x_max, y_max) that no emitted pixel leaves: a figure whose
    box lies inside the picture is painted without testing each pixel.
    ``count`` is one for how many tuples are emitted, where that is known beforehand. Each look at
    the condition of the loop in one of ``tests_in``, functions that the text calls, tests a pixel: their x in
    the caller's y.

    ``marks(arguments, now, emitted, ended)`` gives all else that is drawn of the text, from back to front, in
    the ``frame`` of its arguments. It is called at any line of the text or of what it calls: ``now`` are the
    variables of the text's own call, ``emitted`` (n, k) what that has emitted so far, ``ended`` whether it is
    over. Without a recording, as while something is dragged, ``now`` is empty, ``emitted`` everything and
    ``ended`` true. ``stack`` names the local whose length is plotted, or CALLS for a text that calls itself.
    ``counted`` and ``keeps`` are by the plural of what is counted, and of what is kept.
    ``fails_where`` ends the sentence "It shows another surface where ...".

    ``draws`` are the kinds of figure that it can draw, ``clips`` those that it can clip to a window, as
    documents name them; ``constructs`` are the kinds of spline of whose points, as they are, it makes the
    curve. ``drawn_by`` names what paints it faster: its steps, tables and counts are its own nevertheless.
    ``painter``, of the same arguments, emits what paints the same pixels sooner, as a law says, and returns
    true; where it cannot it emits nothing and returns false.
    ``beside`` are functions for whole pictures, which are compiled with its painting.
    ``at_once``, of the same arguments, gives where (h, w) it colours, for a picture that cannot wait until
    the text is compiled. Where the ranges of parameters are not enough, ``arguments`` makes some that fit
    each other, from a source of chance and nothing else; what is all but degenerate (ties, coincident points,
    repeated knots) has to come up often.
    """

    function: Callable[..., Iterator[tuple[Any, ...]]]
    topic: str
    title: str
    summary: str
    parameters: tuple[Parameter, ...]
    emits: Emits
    source: str
    columns: tuple[str, ...] = ()
    emitted_columns: tuple[str, ...] = ()
    views: tuple[View, ...] = ()
    view_functions: tuple[Callable[..., Any], ...] = ()
    draws: tuple[str, ...] = ()
    clips: tuple[str, ...] = ()
    constructs: tuple[str, ...] = ()
    drawn_by: DrawnBy | None = None
    painter: Callable[..., Generator[tuple[Any, ...], None, bool]] | None = None
    beside: tuple[Beside, ...] = ()
    at_once: Callable[..., NDArray[np.bool_]] | None = None
    arguments: Callable[[Random], tuple[Any, ...]] | None = None
    laws: tuple[Law, ...] = ()
    not_laws: tuple[str, ...] = ()
    questions: tuple[int, ...] = ()
    labs: tuple[str, ...] = ()
    next_rung: str = ""
    tie: str = ""
    works_in: Space = ""
    writes: str = ""
    compiles: str = ""
    extent: str = ""
    count: str = ""
    tests_in: tuple[Callable[..., Any], ...] = ()
    marks: MarksFunction = no_marks
    frame: Frame = "device"
    stack: str = ""
    counted: Mapping[str, Counted] = field(default_factory=dict)
    keeps: Mapping[str, Kept] = field(default_factory=dict)
    fails_where: str = ""

    @property
    def parameter_names(self) -> tuple[str, ...]:
        """The names of its parameters, in order."""
        return tuple(parameter.name for parameter in self.parameters)

    @property
    def slug(self) -> str:
        """The function's own name."""
        return self.function.__name__

    @property
    def example(self) -> tuple[Any, ...]:
        """The arguments of the entry's own example; a fresh copy, since a text may write into its arrays."""
        return tuple(copy.deepcopy(parameter.example) for parameter in self.parameters)
