"""What a session keeps in the file beside the picture: it is saved, but never a step of undo."""

from functools import lru_cache
from typing import Annotated, Any, Literal, TypeVar

import msgspec
from msgspec.structs import replace

from workbench.document.check import check_part, number_problem, refuse
from workbench.document.faults import shown
from workbench.document.fields import Number, numbers_of
from workbench.document.identities import all_ids
from workbench.document.model import MAX_SIDE_PX, Document, Sheet
from workbench.document.motion.model import MAX_FRAMES
from workbench.document.scene.model import Camera, Scene
from workbench.document.subjects import Position, Subject, fault_in, is_word, missing
from workbench.language import _

T = TypeVar("T")

LONGEST_TIME_S = 1e9

FIGURES = "figures"
"""What a pixel is of that is one of the figures of the sheet; any other is of the workspace that asks."""


def _drive(label: str, low: float, high: float, unit: str = "") -> Number:
    return Number(label=label, low=low, high=high, unit=unit, keyed=False)


class TubeSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the tubes are driven; ``slow_motion`` times slower than life, ``time_s`` on the tube's clock.

    ``persistence`` stretches the phosphor's decay, ``vector_display`` names the speeds of the vector tube.
    ``brightness`` and ``contrast`` are a monitor's knobs: where black lies, and how far white is from it.
    """

    shown: Literal["both", "raster", "vector"] = "both"
    phosphor: str = "P31"
    refresh_hz: Annotated[float, _drive(_("refresh rate"), 0.1, 1000.0, "Hz")] = 60.0
    slow_motion: Annotated[float, _drive(_("slow motion"), 0.001, 1e9)] = 1.0
    persistence: Annotated[float, _drive(_("persistence"), 0.01, 100.0)] = 1.0
    vector_display: str = "teaching"
    paused: bool = False
    time_s: Annotated[float, _drive(_("time"), 0.0, LONGEST_TIME_S, "s")] = 0.0
    brightness: Annotated[float, _drive(_("brightness"), -0.5, 0.5)] = 0.0
    contrast: Annotated[float, _drive(_("contrast"), 0.0, 2.0)] = 1.0


class Look(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The camera that somebody looks around with, as long as that of the scene is still ``kept``."""

    camera: Camera
    kept: Camera


