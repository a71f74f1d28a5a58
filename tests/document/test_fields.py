"""Every number of the document is declared once, and edits, files and addresses keep to what is declared."""

import json
import math
from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, NamedTuple

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

from tests.document.views import seen_through
from workbench.document import DocumentError, Stored, edits
from workbench.document.addresses import changed, declared_at, parse, resolve
from workbench.document.check import check
from workbench.document.fields import Choice, Number, fields_of, numbers_of, parts_of, structs_in
from workbench.document.model import (
    Circle,
    Curve,
    CurvePoint,
    Document,
    Ellipse,
    Figure,
    Knot,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    SeedFill,
    WorldPoint,
)
from workbench.document.motion.model import Motion
from workbench.document.samples.examples import blank_sheet
from workbench.document.scene.model import Scene
from workbench.document.state import SessionState as State
from workbench.document.state import TubeSettings, check_state
from workbench.document.storage.files import decode, encode
from workbench.document.transforms.links import Affine, Reflect, Rotate, Scale, Shear, Translate

# What a scene is made of has laws of its own, in ``scene/test_scene.py``.
PICTURE = [kind for kind in structs_in(Document) if kind not in structs_in(Scene) | structs_in(Motion)]
STRUCTS = [*PICTURE, TubeSettings]
# The sides that cannot lie at that end of their range, since the other side would have to lie beyond it.
WITHOUT_EXTENT = {("xmin", 1), ("ymin", 1), ("xmax", 0), ("ymax", 0)}


def _points(name: str, *places: tuple[float, float]) -> tuple[WorldPoint, ...]:
    return tuple(WorldPoint(f"{name}p{k}", x, y) for k, (x, y) in enumerate(places))


def everything() -> Document:
    """A document that holds every kind of struct, and in every list something."""
    corners = ((1.0, 1.0), (9.0, 1.0), (5.0, 8.0))
    controls = [CurvePoint(f"c{k}", k * 4.0, k % 2 * 3.0, 2.0, 1.0, -1.0) for k in range(3)]
    chain = (
        Translate("t1", tx=2.0, ty=1.0),
        Rotate("t2", angle=30.0),
        Scale("t3", sx=2.0),
        Reflect("t4", angle=90.0),
        Shear("t5", sh_x=0.5),
        Affine("t6", m11=2.0),
    )
    figures = (
        Line("f1", _points("f1", *corners[:2]), "dda_line", transforms=chain),
        Polyline("f2", _points("f2", *corners), "bresenham_line"),
        Polygon("f3", _points("f3", *corners), "scan_line_exact", ring_ends=(3,)),
        Circle("f4", _points("f4", corners[0]), "midpoint_circle", radius_world=3.0),
        Ellipse("f5", _points("f5", corners[0]), "midpoint_ellipse", radius_x_world=3.0, radius_y_world=2.0),
        SeedFill("f6", _points("f6", corners[0]), "boundary_fill_4"),
        Curve(
            "f7",
            tuple(controls),
            "bresenham_line",
            spline="nurbs",
            degree=1,
            knot_rule="free",
            knots=tuple(Knot(f"k{k}", float(k)) for k in range(5)),
        ),
        Curve("f8", tuple(replace(p, id=f"d{k}") for k, p in enumerate(controls)), "bresenham_line"),
    )
    seen = seen_through(blank_sheet().sheets[0], clip_world=Rectangle(0.0, 0.0, 5.0, 5.0))
    sheet = replace(seen, figures=figures, palette=(0, 1, 2))
    return check(Document((sheet,)))


class Place(NamedTuple):
    """Where in a document a number is: names and indices down to it, and its address."""

    path: tuple[str | int, ...]
    address: str
    number: Number
    value: Any

    @property
    def field(self) -> str:
        """The path as a refusal gives it."""
        return "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in self.path)[1:]


def numbers_in(holder: Any, path: tuple[str | int, ...] = (), address: str = "") -> Iterator[Place]:
    """Every number below ``holder``."""
    for name, (kind, many) in fields_of(type(holder)).items():
        value = getattr(holder, name)
        for index, entry in enumerate(value) if many else [(None, value)]:
            here = (*path, name) if index is None else (*path, name, index)
            text = f"{address}{name}" if index is None else f"{address}{name}.{index}"
            if isinstance(kind, Number):
                yield Place(here, text, kind, entry)
            elif kind is msgspec.Struct and entry is not None:
                part = many and f"{address}{entry.id}/"
                yield from numbers_in(entry, here, part or f"{text}.")


PLACES = list(numbers_in(everything()))


