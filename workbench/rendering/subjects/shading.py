"""The scene of a sheet under a shading, on a coarse picture, so that it can be stepped."""

from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple

from msgspec.structs import replace

from workbench.algorithms.marks import Frame, Mark
from workbench.document.fields import Number
from workbench.document.model import Rectangle, Sheet
from workbench.document.scene.model import Scene
from workbench.document.subjects import Subject
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.marks import on_device
from workbench.rendering.scene.lit_triangles import LitTriangles, lit_triangles
from workbench.rendering.scene.shaded import Buffers, Model, shading_call, shadow_blockers
from workbench.rendering.scene.shading import LIT_SHADINGS
from workbench.rendering.scene.viewpoint import Size
from workbench.rendering.subjects.registry import Given, SubjectKind, register
from workbench.rendering.subjects.visibility import (
    LEAST_COLUMNS,
    MOST_COLUMNS,
    USUAL_COLUMNS,
    fault_of,
    scene_size,
    window_of,
)

KIND = "shading"


def model_of(subject: Subject) -> Model:
    """How the illumination model is applied."""
    given = subject.arguments
    return Model(bool(given.get("by_halfway", False)), bool(given.get("shadows", False)))


def shading_of(subject: Subject) -> str:
    """The slug of the shading, the first where it names none."""
    return subject.entry if subject.entry in LIT_SHADINGS else LIT_SHADINGS[0]


def call_of(sheet: Sheet, subject: Subject) -> Call | None:
    """The run of the shading on the scene; None where nothing can be stepped."""
    if sheet.scene is None or fault_of(sheet):
        return None
    size = scene_size(sheet, subject)
    try:
        return _call(sheet.scene, size, window_of(sheet), shading_of(subject), model_of(subject))
    except ValueError:
        return None


class Lighting(NamedTuple):
    """What the shadings get of a scene: its triangles, how the model is applied, and what is in the way."""

    lit: LitTriangles
    model: Model
    blockers: Array


def lighting_of(sheet: Sheet, subject: Subject) -> Lighting | None:
    """That of a subject; None where nothing can be stepped."""
    if sheet.scene is None or call_of(sheet, subject) is None:
        return None
    return _lighting(sheet.scene, scene_size(sheet, subject), window_of(sheet), model_of(subject))


@lru_cache(maxsize=4)
def _lighting(scene: Scene, size: Size, window: Rectangle | None, model: Model) -> Lighting:
    return Lighting(lit_triangles(scene, size, window), model, shadow_blockers(scene, model))


@lru_cache(maxsize=16)
def _call(scene: Scene, size: Size, window: Rectangle | None, shading: str, model: Model) -> Call:
    lit, _model, blockers = _lighting(scene, size, window, model)
    return shading_call(lit, shading, Buffers.of(size), model, blockers)


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    call = call_of(sheet, subject)
    return [] if call is None else [call]


def _choices(sheet: Sheet, _subject: Subject) -> tuple[str, ...]:
    return () if sheet.scene is None else LIT_SHADINGS


def _on_device(sheet: Sheet, subject: Subject, frame: Frame, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """Marks of the device as they are, to the edge of the coarse picture."""
    width, height = scene_size(sheet, subject)
    return on_device(replace(sheet, width_px=width, height_px=height), frame, marks)


register(
    KIND,
    SubjectKind(
        title=_("How a scene is shaded"),
        invitation=_("Add an object in Space, to see how its light is found, step by step."),
        calls=_calls,
        choices=_choices,
        on_device=_on_device,
        entries=LIT_SHADINGS,
        arguments={
            "columns": Given(
                USUAL_COLUMNS,
                Number(label=_("columns"), low=LEAST_COLUMNS, high=MOST_COLUMNS, whole=True, keyed=False),
            ),
            "by_halfway": Given(False),
            "shadows": Given(False),
        },
    ),
)
