"""What each part of the tube is for, and which of its settings belong to it."""

from dataclasses import replace
from typing import NamedTuple

from workbench.algorithms.numerals import with_minus
from workbench.algorithms.scanning.electron_optics import LENS_MM, exact_speed
from workbench.display.cutaway import Part
from workbench.display.gun import Deflection, Gun
from workbench.language import _

_ELECTRONS_PER_UC = 6.241509e12


class PartText(NamedTuple):
    """What a part is called, what it is for, and the names of its settings."""

    title: str
    words: str
    settings: tuple[str, ...] = ()


def part_texts() -> dict[Part, PartText]:
    """By part."""
    plates = _(
        "Two plates, one above and one below the beam. The field between them pulls the electrons towards "
        "the positive one, so the beam leaves at an angle, as if it were bent in the middle of the plates: "
        "that is why D counts from there."
    )
    return {
        "heater": PartText(
            _("Heater"),
            _(
                "A filament like that of a lamp. It makes the cathode glow and has no part in the beam "
                "itself."
            ),
        ),
        "cathode": PartText(
            _("Cathode"),
            _(
                "A small cylinder whose end is coated with oxides. Hot, it gives off electrons (thermionic "
                "emission). It is at 0 V, and every other voltage is counted from it."
            ),
            ("current",),
        ),
        "grid": PartText(
            _("Control grid"),
            _(
                "A cup around the cathode with a hole for the beam. It is negative and pushes electrons "
                "back: the more negative, the fewer get through. So it sets the current, and with it the "
                "brightness; the spot swells with it. At the cut-off the screen is dark."
            ),
            ("grid", "cut_off", "current", "gamma"),
        ),
        "focus": PartText(
            _("Focusing anode"),
            _(
                "The field between this cylinder and its neighbours bends the rays of the beam together, as "
                "a lens does with light. For teaching it is a thin lens whose focal length grows with "
                "V_f / V_a, a model and not a measurement."
            ),
            ("focus",),
        ),
        "anode": PartText(
            _("Accelerating anode"),
            _(
                "Highly positive, it pulls the electrons to their full speed; they pass through its hole. "
                "The faster they are, the more light each one makes, and the harder it is to bend the beam."
            ),
            ("anode",),
        ),
        "plates_y": PartText(
            _("Vertical deflection plates"), plates, ("y_volts", "length", "gap", "reach_y")
        ),
        "plates_x": PartText(
            _("Horizontal deflection plates"),
            _(
                "Two plates at the sides of the beam, one before and one behind the plane of the drawing. "
                "They bend the beam to the right and left in the same way; being nearer to the screen, they "
                "need more voltage for the same millimetres."
            ),
            ("x_volts", "length", "gap", "reach_x"),
        ),
        "coils": PartText(
            _("Deflection coils"),
            _(
                "Two pairs of coils around the neck. Their magnetic field bends the beam into an arc. The "
                "angle falls only with the root of V_a, which is why large, bright tubes use coils; plates "
                "are faster, which is why oscilloscopes use them."
            ),
            ("x_field", "y_field", "length", "reach_y"),
        ),
        "beam": PartText(
            _("Electron beam"),
            _("Electrons in a vacuum, so that no air stops them. Nothing is seen of it from outside."),
        ),
        "coating": PartText(
            _("Conductive coating"),
            _(
                "Graphite on the inside of the cone, joined to the anode. It collects the electrons that the "
                "screen knocks out, so that the screen is not charged, and takes the current back."
            ),
        ),
        "screen": PartText(
            _("Phosphor-coated screen"),
            _(
                "Where the beam lands, the phosphor turns its energy into light (fluorescence) and goes on "
                "glowing a little (phosphorescence). Its persistence is the time until a tenth of the light "
                "is left. The picture fades, so it is drawn again many times a second."
            ),
            ("refresh",),
        ),
    }


def numbers_of(part: Part, gun: Gun) -> list[tuple[str, str]]:
    """What can be said of a part in numbers now: what it is, and how much."""
    current, way = gun.beam_current, gun.way()
    power_mw = current * gun.anode / 1000.0
    match part:
        case "heater":
            return [(_("Usual voltage"), "6.3 V")]
        case "cathode":
            return [(_("Electrons in the beam"), f"{current * _ELECTRONS_PER_UC:.3g} / s")]
        case "grid":
            share = 100.0 * current / gun.current if gun.current else 0.0
            return [(_("Current I"), f"{current:.4g} µA"), (_("Of what K would be"), f"{share:.3g} %")]
        case "focus":
            return [
                (_("Sharp at"), f"{gun.best_focus:.4g} V"),
                (_("Spot (σ)"), f"{gun.spot:.3g} mm"),
                (_("Lens to screen"), f"{gun.screen - LENS_MM:.4g} mm"),
            ]
        case "anode":
            speed = exact_speed(gun.anode)
            return [
                (_("Speed"), f"{speed:,.0f} km/s"),
                (_("Of the speed of light"), f"{speed / 2997.92458:.3g} %"),
                (_("Flight to the screen"), f"{1000.0 * gun.screen / speed:.3g} ns"),
            ]
        case "plates_y" | "plates_x":
            reach = gun.reach_y if part == "plates_y" else gun.reach_x
            return [
                (_("Sensitivity l D / (2 d V_a)"), f"{gun.sensitivity(reach):.3g} mm/V"),
                (_("Catches beyond 2 d² V_a / l²"), f"{gun.limit:.4g} V"),
            ]
        case "coils":
            return [(_("1 mT bends to"), _coil_text(gun))]
        case "beam":
            return [(_("Current I"), f"{current:.4g} µA"), (_("Power I V_a"), f"{power_mw:.4g} mW")]
        case "coating":
            return [(_("At the anode's voltage"), f"{gun.anode:,.4g} V")]
        case "screen":
            phosphor = gun.phosphors[0]
            left = 100.0 * phosphor.intensity(1.0 / gun.refresh)
            doubt = _(" (uncertain)") if phosphor.uncertain else ""
            _z, x, y, _r = way[-1]
            return [
                (_("Spot at"), with_minus(f"({x:.4g}, {y:.4g}) mm")),
                (_("Colour"), phosphor.colour_name.split(",")[0]),
                (_("Persistence to 10 %"), f"{phosphor.t10_s * 1e3:.3g} ms{doubt}"),
                (_("Left when drawn again"), f"{left:.3g} %"),
            ]


def _coil_text(gun: Gun) -> str:
    bent = replace(gun, x=Deflection(), y=Deflection(field=1.0)).way()[-1]
    return f"{bent[2]:.4g} mm" if bent[0] >= gun.screen else _("a circle")