class SessionState(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Current sheet, selected and active figures (ids), the compared algorithm, the cursors, the tube.

    An empty ``sheet`` means the first one, an empty ``compare`` no comparison. ``workspace`` is the one that
    is stepped in, ``positions`` has what each of them steps, and where it stands. ``ask_first`` hides the
    next pixel until it was guessed. ``pixel`` (x, y) is the one that is asked about, in a picture of
    ``pixel_of``: why is it as it is.
    ``thing`` is the chosen object of a scene, ``looks`` (by sheet) tell where somebody looks from instead of
    the scene's camera. ``frames`` (by sheet) are those that are shown, 0 where none is given;
    with ``auto_key`` whatever is changed in one gets a key there.
    """

    sheet: str = ""
    selection: tuple[str, ...] = ()
    active: str = ""
    compare: str = ""
    workspace: str = ""
    positions: dict[str, Position] = {}
    ask_first: bool = False
    pixel: tuple[int, int] | None = None
    pixel_of: str = FIGURES
    tube: TubeSettings = TubeSettings()
    thing: str = ""
    looks: dict[str, Look] = {}
    frames: dict[str, int] = {}
    auto_key: bool = False

    @property
    def position(self) -> Position:
        """What is stepped in the present workspace, and where that stands."""
        return self.positions.get(self.workspace, Position())

    @property
    def subject(self) -> Subject:
        """What is stepped in the present workspace."""
        return self.position.subject

    @property
    def step(self) -> int:
        """The step in the present workspace."""
        return self.position.step

    @property
    def detail(self) -> bool:
        """Whether lines are counted in the present workspace."""
        return self.position.detail

    def asked(self, of: str) -> tuple[int, int] | None:
        """The pixel (x, y) that is asked about in a picture of this; None where there is none."""
        return self.pixel if self.pixel_of == of else None


def seen_scene(state: SessionState, sheet: Sheet) -> Scene | None:
    """The scene of ``sheet`` as it is seen now, with the camera of whoever looks around in it."""
    scene, look = sheet.scene, state.looks.get(sheet.id)
    if scene is None or look is None or look.kept != scene.camera:
        return scene
    return replace(scene, camera=look.camera)


def as_seen(state: SessionState, sheet: Sheet) -> Sheet:
    """``sheet`` with its scene seen as it is now; itself where nobody looks around in it."""
    scene = seen_scene(state, sheet)
    return sheet if scene is sheet.scene else _with_scene(sheet, scene)


@lru_cache(maxsize=4)
def _with_scene(sheet: Sheet, scene: Scene | None) -> Sheet:
    """One and the same sheet as long as nobody looks elsewhere."""
    return replace(sheet, scene=scene)


def with_look(state: SessionState, sheet: Sheet, camera: Camera | None) -> dict[str, Look]:
    """The looks of ``state``, with ``camera`` at the scene of this sheet, or with None the scene's own."""
    kept = {name: look for name, look in state.looks.items() if name != sheet.id}
    if camera is None or sheet.scene is None or camera == sheet.scene.camera:
        return kept
    return {**kept, sheet.id: Look(camera, sheet.scene.camera)}


def with_changes(state: SessionState, **changes: Any) -> SessionState:
    """``state`` with other values; ``subject``, ``step`` and ``detail`` are those of its workspace.

    The question about a pixel ends with its sheet; without ``pixel_of`` it is about the figures.
    """
    if "pixel" in changes:
        changes = {"pixel_of": FIGURES, **changes}
    here = {name: changes.pop(name) for name in Position.__struct_fields__ if name in changes}
    before, state = state, replace(state, **changes)
    if "pixel" not in changes and state.sheet != before.sheet:
        state = replace(state, pixel=None)
    position = replace(state.position, **here)
    if position == state.position:
        return state
    return replace(state, positions={**state.positions, state.workspace: position})


def at_the_start(state: SessionState) -> SessionState:
    """``state`` with every run of the active figure before its first step, since that is another one."""
    positions = {
        workspace: position if position.subject.ids else replace(position, step=0)
        for workspace, position in state.positions.items()
    }
    return state if positions == state.positions else replace(state, positions=positions)


def check_state(state: SessionState, document: Document) -> SessionState:
    """``state`` itself when all it refers to is in ``document``; raises DocumentError with the field."""
    figures = {figure.id for sheet in document.sheets for figure in sheet.figures}
    if state.sheet and all(sheet.id != state.sheet for sheet in document.sheets):
        raise refuse("session.sheet", missing(state.sheet))
    for index, figure in enumerate(state.selection):
        if figure not in figures:
            raise refuse(f"session.selection[{index}]", missing(figure))
    if state.active and state.active not in figures:
        raise refuse("session.active", missing(state.active))
    if state.compare and not is_word(state.compare):
        raise refuse(
            "session.compare", _("is {value}, which is not a name").format(value=shown(state.compare))
        )
    if state.pixel is not None and not all(0 <= side < MAX_SIDE_PX for side in state.pixel):
        problem = _("is {value}; give a column and a row from 0")
        raise refuse("session.pixel", problem.format(value=shown(state.pixel)))
    if not is_word(state.pixel_of):
        raise refuse("session.pixel_of", _("is not the name of a workspace; give one such as draw"))
    if state.thing and state.thing not in _objects(document):
        raise refuse("session.thing", missing(state.thing))
    for sheet_id, look in state.looks.items():
        if all(sheet.id != sheet_id for sheet in document.sheets):
            raise refuse("session.looks", missing(sheet_id))
        check_part(look, f"session.looks.{sheet_id}")
    for sheet_id, frame in state.frames.items():
        if all(sheet.id != sheet_id for sheet in document.sheets):
            raise refuse("session.frames", missing(sheet_id))
        if not 0 <= frame < MAX_FRAMES:
            problem = _("is {value}; give a frame from 0 to {last}")
            raise refuse(
                f"session.frames.{sheet_id}", problem.format(value=shown(frame), last=MAX_FRAMES - 1)
            )
    for workspace in (state.workspace, *state.positions):
        if workspace and not is_word(workspace):
            raise refuse("session.workspace", _("is not the name of a workspace; give one such as draw"))
    ids = _ids_for(state, document)
    for workspace, position in state.positions.items():
        if fault := fault_in(position, ids):
            raise refuse(f"session.positions.{workspace}.{fault[0]}", fault[1])
    if not state.tube.phosphor.isalnum() or len(state.tube.phosphor) > 32:
        raise refuse("session.tube.phosphor", _("is not a name; give one such as P31"))
    if len(state.tube.vector_display) > 32:
        raise refuse("session.tube.vector_display", _("is not a name; give one such as teaching"))
    for name, number in numbers_of(TubeSettings).items():
        if problem := number_problem(number, getattr(state.tube, name)):
            raise refuse(f"session.tube.{name}", problem)
    return state


def cleaned(state: SessionState, document: Document) -> SessionState:
    """``state`` without what is no longer in ``document``; the same object when nothing is missing."""
    figures = {figure.id for sheet in document.sheets for figure in sheet.figures}
    sheet = (
        state.sheet if any(known.id == state.sheet for known in document.sheets) else document.sheets[0].id
    )
    selection = tuple(figure for figure in state.selection if figure in figures)
    active = state.active if state.active in figures else ""
    if active != state.active:
        state = at_the_start(state)
    ids = _ids_for(state, document)
    positions = {
        workspace: there if ids.issuperset(there.subject.ids) else Position(replace(there.subject, ids=()))
        for workspace, there in state.positions.items()
    }
    left = replace(
        state,
        sheet=sheet,
        selection=selection,
        active=active,
        positions=positions,
        pixel=state.pixel if state.sheet in ("", sheet) else None,
        thing=state.thing if not state.thing or state.thing in _objects(document) else "",
        looks=_on_sheets(state.looks, document),
        frames=_on_sheets(state.frames, document),
    )
    return state if left == state else left


def _objects(document: Document) -> frozenset[str]:
    return frozenset(each.id for sheet in document.sheets if sheet.scene for each in sheet.scene.objects)


def _on_sheets(by_sheet: dict[str, T], document: Document) -> dict[str, T]:
    """What is of the sheets that there are."""
    if not by_sheet:
        return by_sheet
    sheets = {sheet.id for sheet in document.sheets}
    return {sheet: value for sheet, value in by_sheet.items() if sheet in sheets}


def _ids_for(state: SessionState, document: Document) -> frozenset[str]:
    """The ids that the subjects of ``state`` may name; none of many where they name none."""
    named = any(position.subject.ids for position in state.positions.values())
    return frozenset(all_ids(document.sheets)) if named else frozenset()
