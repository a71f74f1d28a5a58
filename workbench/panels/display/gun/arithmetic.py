"""The arithmetic of the cards: each formula of the course with its numbers put in, as rich text."""

from workbench.algorithms.numerals import with_minus
from workbench.display.gun import Gun
from workbench.language import _


def _short(value: float) -> str:
    return with_minus(f"{value:.4g}")


def _strong(text: str) -> str:
    return f"<b>{text}</b>"


def _amount(value: str, unit: str) -> str:
    """A result, which no line breaks from its unit."""
    return _strong(f"{value}\N{NO-BREAK SPACE}{unit}")


def current_line(gun: Gun) -> str:
    """I = K (1 - V_g / V_c)^γ."""
    share = f"{_short(abs(gun.grid))}/{_short(abs(gun.cut_off))}"
    amount = _amount(_short(round(gun.beam_current, 1)), "µA")
    return f"<i>I</i> = {_short(gun.current)} (1 \u2212 {share})<sup>{gun.gamma:g}</sup> = {amount}"


def focus_line(gun: Gun) -> str:
    """The spot, and the voltage at which it would be sharp."""
    return _("σ {spot:.2g} mm, sharp at {volts} V").format(spot=gun.spot, volts=_short(gun.best_focus))


def deflection_law(gun: Gun, way: str) -> str:
    """How far the beam is bent, ``way`` "x" or "y", in the letters of the course."""
    if gun.coils:
        turned = "sin <i>θ</i> = <i>l B</i> √(<i>e</i> / (2 <i>m V</i><sub>a</sub>))"
        return f"{turned}<br><i>{way}</i> = <i>D</i> tan <i>θ</i>"
    return f"<i>{way}</i> = <i>l D</i><sub>{way}</sub> <i>V</i><sub>{way}</sub> / (2 <i>d V</i><sub>a</sub>)"


def deflection_line(gun: Gun, way: str, seconds: float | None) -> str:
    """Where the beam lands, ``way`` "x" or "y", from what bends it at a time."""
    drive = float(gun.arguments(seconds)[4][0 if way == "x" else 1])
    end = gun.way(seconds)[-1]
    lands = end[0] >= gun.screen
    place = with_minus(f"{end[1 if way == 'x' else 2]:.1f}")
    value = _amount(place, "mm")
    name = f"<i>{way}</i>"
    if gun.beam_current <= 0.0:
        return _strong(_("No beam: the grid is at its cut-off."))
    if gun.coils:
        if not lands:
            return _strong(_("The coils turn it round: it never gets out."))
        return f"<i>B</i><sub>{way}</sub> = {_short(drive)} mT: {name} = {value}"
    if abs(drive) > gun.limit:
        return _strong(_("Caught: beyond {limit} V a plate is hit.").format(limit=_short(gun.limit)))
    if not lands:
        return _strong(_("The other plates catch the beam."))
    reach = gun.reach_x if way == "x" else gun.reach_y
    volts = _short(round(drive, 1))
    above = f"{gun.length:g}·{reach:g}·{f'({volts})' if drive < 0 else volts}"
    return f"{name} = {above} / (2·{gun.gap:g}·{gun.anode:g}) = {value}"