def test_every_number_is_in_the_document_that_holds_everything() -> None:
    declared = {(kind, name) for kind in PICTURE for name in numbers_of(kind)}
    document = everything()
    holders = [_at(document, place.path[: -2 if isinstance(place.path[-1], int) else -1]) for place in PLACES]
    names = [next(key for key in reversed(place.path) if isinstance(key, str)) for place in PLACES]
    assert {(type(holder), name) for holder, name in zip(holders, names, strict=True)} == declared
    assert len(declared) > 30


def _at(value: Any, path: tuple[str | int, ...]) -> Any:
    for key in path:
        value = value[key] if isinstance(key, int) else getattr(value, key)
    return value


@pytest.mark.parametrize("struct", STRUCTS, ids=lambda struct: struct.__name__)
def test_every_number_says_what_it_may_be(struct: type) -> None:
    for name, number in numbers_of(struct).items():
        assert number.label, name
        assert type(number.keyed) is bool
        bounded = not number.whole or not (number.indexes or name == "ring_ends")
        assert (math.isfinite(number.low) and math.isfinite(number.high)) == bounded, name
        assert number.low < number.high


def test_a_number_that_is_not_declared_or_declared_as_another_is_refused() -> None:
    whole = Number(label="n", whole=True, keyed=False)
    hints: list[Any] = [int, float, Annotated[float, whole], Annotated[int, Choice(("a",))]]
    for hint in [*hints, tuple[int, ...], int | None, Annotated[int, msgspec.Meta(ge=0)]]:
        with pytest.raises(TypeError, match=r"Bare\.n"):
            fields_of(msgspec.defstruct("Bare", [("n", hint)]))
    fields_of(msgspec.defstruct("Bare", [("n", Annotated[int, whole])]))
    with pytest.raises(TypeError):
        Number(label="n")  # type: ignore[call-arg]


def test_a_key_frame_hangs_on_what_may_lie_between_two_values() -> None:
    keyed = {name for kind in STRUCTS for name, number in numbers_of(kind).items() if number.keyed}
    sides = {"xmin", "ymin", "xmax", "ymax"}
    radii = {"radius_world", "radius_x_world", "radius_y_world"}
    of_curves = {"weight", "tangent_x", "tangent_y", "u", "tension", "continuity", "bias", "alpha"}
    of_links = {"tx", "ty", "angle", "x_pivot", "y_pivot", "sx", "sy", "sh_x", "sh_y", "x_ref", "y_ref"}
    entries = {"m11", "m12", "m13", "m21", "m22", "m23"}
    assert keyed == {"x", "y"} | sides | radii | of_curves | of_links | entries


def test_a_field_has_one_label_wherever_it_is() -> None:
    names: dict[str, set[str]] = {}
    for kind in structs_in(Document):
        for name, number in numbers_of(kind).items():
            names.setdefault(name, set()).add(number.label)
    assert all(len(labels) == 1 for labels in names.values())


def ends(place: Place) -> tuple[Any, Any, Any, Any]:
    """The least and the most that a number may be, and what lies just beyond them."""
    number = place.number
    low, high = (0, 2) if number.indexes else (number.low, number.high)
    if number.whole:
        return int(low), int(high), int(low) - 1, int(high) + 1
    return low, high, math.nextafter(low, -math.inf), math.nextafter(high, math.inf)


def by_edit(place: Place, value: Any) -> Document:
    if place.address == "last_id":
        return check(replace(everything(), last_id=value))
    return edits.set_attribute(place.address, value)(everything())


def by_file(place: Place, value: Any) -> Document:
    text = json.loads(encode(Stored(everything())))
    holder = text["document"]
    for key in place.path[:-1]:
        holder = holder[key]
    holder[place.path[-1]] = value
    return decode(json.dumps(text).encode()).document


BOUNDED = [p for p in PLACES if p.number.indexes or math.isfinite(p.number.low)]


@pytest.mark.parametrize("place", BOUNDED, ids=lambda place: place.address)
def test_the_ends_of_a_range_are_accepted_and_what_lies_beyond_is_refused(place: Place) -> None:
    name = place.address.rpartition("/")[2].rpartition(".")[2]
    before = everything().sheets[0].figures[6].knots  # type: ignore[union-attr]
    *good, below, above = ends(place)
    for change in (by_edit, by_file):
        for bad in (below, above):
            with pytest.raises(DocumentError) as refusal:
                change(place, bad)
            assert refusal.value.field == place.field
            assert refusal.value.short.startswith(f"The {place.number.label} is {bad!r}")
        for end, value in enumerate(good):
            knots_decrease = name == "u" and place.path[-2] != (len(before) - 1 if end else 0)
            too_many_knots = name == "degree" and place.path[3] == 6 and value != 1
            if (name, end) in WITHOUT_EXTENT or knots_decrease or too_many_knots:
                with pytest.raises(DocumentError, match=r"has no|must not decrease|add what is missing"):
                    change(place, value)
            else:
                spent = name == "last_id" and change is by_file and value > 0  # ids are given anew
                assert _at(change(place, value), place.path) == (0 if spent else value)


