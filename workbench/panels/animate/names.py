"""What a person calls what a track moves, and the easings."""

from collections import Counter
from collections.abc import Iterable, Mapping

from workbench.algorithms.numerals import with_minus
from workbench.document.model import Sheet
from workbench.document.motion.groups import CAMERA, OUTLINE, WHOLE, Group, group_of, read, value_of
from workbench.document.motion.model import EASINGS
from workbench.document.transforms.names import title
from workbench.language import _
from workbench.panels.stage.card import kind_title

_MOST_NUMBERS = 3


def easing_titles() -> dict[str, str]:
    """The easings in the order of a menu."""
    titles = (
        _("Held"),
        _("Linear"),
        _("Ease in"),
        _("Ease out"),
        _("Ease in and out"),
        _("Cubic ease in"),
        _("Cubic ease out"),
        _("Cubic ease in and out"),
        _("Bézier"),
        _("Spline through keys"),
    )
    return dict(zip(EASINGS, titles, strict=True))


def owners_of(sheet: Sheet) -> dict[str, str]:
    """What figures and things are called, by their ids; of those with one name all but the first have a
    number, so that a copy and its original can be told apart."""
    called: dict[str, str] = {}
    for kind in (sheet.figures, sheet.things):
        times: Counter[str] = Counter()
        for each in kind:
            name = getattr(each, "name", "") or (kind_title(each) if kind is sheet.figures else each.id)
            times[name] += 1
            called[each.id] = name if times[name] == 1 else f"{name} {times[name]}"
    return called


def label_of(sheet: Sheet, target: str, owners: Mapping[str, str] | None = None) -> str:
    """What a target is called: of which figure, and what of it. ``owners`` are those of the sheet, where many
    targets are asked for."""
    name, *_between, attribute = target.split("/") if "/" in target else ("", target)
    owner = (owners_of(sheet) if owners is None else owners).get(name, name) or _("Camera")
    return f"{owner}, {_what(sheet, group_of(sheet, target), attribute)}"


def held_text(sheet: Sheet, held: Iterable[str]) -> str:
    """What is not as its track would have it in a frame: numbers at the end of their range, and figures,
    things or the camera that could not be drawn so; empty where all is."""
    numbers = [target for target in held if "/" in target or target.startswith(f"{CAMERA}.")]
    owners = {**owners_of(sheet), CAMERA: _("Camera")}
    things = [owners.get(each, each) for each in held if each not in numbers]
    told = []
    if numbers:
        what = ", ".join(label_of(sheet, target, owners) for target in numbers)
        told.append(_("{what}: held at the end of its range in this frame.").format(what=what))
    if things:
        what = ", ".join(dict.fromkeys(things))
        told.append(
            _(
                "{what}: its keys make something here that cannot be drawn, so it stays as the sheet has it."
            ).format(what=what)
        )
    return " ".join(told)


def _what(sheet: Sheet, group: Group | None, attribute: str) -> str:
    if group is None:
        return attribute
    if group.kind == "colour":
        return _("colour, RGB")
    if attribute == OUTLINE:
        return _("outline")
    if group.kind == "turn":
        return _("turn")
    point = _point_name(sheet, group)
    if attribute == WHOLE:
        return point or _("place")
    if len(group.slots) > 1:
        return attribute.rpartition(".")[2].replace("_", " ")
    number, path = group.slots[0].number, group.slots[0].path
    holder = read(sheet, path[:-1])
    if len(path) > 2 and "transforms" in path:
        return f"{title(holder).lower()} {number.symbol or number.label}"
    short = number.symbol if len(number.symbol) == 1 else number.label
    return _("{number} of {point}").format(number=short, point=point) if point else short


def _point_name(sheet: Sheet, group: Group) -> str:
    """Which of several points of a figure it is; empty where it is none, or the only one."""
    kind, at, *rest = group.slots[0].path
    if kind != "figures" or rest[0] != OUTLINE or len(sheet.figures[int(at)].points_world) < 2:
        return ""
    return f"P{rest[1]}"


def value_text(sheet: Sheet, target: str) -> str:
    """The value of a target as it is on a sheet, short."""
    group = group_of(sheet, target)
    if group is None:
        return ""
    value = value_of(sheet, group)
    if group.kind == "colour":
        return "#" + "".join(f"{round(channel):02X}" for channel in value)
    if target.endswith(OUTLINE):
        return _("{n} points").format(n=len(value) // 2)
    if group.kind == "turn":
        angle, *axis = value
        return f"{_rounded((angle,), 2)}° ({_rounded(axis, 1)})"
    numbers = _rounded(value[:_MOST_NUMBERS], {1: 6, 2: 3}.get(len(value), 1))
    more = ", …" if len(value) > _MOST_NUMBERS else ""
    return f"({numbers}{more})" if len(value) > 1 else numbers


def _rounded(numbers: Iterable[float], places: int) -> str:
    return with_minus(", ".join(f"{round(number, places):.6g}" for number in numbers))
