"""A colour on its way from one model to another, and how the colour tubes of the page Colour are set."""

from collections.abc import Mapping

from workbench.algorithms import catalogue
from workbench.algorithms.colour.hsv_to_rgb import hsv_to_rgb
from workbench.algorithms.colour.rgb_to_cmy import rgb_to_cmy
from workbench.algorithms.colour.rgb_to_hsv import rgb_to_hsv
from workbench.algorithms.marks import Mark
from workbench.display import mask, penetration
from workbench.display.colour_tube import ColourSetup
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "colour_model"
TO_CMY, TO_HSV, TO_RGB = (text.__name__ for text in (rgb_to_cmy, rgb_to_hsv, hsv_to_rgb))
Triple = tuple[float, float, float]

LEVEL = Number(label=_("level"), low=0.0, high=1.0, keyed=False)
HUE = Number(label=_("hue"), low=0.0, high=360.0, keyed=False)
PITCH_MM = Number(label=_("pitch"), low=0.2, high=5.0, keyed=False)
ERROR_MM = Number(label=_("convergence error"), low=-5.0, high=5.0, keyed=False)
WIDTH_MM = Number(label=_("width of the close-up"), low=2.0, high=120.0, keyed=False)
KILOVOLTS = Number(
    label=_("accelerating voltage"), low=penetration.LEAST_KV, high=penetration.MOST_KV, keyed=False
)
SLOW = Number(label=_("slow motion"), low=1.0, high=1e6, keyed=False)

ERRORS = ("red_x", "red_y", "green_x", "green_y", "blue_x", "blue_y")
ARGUMENTS = {
    "red": Given(0.9, LEVEL),
    "green": Given(0.6, LEVEL),
    "blue": Given(0.3, LEVEL),
    "hue": Given(0.0, HUE),
    "saturation": Given(0.0, LEVEL),
    "part": Given("models"),
    "mask": Given("delta"),
    "pitch_mm": Given(0.6, PITCH_MM),
    "width_mm": Given(12.0, WIDTH_MM),
    "slow_motion": Given(1.0, SLOW),
    "kilovolts": Given(12.0, KILOVOLTS),
    "by_stroke": Given(False),
    **{name: Given(0.0, ERROR_MM) for name in ERRORS},
}


def is_of_a_colour(subject: Subject | None) -> bool:
    """Whether a colour on its way to another model is what is stepped."""
    return subject is not None and subject.kind == KIND


def given(subject: Subject, name: str) -> Argument:
    """An argument of the subject, or what it usually is."""
    return subject.arguments.get(name, ARGUMENTS[name].usual)


def number(subject: Subject, name: str) -> float:
    """The same as a number."""
    value = given(subject, name)
    assert isinstance(value, int | float), name
    return float(value)


def rgb_of(subject: Subject) -> Triple:
    """The colour: coded red, green and blue, 0 to 1."""
    return number(subject, "red"), number(subject, "green"), number(subject, "blue")


def cmy_of(subject: Subject) -> Triple:
    """Its cyan, magenta and yellow."""
    return next(rgb_to_cmy(*rgb_of(subject)))


def hsv_of(subject: Subject) -> Triple:
    """Its hue in degrees, saturation and value; a grey has the hue that was last asked for, black both."""
    h, s, v = next(rgb_to_hsv(*rgb_of(subject)))
    if v == 0.0:
        return number(subject, "hue"), number(subject, "saturation"), v
    return (number(subject, "hue") if s == 0.0 else h), s, v


def with_rgb(rgb: Triple) -> Mapping[str, Argument]:
    """The arguments of a colour."""
    return dict(zip(("red", "green", "blue"), map(float, rgb), strict=True))


def with_cmy(cmy: Triple) -> Mapping[str, Argument]:
    """Those of one that is given by its inks: the same subtraction."""
    return with_rgb(next(rgb_to_cmy(*cmy)))


def with_hsv(hsv: Triple) -> Mapping[str, Argument]:
    """Those of one that is given by hue, saturation and value."""
    h, s, v = map(float, hsv)
    return {**with_rgb(next(hsv_to_rgb(h, s, v))), "hue": h, "saturation": s}


def setup_of(subject: Subject) -> ColourSetup:
    """The colour tube; a mask that is not known becomes the usual one."""
    kind = next((kind for kind in mask.KINDS if kind == given(subject, "mask")), mask.KINDS[1])
    across = [number(subject, name) for name in ERRORS]
    errors = (across[0], across[1]), (across[2], across[3]), (across[4], across[5])
    return ColourSetup(kind, number(subject, "pitch_mm"), errors)


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    slug = subject.entry or TO_CMY
    return [Call(catalogue.get(slug), hsv_of(subject) if slug == TO_RGB else rgb_of(subject))]


def _on_no_picture(*_arguments: object) -> tuple[Mark, ...]:
    """A hexagon of colours lies on no picture."""
    return ()


register(
    KIND,
    SubjectKind(
        title=_("A colour in three models"),
        calls=_calls,
        choices=lambda _sheet, _subject: (TO_CMY, TO_HSV, TO_RGB),
        entries=(TO_CMY, TO_HSV, TO_RGB),
        arguments=ARGUMENTS,
        on_device=_on_no_picture,
    ),
)
