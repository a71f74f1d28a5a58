"""The tube on paper: the drawing with or without labels, and how it works in the form of an exam's answer."""

import math

import numpy as np

from workbench.algorithms.marks import Ink, Region, Spot, Stroke, Weight, Word, along, closed
from workbench.algorithms.scanning.electron_optics import CHARGE_TO_MASS, coil_sine, thrown
from workbench.display.cutaway import (
    Label,
    beam_outline,
    ends_on_face,
    labels,
    place_labels,
    shapes,
    spans,
    tangent,
    window_of,
)
from workbench.display.gun import Gun
from workbench.exchange.diagram_svg import PaperMetrics
from workbench.exchange.diagrams import (
    PAGE_PT,
    WORD_PT,
    Arrow,
    Block,
    Derivation,
    Drawing,
    Heading,
    Item,
    Sentence,
)
from workbench.exchange.formulas.layout import Typesetter
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.widgets.formulas.paper import paper_inks

_HEIGHT_PT, _LINE_PT = 300.0, 13.0
_WIDEST_FACE = 1.17
"""A PDF has the face of the system, which can be so much wider than Helvetica."""
_CLEAR_PT, _HEAD_PT = 1.0, 12.0
"""Between a length and the arrows beside it, and the least length of these."""
_PLAIN_INKS: dict[str, tuple[Ink, Weight]] = {
    "glass": ("text", "medium"),
    "pin": ("text", "thin"),
    "heater": ("data2", "thin"),
    "metal": ("text", "thin"),
    "plate": ("muted", "thin"),
    "coil": ("muted", "thin"),
    "coating": ("muted", "thin"),
    "phosphor": ("data3", "bold"),
    "axis": ("muted", "hair"),
}


def figure(gun: Gun, labelled: bool = True) -> Drawing:
    """The tube cut open, to scale, with its beam as it is now."""
    window = window_of(gun)
    scale = min((PAGE_PT - 36.0) / (window[2] - window[0]), _HEIGHT_PT / (window[3] - window[1]))
    way = gun.way()
    items: list[Item] = []
    for shape in shapes(gun):
        ink, weight = _PLAIN_INKS[shape.kind]
        ring = closed(shape.points) if shape.closed else shape.points
        if shape.kind in ("metal", "coil", "plate"):
            items.append(Region(shape.points, ink))
        pattern = "dash" if shape.kind in ("coating", "axis") else "solid"
        items.append(Stroke(ring, ink, weight, pattern))  # type: ignore[arg-type]
    outline = beam_outline(way)
    if len(outline):
        items += [Region(outline, "data5"), Stroke(closed(outline), "data5", "thin")]
    if ends_on_face(gun, way):
        items.append(Spot(way[-1][0], way[-1][2], "data3", "dot", "large"))
    if labelled:
        items += _labelled(gun, scale)
    return Drawing(window, items, _HEIGHT_PT)


def _labelled(gun: Gun, scale: float) -> list[Item]:
    """Lengths with arrows, the tangent, and the names of the parts with lines to them."""
    way = gun.way()
    items: list[Item] = []
    if len(line := tangent(gun, way)):
        items.append(Stroke(line, "muted", "hair", "dash"))
    for span in spans(gun):
        name, middle = span.name.replace("mm", '"mm"'), (span.start + span.end) / 2.0
        half = (_width(name) / 2.0 + _CLEAR_PT) / scale
        short = half + _HEAD_PT / scale > (span.end - span.start) / 2.0
        inner = (middle, middle) if short else (middle - half, middle + half)
        for start, end in zip(inner, (span.start, span.end), strict=True):
            items.append(Arrow(along((start, span.y), (end, span.y)), "muted"))
        items.append(Word(name, span.end if short else middle, span.y, "text", int(short)))

    def size_of(label: Label) -> tuple[float, float]:
        return (_width(f'"{label.title}"') + 4.0) / scale, _LINE_PT / scale

    for placed in place_labels(labels(gun), gun, size_of, 4.0 / scale, window_of(gun)):
        left, low, right, high = placed.box
        items.append(Stroke(np.array(placed.leader), "muted", "hair"))
        items.append(Word(f'"{placed.label.title}"', (left + right) / 2.0, (low + high) / 2.0, "text"))
    return items


def _width(words: str) -> float:
    """The most that a word of a drawing takes, in points."""
    return _WIDEST_FACE * Typesetter(PaperMetrics()).formula(words, WORD_PT).width


def drawing(gun: Gun, labelled: bool) -> Derivation:
    """The drawing alone, for an answer sheet."""
    return Derivation(_("Cathode-ray tube"), [figure(gun, labelled)], paper_inks())


