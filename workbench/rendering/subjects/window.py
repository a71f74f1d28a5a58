"""The points of a figure, or one point of the world, through the window of a view to its viewport.

The view is an argument, not one of the ids: the figure is then the active one, as everywhere.
"""

from collections.abc import Iterable

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Frame, Mark
from workbench.algorithms.viewing import origin_to_viewport, scale_factors
from workbench.document.fields import Number
from workbench.document.model import Sheet, View
from workbench.document.numbers import MAX_COORDINATE
from workbench.document.subjects import Subject
from workbench.document.transforms.chains import transformed
from workbench.language import _
from workbench.rendering.mapping import Box, Call, box
from workbench.rendering.marks import on_device
from workbench.rendering.subjects.figure import figure_of
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "window"
TEXT = "window_to_viewport_point"
MOST_POINTS = 200
DEVICE_INK = "data2"

Point = tuple[float, float]


def view_of(sheet: Sheet, subject: Subject) -> View:
    """The view that a subject names; the first one where the sheet has no such view."""
    named = subject.arguments.get("view")
    return next((view for view in sheet.views if view.id == named), sheet.first_view)


def in_view(subject: Subject, view: str) -> Subject:
    """The same in another view, by its id."""
    return replace(subject, arguments={**subject.arguments, "view": view})


def is_through_a_window(subject: Subject) -> bool:
    """Whether what is stepped is the way of points through a view."""
    return subject.kind == KIND


def point_of(subject: Subject) -> Point | None:
    """The point (world) that a subject sends through; None where it sends those of a figure."""
    if not subject.arguments.get("clicked"):
        return None
    x, y = (subject.arguments.get(name, 0.0) for name in ("x", "y"))
    assert isinstance(x, int | float), "its kind is checked"
    assert isinstance(y, int | float), "its kind is checked"
    return float(x), float(y)


def at_point(subject: Subject, point: Point | None) -> Subject:
    """The same for one point (world), or for the points of the active figure."""
    arguments = {name: value for name, value in subject.arguments.items() if name == "view"}
    if point is not None:
        arguments |= {"clicked": True, "x": point[0], "y": point[1]}
    return replace(subject, kind=KIND, arguments=arguments)


def landing(view: View) -> Box:
    """The rectangle (device) that the whole window is mapped onto: the viewport, where it is stretched."""
    window, viewport = box(view.window_world), box(view.viewport_device)
    if view.mode == "stretch":
        return viewport
    sx, sy = scale_factors(window, viewport, view.mode)  # type: ignore[arg-type]
    x, y = origin_to_viewport(window, viewport, view.mode)[:2, 2].tolist()  # type: ignore[arg-type]
    return x, y, x + sx * (window[2] - window[0]), y + sy * (window[3] - window[1])


def points(sheet: Sheet, subject: Subject) -> NDArray[np.float64]:
    """The points (n, 2), world, that are sent through: at most ``MOST_POINTS`` of a figure."""
    clicked, figure = point_of(subject), figure_of(sheet, subject)
    if clicked is not None:
        return np.array([clicked], np.float64)
    if figure is None:
        return np.empty((0, 2), np.float64)
    own = np.array([(p.x, p.y) for p in figure.points_world[:MOST_POINTS]], np.float64).reshape(-1, 2)
    return own if figure.matrix is None else transformed(figure.matrix, own)


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    view, entry = view_of(sheet, subject), catalogue.get(subject.entry or TEXT)
    rectangles = *box(view.window_world), *landing(view)
    return [Call(entry, (x, y, *rectangles)) for x, y in points(sheet, subject).tolist()]


def parted(marks: Iterable[Mark]) -> tuple[tuple[Mark, ...], tuple[Mark, ...]]:
    """Marks in the world and marks on the device: each has its ink."""
    world: list[Mark] = []
    device: list[Mark] = []
    for mark in marks:
        (device if getattr(mark, "ink", "") == DEVICE_INK else world).append(mark)
    return tuple(world), tuple(device)


def _on_device(sheet: Sheet, subject: Subject, _frame: Frame, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    seen = replace(sheet, views=(view_of(sheet, subject),))
    world, device = parted(marks)
    return *on_device(seen, "world", world), *on_device(seen, "device", device)


def _place(label: str) -> Given:
    number = Number(label=label, low=-MAX_COORDINATE, high=MAX_COORDINATE, unit="world", keyed=False)
    return Given(0.0, number)


register(
    KIND,
    SubjectKind(
        title=_("The window and its viewport"),
        invitation=_("Click a point in one of the pictures, and follow it to the other step by step."),
        calls=_calls,
        choices=lambda sheet, subject: (TEXT,),
        entries=(TEXT,),
        arguments={"view": Given(""), "clicked": Given(False), "x": _place("x_w"), "y": _place("y_w")},
        on_device=_on_device,
    ),
)
