"""How a tube shows colours, as an answer in an exam: shadow mask, beam penetration, and the three models."""

import numpy as np

from workbench.algorithms.colour.rgb_to_hsv import marks, sixths_text
from workbench.algorithms.marks import Ink, Region, Stroke, Word, along, closed
from workbench.algorithms.numerals import numeral
from workbench.display import penetration
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Arrow, Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.language import _
from workbench.rendering.subjects.colour_model import cmy_of, hsv_of, number, rgb_of
from workbench.widgets.formulas.paper import paper_inks

_GUNS_X, _MASK_X, _SCREEN_X = 14.0, 76.0, 92.0
_APART = 9.0
_HOLE = 1.2
_BEAMS: tuple[tuple[str, Ink], ...] = (("B", "data1"), ("G", "data3"), ("R", "data2"))
_WINDOW, _HEIGHT_PT = (0.0, -18.0, 110.0, 18.0), 170.0
_HEXAGON, _HEXAGON_PT = (-1.25, -1.2, 1.25, 1.2), 150.0


def derivation(subject: Subject) -> Derivation:
    """The page, with the colour and the voltage of this page."""
    title = _("How a cathode-ray tube shows colours")
    blocks: list[Block] = [
        Heading(title),
        Heading(_("Shadow mask")),
        Sentence(
            _(
                "1. Three guns send three beams, one for each of red, green and blue; their currents follow "
                "the three parts of each pixel."
            )
        ),
        _shadow_mask(),
        Sentence(
            _(
                "2. All three go through the same hole of the mask, from different directions, and so each "
                "meets only the grains of its own colour. What the mask stops is lost as heat."
            )
        ),
        Sentence(
            _(
                "3. The grains are too small to be told apart: the eye adds their light. Red and green look "
                "yellow, all three white; every current between none and full gives millions of colours."
            )
        ),
        Sentence(
            _(
                "4. Delta: guns and dots in triangles. In-line: guns in a row, slots and short stripes. "
                "Aperture grille: taut wires and stripes from top to bottom, which stop less of the beam."
            )
        ),
        Sentence(
            _(
                "5. Where the three beams do not converge in one place, edges have coloured fringes. "
                "The mask limits how fine a picture can be."
            )
        ),
        Heading(_("Beam penetration")),
        *map(Sentence, _layers(number(subject, "kilovolts"))),
        Heading(_("A colour in three models")),
        *map(Sentence, _models(subject)),
        _hexagon(subject),
    ]
    return Derivation(title, blocks, paper_inks())


def _shadow_mask() -> Drawing:
    """Three guns one above the other, their beams through one hole, and the grains that they meet."""
    items: list[Item] = []
    for k, (letter, ink) in enumerate(_BEAMS):
        y = _APART * (k - 1)
        # The beams cross in the hole: what comes from above lands below
        landing = -y * (_SCREEN_X - _MASK_X) / (_MASK_X - _GUNS_X)
        box = np.array([(4.0, y - 2.0), (_GUNS_X, y - 2.0), (_GUNS_X, y + 2.0), (4.0, y + 2.0)])
        grain = np.array(
            [
                (_SCREEN_X, landing - 1.0),
                (_SCREEN_X + 1.5, landing - 1.0),
                (_SCREEN_X + 1.5, landing + 1.0),
                (_SCREEN_X, landing + 1.0),
            ]
        )
        items += [
            Stroke(closed(box), "text", "thin"),
            Word(f'"{letter}"', 9.0, y, ink),
            Arrow(along((_GUNS_X, y), (_MASK_X, 0.0), (_SCREEN_X, landing)), ink),
            Region(grain, ink),
            Stroke(closed(grain), ink, "thin"),
            Word(f'"{letter}"', _SCREEN_X + 2.0, landing, ink, 1, 0),
        ]
    for low, high in ((-15.0, -_HOLE), (_HOLE, 15.0)):
        items.append(Stroke(along((_MASK_X, low), (_MASK_X, high)), "text", "bold"))
    items += [
        Stroke(along((_SCREEN_X + 1.5, -15.0), (_SCREEN_X + 1.5, 15.0)), "text", "medium"),
        Word('"{}"'.format(_("three guns")), 9.0, 13.0, "text", 0, 1),
        Word('"{}"'.format(_("shadow mask")), _MASK_X, 15.0, "text", -1, 1),
        Word('"{}"'.format(_("screen with grains")), _SCREEN_X, -15.0, "text", 0, -1),
    ]
    return Drawing(_WINDOW, items, _HEIGHT_PT)


def _layers(kilovolts: float) -> list[str]:
    """The law of the two layers, and what this voltage gives."""
    red, green = penetration.shares(kilovolts)
    stopped = penetration.STOPPED_KV
    names = ", ".join(f"{one.name} {one.kilovolts:g} kV" for one in penetration.COLOURS)
    lines = [
        _(
            "Random-scan monitors have one gun and two layers of phosphor, red before green. A slow beam "
            "stops in the red layer, a fast one reaches the green: the accelerating voltage chooses the "
            "colour."
        )
    ]
    if kilovolts <= stopped:
        lines.append(
            _("At {v:g} kV, up to $V_c = {c:g}$ kV, all of the energy stays in the red layer.").format(
                v=kilovolts, c=stopped
            )
        )
    else:
        lines.append(
            _(
                "Share in the green layer: $sqrt(1 - (V_c / V)^2) = sqrt(1 - ({c:g} / {v:g})^2)$ = "
                "{green:.1f} %; in the red layer {red:.1f} %."
            ).format(c=stopped, v=kilovolts, green=100.0 * green, red=100.0 * red)
        )
    lines.append(
        _("Its colours: {names}. It is cheap, but slow to change, and has only these four.").format(
            names=names
        )
    )
    return lines


def _models(subject: Subject) -> list[str]:
    """The colour worked out from model to model."""
    r, g, b = rgb_of(subject)
    c, m, y = cmy_of(subject)
    h, s, v = hsv_of(subject)
    red, green, blue = map(numeral, (r, g, b))
    grey = min(r, g, b)
    lines = [
        _("RGB adds light (screens): $R = {r}$, $G = {g}$, $B = {b}$.").format(r=red, g=green, b=blue),
        _("CMY takes light away (printing): $C = 1 - R = {c}$, $M = 1 - G = {m}$, $Y = 1 - B = {y}$.").format(
            c=numeral(c), m=numeral(m), y=numeral(y)
        ),
        _("HSV, value: $V = max({r}, {g}, {b}) = {v}$.").format(r=red, g=green, b=blue, v=numeral(v)),
    ]
    if v > 0.0:
        lines.append(
            _("Saturation: $S = (V - min) / V = ({v} - {least}) / {v} = {s}$.").format(
                v=numeral(v), least=numeral(grey), s=numeral(s)
            )
        )
    if v > grey:
        lines.append(
            _("Hue, in sixths from red: ${sixths}$, and 60° each: $H = {h}$°.").format(
                sixths=sixths_text(r, g, b), h=numeral(h)
            )
        )
    else:
        lines.append(_("A grey has no hue."))
    return lines


def _hexagon(subject: Subject) -> Drawing:
    """The colour on the hexagon of hue and saturation, seen along the line of greys."""
    return Drawing(_HEXAGON, [*marks(rgb_of(subject), {}, np.zeros((0, 3)), True)], _HEXAGON_PT)