def answer(gun: Gun) -> Derivation:
    """The labelled diagram and how it works in five points, then the same with the numbers of this tube."""
    title = _("How a cathode-ray tube works")
    blocks: list[Block] = [
        Heading(title),
        figure(gun),
        Sentence(
            _(
                "1. Emission. The heater makes the cathode hot, and it gives off electrons. The negative "
                "control grid before it lets more or fewer of them pass: that is the brightness."
            )
        ),
        Sentence(
            _("2. Focus. The focusing anode brings the electrons together, so that they make a small spot.")
        ),
        Sentence(
            _(
                "3. Acceleration. The anode, at some thousands of volts, gives them their speed; the "
                "conductive coating inside the cone is joined to it and takes them back."
            )
        ),
        Sentence(
            _(
                "4. Deflection, to any place of the screen. Electrostatic: a pair of plates bends the beam "
                "up and down, another to the sides; it is pulled towards the positive plate, the farther the "
                "higher the voltage. Plates are fast, as in oscilloscopes. Magnetic: coils around the neck "
                "bend it into an arc; they bend far, and fast electrons too, as in television sets and "
                "monitors."
            )
        ),
        Sentence(
            _(
                "5. Light. Where the beam hits the phosphor of the screen it glows, and goes on glowing for "
                "its persistence. As it fades, the picture is drawn again, usually 60 to 80 times a second, "
                "so that it does not flicker."
            )
        ),
        Heading(_("What the knobs do")),
        Sentence(_("Focus sets the voltage of the focusing anode: at one voltage the spot is smallest.")),
        Sentence(
            _(
                "Brightness moves the bias of the control grid: all of the picture, black too, becomes "
                "lighter or darker."
            )
        ),
        Sentence(
            _(
                "Contrast scales the video signal that is added to the bias: white moves away from black, "
                "and black stays."
            )
        ),
        Heading(_("With the numbers of this tube")),
        *map(Sentence, _numbers(gun)),
    ]
    return Derivation(title, blocks, paper_inks())


def _numbers(gun: Gun) -> list[str]:
    v_g, v_c, v_a = displayed(gun.grid), displayed(gun.cut_off), displayed(gun.anode)
    lines = [
        _("Grid: $I = K (1 - V_g / V_c)^gamma = {k} (1 - ({g}) / ({c}))^{{{gamma}}} = {i}$ µA.").format(
            k=displayed(gun.current),
            g=v_g,
            c=v_c,
            gamma=displayed(gun.gamma),
            i=displayed(round(gun.beam_current, 2)),
        ),
        _("Anode: $e V_a = m v^2 / 2$, so $v = sqrt(2 e V_a / m) = {v}$ km/s at $V_a = {a}$ V.").format(
            v=displayed(round(math.sqrt(2.0 * CHARGE_TO_MASS * gun.anode) / 1000.0)), a=v_a
        ),
    ]
    if gun.coils:
        return lines + _coils(gun)
    volts = round(float(gun.arguments()[4][1]), 1)
    lines.append(
        _("Plates: $y = l D V_y / (2 d V_a) = {l} * {D} * {v} / (2 * {d} * {a}) = {y}$ mm.").format(
            l=displayed(gun.length),
            D=displayed(gun.reach_y),
            v=displayed(volts),
            d=displayed(gun.gap),
            a=v_a,
            y=displayed(round(volts * gun.sensitivity(gun.reach_y), 2)),
        )
    )
    lines.append(
        _("Beyond $2 d^2 V_a / l^2 = {limit}$ V a plate catches the beam.").format(limit=displayed(gun.limit))
    )
    return lines


def _coils(gun: Gun) -> list[str]:
    """The turn that both coils together give the beam, and how far from the middle it lands."""
    field_x, field_y = gun.arguments()[4].tolist()
    sine = coil_sine(field_x, field_y, gun.anode, gun.length)
    turn = _(
        "Coils: $sin theta = l B sqrt(e / (2 m V_a)) = {sine}$ for $l = {l}$ mm, $B = {b}$ mT, $V_a = {a}$ V."
    ).format(
        sine=displayed(sine),
        l=displayed(gun.length),
        b=displayed(math.hypot(field_x, field_y)),
        a=displayed(gun.anode),
    )
    if sine >= 1.0:
        return [turn, _("No sine is 1 or more: the coils turn the beam round, and it never gets out.")]
    fall = math.hypot(*thrown(sine, field_x, field_y, gun.reach_y))
    lands = _("It lands $D tan theta = {reach} * {tangent} = {fall}$ mm from the middle.").format(
        reach=displayed(gun.reach_y), tangent=displayed(fall / gun.reach_y), fall=displayed(round(fall, 2))
    )
    return [turn, lands]