@pytest.mark.parametrize(
    "place", [p for p in PLACES if p.address != "last_id"], ids=lambda place: place.address
)
def test_a_number_has_one_address_that_tells_what_is_declared_and_what_changed(place: Place) -> None:
    document = everything()
    field = declared_at(document, place.address)
    assert (field.kind, field.many) == (place.number, False)
    assert resolve(document, place.address) == place.value
    other = _with(document, place.path, place.value + 1)
    assert changed(document, other) == {parse(place.address)}


def _with(holder: Any, path: tuple[str | int, ...], value: Any) -> Any:
    if not path:
        return value
    key, *rest = path
    if isinstance(key, int):
        return (*holder[:key], _with(holder[key], tuple(rest), value), *holder[key + 1 :])
    return replace(holder, **{key: _with(getattr(holder, key), tuple(rest), value)})


@pytest.mark.parametrize("kind", [float, np.float64, np.float32])
def test_what_is_added_has_numbers_of_python_whatever_they_were(kind: type) -> None:
    document = everything()
    for index, figure in enumerate(document.sheets[0].figures):
        strange: Figure = figure
        for place in numbers_in(figure):
            strange = _with(strange, place.path, (np.int16 if place.number.whole else kind)(place.value))
        added = edits.add_figures("s1", [strange])(document).sheets[0].figures[-1]  # type: ignore[list-item]
        assert [type(p.value) for p in numbers_in(added)] == [p.number.type for p in numbers_in(added)]
        expected = [kind(p.value) for p in numbers_in(document.sheets[0].figures[index])]
        assert [p.value for p in numbers_in(added)] == expected


def test_a_list_of_parts_is_one_whose_entries_have_ids() -> None:
    parts = {(kind.__name__, name) for kind in PICTURE for name in parts_of(kind)}
    of_figures = {(kind.__name__, "points_world") for kind in PICTURE if issubclass(kind, Figure)}
    chains = {(name, "transforms") for name, _points in of_figures}
    of_sheets = {("Document", "sheets"), ("Sheet", "views"), ("Sheet", "figures")}
    assert parts == of_sheets | {("Curve", "knots")} | of_figures | chains


@pytest.mark.parametrize("name", numbers_of(TubeSettings))
def test_the_tube_keeps_to_the_same_ranges(name: str) -> None:
    document, number = everything(), numbers_of(TubeSettings)[name]
    low, high, below, above = ends(Place((name,), name, number, 0.0))
    for value in (low, high):
        state = State(tube=replace(TubeSettings(), **{name: value}))
        assert check_state(state, document) is state
    for value in (below, above, math.nan):
        with pytest.raises(DocumentError) as refusal:
            check_state(State(tube=replace(TubeSettings(), **{name: value})), document)
        assert refusal.value.field == f"session.tube.{name}"


class Mark(msgspec.Struct, frozen=True):
    """A part that no figure has."""

    letter: ClassVar[str] = "m"

    id: str
    at: Annotated[float, Number(label="place", low=0.0, high=1.0, keyed=True)]


class MarkedLine(Line, frozen=True, tag="marked_line"):
    """A kind of figure that no module knows, with parts that none knows."""

    marks: tuple[Mark, ...] = ()


def test_a_new_kind_of_part_needs_no_word_outside_its_struct() -> None:
    line = MarkedLine("", _points("", (0, 0), (5, 5)), "dda_line", marks=(Mark("", 0.5), Mark("", 0.75)))
    bare = replace(line, points_world=tuple(replace(p, id="") for p in line.points_world))
    marked: Any = bare
    document = edits.add_figure("s1", marked)(blank_sheet())
    (figure,) = document.sheets[0].figures
    assert [part.id for part in figure.parts] == ["p3", "p4", "m5", "m6"]
    moved = edits.set_attribute(f"s1/{figure.id}/m6/at", np.float32(1))(document)
    assert changed(document, moved) == {parse(f"s1/{figure.id}/m6/at")}
    assert resolve(moved, f"s1/{figure.id}/m6/at") == 1.0
    with pytest.raises(DocumentError) as refusal:
        edits.set_attribute(f"s1/{figure.id}/m6/at", 1.5)(document)
    assert refusal.value.field == "sheets[0].figures[0].marks[1].at"
    twice: Any = replace(figure, marks=(*figure.marks, figure.marks[0]))  # type: ignore[attr-defined, call-arg]
    with pytest.raises(DocumentError, match=r"marks\[2\]\.id is 'm5', which another one already has"):
        check(_with(document, ("sheets", 0, "figures", 0), twice), document)
