"""The light of a phosphor from one refresh to the next, as a tube is set on the page Flicker."""

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Mark
from workbench.algorithms.scanning.phosphor_decay import phosphor_decay
from workbench.display.flicker import refreshed_terms
from workbench.display.phosphor import Phosphor
from workbench.display.setup import TubeSetup
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "flicker"
SLUG = phosphor_decay.__name__
STILL, SPOT, BAR = "sheet", "spot", "bar"

REFRESH_HZ = Number(label=_("refresh rate"), low=1.0, high=240.0, keyed=False)
PERSISTENCE = Number(label=_("persistence"), low=0.01, high=100.0, keyed=False)
LUMINANCE = Number(label=_("luminance"), low=0.1, high=10000.0, keyed=False)
STEPS = Number(label=_("steps"), low=1, high=200, whole=True, keyed=False)
PERIODS = Number(label=_("periods"), low=1, high=12, whole=True, keyed=False)
SPEED = Number(label=_("speed"), low=0.0, high=5000.0, keyed=False)

ARGUMENTS = {
    "phosphor": Given("P31"),
    "refresh_hz": Given(60.0, REFRESH_HZ),
    "persistence": Given(1.0, PERSISTENCE),
    "luminance": Given(100.0, LUMINANCE),
    "steps": Given(12, STEPS),
    "periods": Given(2, PERIODS),
    "figure": Given(STILL),
    "speed": Given(60.0, SPEED),
}


def is_of_a_phosphor(subject: Subject | None) -> bool:
    """Whether the light between two refreshes is what is stepped."""
    return subject is not None and subject.kind == KIND


def given(subject: Subject, name: str) -> Argument:
    """An argument of the subject, or what it usually is."""
    return subject.arguments.get(name, ARGUMENTS[name].usual)


def number(subject: Subject, name: str) -> float:
    """The same as a number."""
    value = given(subject, name)
    assert isinstance(value, int | float), name
    return float(value)


def setup_of(subject: Subject) -> TubeSetup:
    """The tube that is looked at; a phosphor that is not known becomes the usual one."""
    setup = TubeSetup(
        str(given(subject, "phosphor")), number(subject, "refresh_hz"), number(subject, "persistence")
    )
    try:
        setup.check()
    except LookupError:
        return TubeSetup(refresh_hz=setup.refresh_hz, persistence=setup.persistence)
    return setup


def phosphor_of(subject: Subject) -> Phosphor:
    """What its face is coated with."""
    return setup_of(subject).guns()[0]


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    """One refresh in equal steps, in milliseconds; the terms begin as all hits have left them."""
    period_s, steps = 1.0 / number(subject, "refresh_hz"), int(number(subject, "steps"))
    terms = np.array(refreshed_terms(phosphor_of(subject), period_s)) * (1.0, 1e3)
    return [Call(catalogue.get(SLUG), (terms, 1e3 * period_s / steps, steps))]


def _on_no_picture(*_arguments: object) -> tuple[Mark, ...]:
    """Light over time lies on no picture."""
    return ()


register(
    KIND,
    SubjectKind(
        title=_("The light from one refresh to the next"),
        calls=_calls,
        choices=lambda _sheet, _subject: (SLUG,),
        entries=(SLUG,),
        arguments=ARGUMENTS,
        on_device=_on_no_picture,
    ),
)
