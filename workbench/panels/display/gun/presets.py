"""Settings of the tube that are worth looking at, from the worked example to a radar's sweep."""

from typing import Any, NamedTuple

from workbench.display.gun import SAWTOOTH, SINE
from workbench.language import _


class Preset(NamedTuple):
    """``settings`` go onto the usual tube; ``slow_motion`` is how many times slower than life it is seen."""

    slug: str
    title: str
    told: str
    settings: dict[str, Any]
    slow_motion: float = 1.0


def presets() -> tuple[Preset, ...]:
    """In the order of the list that a person sees."""
    return (
        Preset(
            "spot", _("A spot that stands still"), _("Drag the spot, or a slider, and see what bends it."), {}
        ),
        Preset(
            "worked",
            _("The worked example: 30 V bend by 6 mm"),
            _("Plates of 20 mm, 5 mm apart, 200 mm before the screen, at 2 kV; beyond 250 V they catch it."),
            {"length": 20.0, "gap": 5.0, "reach_x": 170.0, "x_volts": 0.0, "y_volts": 30.0},
        ),
        Preset(
            "caught",
            _("Too much voltage: a plate catches the beam"),
            _("From 640 V on a plate catches the beam; turn the 700 V down, and it comes out again."),
            {"x_volts": 0.0, "y_volts": 700.0},
        ),
        Preset(
            "coils",
            _("Bent by coils: 1 mT"),
            _("Coils of 20 mm at 1 mT turn the beam by sin θ = 0.1326."),
            {"coils": True, "length": 20.0, "x_field": 0.0, "y_field": 1.0, "reach_x": 150.0},
        ),
        Preset(
            "lissajous",
            _("A Lissajous figure, 3 : 2"),
            _("Sines of 150 Hz upwards and 100 Hz across; turn a phase, and the figure turns with it."),
            {"x_wave": SINE, "y_wave": SINE, "grid": -12.0},
            100.0,
        ),
        Preset(
            "sweep",
            _("An oscilloscope's sweep"),
            _("A sawtooth of 50 Hz across draws the sine of 150 Hz upwards over time."),
            {
                "x_wave": SAWTOOTH,
                "x_rate": 50.0,
                "x_peak": 600.0,
                "y_wave": SINE,
                "y_peak": 280.0,
                "phosphor": "P31",
                "grid": -10.0,
            },
            50.0,
        ),
        Preset(
            "p7",
            _("A slow sweep on P7"),
            _("The blue flash of the spot, and the yellow-green that stays behind it for seconds."),
            {
                "x_wave": SAWTOOTH,
                "x_rate": 0.5,
                "x_peak": 640.0,
                "y_wave": SINE,
                "y_rate": 2.0,
                "y_peak": 240.0,
                "phosphor": "P7",
                "grid": -4.0,
                "y_phase": 0.0,
            },
        ),
        Preset(
            "blurred",
            _("Out of focus"),
            _("At 300 V the rays cross before the screen; 420 V bring the spot together."),
            {"focus": 300.0, "grid": -6.0},
        ),
        Preset(
            "dark",
            _("Cut off"),
            _("At the cut-off voltage of the grid no electron passes, and the screen is dark."),
            {"grid": -60.0},
        ),
    )


def preset(slug: str) -> Preset:
    """The one of this slug; LookupError where there is none."""
    for each in presets():
        if each.slug == slug:
            return each
    raise LookupError(slug)
