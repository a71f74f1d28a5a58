"""Object space and image space beside each other: what the course says of the two, with numbers of one scene.

A method that compares in space and decides in the picture as well stands where it begins: in object space.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from workbench.algorithms import catalogue
from workbench.algorithms.numerals import with_minus
from workbench.language import _
from workbench.rendering.scene.arena import MethodRun, space_of
from workbench.rendering.scene.counted import counted_texts
from workbench.rendering.scene.growth import Growth

NOT_YET = "–"
_BOTH = "object and image space"


class Measures(NamedTuple):
    """What was measured of methods, by slug: ``runs`` at the coarse size, ``twice`` at twice its width and
    height, ``growth`` of the times."""

    runs: Mapping[str, MethodRun] = {}
    twice: Mapping[str, MethodRun] = {}
    growth: Mapping[str, Growth] = {}


class SpaceRow(NamedTuple):
    """One row: what is compared, what holds in object space and in image space here, what has to be added."""

    feature: str
    object_space: str
    image_space: str
    but: str = ""


def title_of(method: str) -> str:
    """What a method is called."""
    return _(catalogue.get(method).title)


def fails_where(method: str) -> str:
    """Where a method shows another surface than ray casting, as the end of a sentence."""
    return _(catalogue.get(method).fails_where) or _("depths are equal but for a rounding error")


def in_object_space(method: str) -> bool:
    """Whether its comparisons begin in object space."""
    return space_of(method).startswith("object")


def space_rows(measures: Measures) -> tuple[SpaceRow, ...]:
    """The table, as far as it is measured."""
    return (
        _where(measures),
        _basis(measures),
        _precision(measures),
        _accuracy(measures),
        _by_polygons(measures),
        _by_pixels(measures),
        _examples(measures),
    )


def _sides(measures: Mapping[str, object]) -> tuple[list[str], list[str]]:
    """The methods of either space, in teaching order."""
    return (
        [method for method in measures if in_object_space(method)],
        [method for method in measures if not in_object_space(method)],
    )


def _where(measures: Measures) -> SpaceRow:
    both = [title_of(method) for method in measures.runs if space_of(method) == _BOTH]
    but = ""
    if both:
        but = _(
            "These begin with surfaces in space, but let the pixels decide what is seen in the end: {titles}."
        )
        but = but.format(titles=", ".join(both))
    return SpaceRow(
        _("Where it compares"),
        _("between surfaces, with their coordinates"),
        _("at each pixel, or each part of the screen"),
        but,
    )


def _basis(measures: Measures) -> SpaceRow:
    said = [_("a surface with the other surfaces"), _("the surfaces that come to one pixel")]
    for side, methods in enumerate(_sides(measures.runs)):
        tests = [
            _("{title} {n:,}").format(title=title_of(each), n=measures.runs[each].tests) for each in methods
        ]
        if tests:
            said[side] += _("; comparisons here: {tests}").format(tests=", ".join(tests))
    return SpaceRow(
        _("What it compares"),
        said[0],
        said[1],
        _("Comparisons are those written in the texts; those of painting count too."),
    )


def _precision(measures: Measures) -> SpaceRow:
    said = [_("that of the coordinates: the same for a picture of any size"), _("that of the pixels")]
    for side, methods in enumerate(_sides(measures.twice)):
        divided = [
            _("{title} {counted}, then {m:,}").format(title=title_of(each), counted=counted, m=m)
            for each in methods
            if each in measures.runs
            for counted, m in list(
                zip(counted_texts(measures.runs[each]), measures.twice[each].counted.values(), strict=True)
            )[-1:]
        ]
        if divided:
            said[side] += _("; here, and at twice the width and height: {divided}").format(
                divided=", ".join(divided)
            )
    but = _("A method of both spaces that divides down to the size of a pixel depends on that size too.")
    return SpaceRow(_("Precision"), said[0], said[1], but)


def _accuracy(measures: Measures) -> SpaceRow:
    said = [
        _("exact at any size, where the surfaces are what the method assumes"),
        _("one surface per pixel: borders are stepped"),
    ]
    for side, methods in enumerate(_sides(measures.runs)):
        wrong = [
            _("{title} {n:,} px").format(title=title_of(each), n=n)
            for each in methods
            if (n := int(measures.runs[each].different.sum()))
        ]
        if wrong:
            said[side] += _("; wrong here: {wrong}").format(wrong=", ".join(wrong))
        elif methods:
            said[side] += _("; no pixel is wrong here")
    return SpaceRow(
        _("Accuracy"),
        said[0],
        said[1],
        _(
            "A pixel is wrong if it shows a different surface from ray casting, which compares all "
            "of them there."
        ),
    )


def _by_polygons(measures: Measures) -> SpaceRow:
    return SpaceRow(
        _("Cost, n polygons"),
        *_powers(
            measures.growth, 1, "n", (_("up to n² comparisons"), _("about n, each as large as it is seen"))
        ),
        _(
            "n² is the worst case: boxes that do not overlap end most comparisons at once. Here each polygon "
            "was cut into four, again and again, so that the picture stays the same."
        ),
    )


def _by_pixels(measures: Measures) -> SpaceRow:
    return SpaceRow(
        _("Cost, p pixels"),
        *_powers(measures.growth, 0, "p", (_("deciding costs the same; painting costs more"), _("about p"))),
        _(
            "A method that decides a whole span or square at once grows more slowly than p; ray "
            "casting grows with n p."
        ),
    )


def _powers(growth: Mapping[str, Growth], which: int, letter: str, said: Sequence[str]) -> tuple[str, str]:
    """The exponents of either space after what the course says."""
    told = list(said)
    for side, methods in enumerate(_sides(growth)):
        powers = [
            f"{title_of(each)} {letter}^{_power_text(power)}"
            for each in methods
            if (power := growth[each].exponents[which]) is not None
        ]
        if powers:
            told[side] += _("; measured: {powers}").format(powers=", ".join(powers))
    return told[0], told[1]


def _power_text(power: float) -> str:
    return with_minus(f"{round(power, 1) + 0.0:.1f}")


def _examples(measures: Measures) -> SpaceRow:
    sides = _sides(measures.runs)
    said = [", ".join(map(title_of, methods)) or NOT_YET for methods in sides]
    but = _("Few surfaces, many pixels: object space. Many surfaces: image space, bounded by the screen.")
    return SpaceRow(_("Examples"), said[0], said[1], but)
