"""The electron beam of a tube that is steered by hand: what it is set to are the arguments of the subject."""

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

from msgspec.structs import replace as struct_replace

from workbench.algorithms import catalogue
from workbench.algorithms.scanning.electron_beam import electron_beam
from workbench.display.gun import WAVES, Deflection, Gun
from workbench.display.setup import phosphor_choices
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "gun"
SLUG = electron_beam.__name__
_WAYS = ("x", "y")
_MOST_HZ, _LONGEST_MS = 10000.0, 1e6


def _number(label: str, low: float, high: float, unit: str, symbol: str = "") -> Number:
    return Number(label=label, low=low, high=high, unit=unit, symbol=symbol, keyed=False)


_TUBE = {
    "grid": _number(_("grid voltage"), -200.0, 0.0, "V", "V_g"),
    "cut_off": _number(_("cut-off"), -200.0, -5.0, "V", "V_c"),
    "current": _number(_("current at V_g = 0"), 1.0, 2000.0, "µA", "K"),
    "gamma": _number(_("exponent of the gun"), 1.8, 3.0, "", "γ"),
    "focus": _number(_("focusing voltage"), 10.0, 20000.0, "V", "V_f"),
    "anode": _number(_("accelerating voltage"), 200.0, 30000.0, "V", "V_a"),
    "moment": _number(_("time"), 0.0, _LONGEST_MS, "ms", "t"),
    "length": _number(_("length of the plates"), 5.0, 60.0, "mm", "l"),
    "gap": _number(_("gap between the plates"), 2.0, 30.0, "mm", "d"),
    "reach_x": _number(_("second plates to the screen"), 20.0, 400.0, "mm", "D_x"),
    "reach_y": _number(_("first plates to the screen"), 40.0, 400.0, "mm", "D_y"),
    "refresh": _number(_("refresh rate"), 1.0, 240.0, "Hz", "f"),
}
_WAY = {
    "volts": _number(_("voltage between the plates"), -3000.0, 3000.0, "V", "V"),
    "field": _number(_("field of the coils"), -20.0, 20.0, "mT", "B"),
    "peak": _number(_("peak of the input"), 0.0, 3000.0, "V", "V"),
    "peak_field": _number(_("peak of the input"), 0.0, 20.0, "mT", "B"),
    "rate": _number(_("rate of the input"), 0.1, _MOST_HZ, "Hz", "f"),
    "phase": _number(_("phase of the input"), -360.0, 360.0, "°", "φ"),
}
NUMBERS: dict[str, Number] = {
    **_TUBE,
    **{f"{way}_{name}": number for way in _WAYS for name, number in _WAY.items()},
}
"""The range of every number, by the name of its argument; those of a deflection begin with x_ or y_."""


def is_of_a_gun(subject: Subject) -> bool:
    """Whether the beam of a tube that is steered by hand is what is stepped."""
    return subject.kind == KIND


def settings_of(gun: Gun) -> dict[str, Argument]:
    """Every setting of a tube by the name of its argument."""
    tube = {each.name: getattr(gun, each.name) for each in fields(Gun) if each.name not in _WAYS}
    for way in _WAYS:
        tube |= {f"{way}_{each.name}": getattr(getattr(gun, way), each.name) for each in fields(Deflection)}
    return tube


def changed(gun: Gun, changes: Mapping[str, Any]) -> Gun:
    """The tube with other settings, by the names of their arguments."""
    ways = {
        way: replace(
            getattr(gun, way), **{name[2:]: value for name, value in changes.items() if name[:2] == f"{way}_"}
        )
        for way in _WAYS
    }
    return replace(
        gun, **ways, **{name: value for name, value in changes.items() if name[:2] not in ("x_", "y_")}
    )


def gun_of(subject: Subject) -> Gun:
    """The tube that a subject is set to; a wave or phosphor that is not known is the usual one."""
    given = {name: value for name, value in subject.arguments.items() if name in _USUAL}
    for name, choices in (("x_wave", WAVES), ("y_wave", WAVES), ("phosphor", phosphor_choices())):
        if given.get(name) not in choices:
            given.pop(name, None)
    floats = {name: float(value) if name in NUMBERS else value for name, value in given.items()}  # type: ignore[arg-type]
    return changed(Gun(), floats)


def with_settings(subject: Subject, changes: Mapping[str, Argument]) -> Subject:
    """The same with other settings; what is as usual is left out."""
    settings = {**subject.arguments, **changes}
    told = {name: value for name, value in settings.items() if value != _USUAL[name]}
    return struct_replace(subject, kind=KIND, arguments=told)


_USUAL = settings_of(Gun())


def _calls(_sheet: Sheet, subject: Subject) -> list[Call]:
    gun = gun_of(subject)
    return [] if gun.fault() else [Call(catalogue.get(SLUG), gun.arguments())]


register(
    KIND,
    SubjectKind(
        title=_("The electron beam of a tube"),
        invitation=_("Go to the page Gun of Display, to follow the electron beam step by step."),
        calls=_calls,
        choices=lambda _sheet, _subject: (SLUG,),
        entries=(SLUG,),
        arguments={name: Given(usual, NUMBERS.get(name)) for name, usual in _USUAL.items()},
    ),
)
