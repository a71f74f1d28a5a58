"""What a track hangs on: the numbers that its target names on a sheet, read and written."""

from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any, Literal, NamedTuple

import msgspec
from msgspec.structs import replace

from workbench.document.fields import Number, fields_of
from workbench.document.model import Figure, Polygon, Polyline, Sheet, WorldPoint
from workbench.document.scene.links import Rotate3D
from workbench.document.scene.model import SpacePoint
from workbench.language import _

CAMERA = "scene.camera"
OUTLINE, COLOUR = "points_world", "colour"
WHOLE = "*"
_TURN = ("angle", "x_axis", "y_axis", "z_axis")
_PLACES: dict[type, tuple[str, ...]] = {WorldPoint: ("x", "y"), SpacePoint: ("x", "y", "z")}

_CHANNEL = Number(label=_("colour"), low=0.0, high=255.0, keyed=True)

Kind = Literal["numbers", "outline", "colour", "turn"]
Path = tuple[str | int, ...]


class Slot(NamedTuple):
    """One number of a group: where it stands, from the sheet down, and what it may be."""

    path: Path
    number: Number


class Group(NamedTuple):
    """The numbers of a target. ``kind`` tells what is between two keys other than each number by itself.

    Of an "outline" keys may have other numbers of points; a "colour" is red, green and blue, 0 to 255, of a
    place in the palette; a "turn" is an angle (degrees) and an axis.
    """

    kind: Kind
    slots: tuple[Slot, ...]


@lru_cache(maxsize=8)
def _things(sheet: Sheet) -> Mapping[str, Path]:
    """Where each figure and each thing of the scene stands."""
    places: dict[str, Path] = {figure.id: ("figures", at) for at, figure in enumerate(sheet.figures)}
    if sheet.scene is not None:
        for name in ("objects", "materials", "lights"):
            places |= {thing.id: ("scene", name, at) for at, thing in enumerate(getattr(sheet.scene, name))}
    return places


@lru_cache(maxsize=1 << 10)
def _parts(thing: Any) -> Mapping[str, Path]:
    """Where each part of a figure or of a thing stands in it."""
    return {
        part.id: (name, at)
        for name, field in fields_of(type(thing)).items()
        if field.many and field.kind is msgspec.Struct
        for at, part in enumerate(getattr(thing, name))
    }


def read(holder: Any, path: Path) -> Any:
    """What stands at ``path`` in a struct or a list."""
    for step in path:
        holder = holder[step] if isinstance(step, int) else getattr(holder, step)
    return holder


def written(holder: Any, path: Path, value: Any) -> Any:
    """``holder`` with ``value`` at ``path``."""
    if not path:
        return value
    step, below = path[0], path[1:]
    if isinstance(step, int):
        return (*holder[:step], written(holder[step], below, value), *holder[step + 1 :])
    return replace(holder, **{step: written(getattr(holder, step), below, value)})


def group_of(sheet: Sheet, target: str) -> Group | None:
    """The numbers that ``target`` names on ``sheet``; None where there are none that can be keyed."""
    if target == CAMERA or target.startswith(f"{CAMERA}."):
        if sheet.scene is None:
            return None
        return _numbers(sheet, ("scene", "camera"), target[len(CAMERA) + 1 :] or WHOLE)
    name, *between = target.split("/")
    thing_path = _things(sheet).get(name)
    if thing_path is None or not 1 <= len(between) <= 2:
        return None
    *between, attribute = between
    thing = read(sheet, thing_path)
    if not between:
        if isinstance(thing, Figure) and attribute in (OUTLINE, COLOUR):
            return _outline(thing, thing_path) if attribute == OUTLINE else _colour(thing_path)
        return None if attribute == WHOLE else _numbers(sheet, thing_path, attribute)
    part_path = _parts(thing).get(between[0])
    return None if part_path is None else _numbers(sheet, (*thing_path, *part_path), attribute)


def _outline(figure: Figure, path: Path) -> Group:
    declared = fields_of(WorldPoint)
    slots = tuple(
        Slot((*path, OUTLINE, at, name), declared[name].kind)
        for at in range(len(figure.points_world))
        for name in _PLACES[WorldPoint]
    )
    free = isinstance(figure, Polyline) or (isinstance(figure, Polygon) and not figure.ring_ends)
    return Group("outline" if free else "numbers", slots)


def _colour(path: Path) -> Group:
    return Group("colour", tuple(Slot((*path, COLOUR), _CHANNEL) for _channel in range(3)))


def _numbers(sheet: Sheet, path: Path, attribute: str) -> Group | None:
    """The number with this name, or all that stand below it, in their order."""
    steps: Path = tuple(attribute.split(".")) if attribute != WHOLE else ()
    holder = read(sheet, path)
    for step in steps[:-1]:
        field = fields_of(type(holder)).get(str(step)) if isinstance(holder, msgspec.Struct) else None
        if field is None or field.many or field.kind is not msgspec.Struct:
            return None
        holder = getattr(holder, str(step))
    if steps:
        field = fields_of(type(holder)).get(str(steps[-1])) if isinstance(holder, msgspec.Struct) else None
        if field is None or field.many:
            return None
        if isinstance(field.kind, Number):
            return Group("numbers", (Slot((*path, *steps), field.kind),)) if field.kind.keyed else None
        holder = getattr(holder, str(steps[-1]))
        if field.kind is not msgspec.Struct or holder is None:
            return None
    kind: Kind = "turn" if isinstance(holder, Rotate3D) else "numbers"
    slots = tuple(_below(holder, (*path, *steps), kind))
    return Group(kind, slots) if slots else None


def _below(holder: Any, path: Path, kind: Kind) -> Iterator[Slot]:
    """The numbers of a struct that can be keyed: of a point its place, of a turn its angle and axis."""
    places = next((names for base, names in _PLACES.items() if isinstance(holder, base)), None)
    names = _TURN if kind == "turn" else places
    for name, field in fields_of(type(holder)).items():
        if field.many or (names is not None and name not in names):
            continue
        if isinstance(field.kind, Number) and field.kind.keyed:
            yield Slot((*path, name), field.kind)
        elif field.kind is msgspec.Struct and getattr(holder, name) is not None:
            yield from _below(getattr(holder, name), (*path, name), kind)


def value_of(sheet: Sheet, group: Group) -> tuple[float, ...]:
    """The numbers of a group as they are on ``sheet``."""
    if group.kind == "colour":
        index = read(sheet, group.slots[0].path)
        return channels(sheet.palette[index % len(sheet.palette)])
    return tuple(float(read(sheet, slot.path)) for slot in group.slots)


def channels(colour: int) -> tuple[float, float, float]:
    """Red, green and blue, 0 to 255, of 0xRRGGBB."""
    return float(colour >> 16), float(colour >> 8 & 0xFF), float(colour & 0xFF)


def packed(red: float, green: float, blue: float) -> int:
    """0xRRGGBB of red, green and blue, held in 0 to 255."""
    r, g, b = (int(min(max(channel, 0.0), 255.0) + 0.5) for channel in (red, green, blue))
    return r << 16 | g << 8 | b
