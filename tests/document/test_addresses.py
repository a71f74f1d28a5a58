"""An address finds its attribute whatever happens to the others."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.document.made_documents import documents, sound_edits
from workbench.document import DocumentError
from workbench.document.addresses import Address, changed, new_ids, parse, resolve
from workbench.document.check import ids
from workbench.document.edits import (
    insert_point,
    move_points,
    remove_figures,
    remove_point,
    reorder,
    set_attribute,
)
from workbench.document.model import AnyFigure, Document, Knot, Rectangle, Sheet, View, WorldPoint
from workbench.document.samples.examples import example_document, examples
from workbench.document.transforms.links import AnyLink


def everything(document: Document) -> dict[Address, object]:
    """Every attribute by its address, found by walking the document and not by ``resolve``."""
    found: dict[Address, object] = {}

    def walk(owner: Sheet | View | AnyFigure | WorldPoint | Knot | AnyLink, *place: str) -> None:
        for name in owner.__struct_fields__:
            value = getattr(owner, name)
            if name in ("views", "figures", "points_world", "knots", "transforms"):
                for item in value:
                    walk(item, *place, item.id)
            elif isinstance(value, Rectangle):
                for side in ("xmin", "ymin", "xmax", "ymax"):
                    found[_address(place, f"{name}.{side}")] = getattr(value, side)
            elif isinstance(value, tuple):
                found.update({_address(place, f"{name}.{i}"): part for i, part in enumerate(value)})
            elif name != "id":
                found[_address(place, name)] = value

    for sheet in document.sheets:
        walk(sheet, sheet.id)
    return found


def _address(place: tuple[str, ...], attribute: str) -> Address:
    return Address(*(*place, "", "")[:3], attribute)


@given(documents())
def test_every_attribute_is_found_by_its_address_as_text(document: Document) -> None:
    for address, value in everything(document).items():
        assert parse(str(address)) == address
        assert resolve(document, str(address)) is value


@settings(max_examples=40)
@given(st.data(), documents())
def test_an_address_survives_edits_of_everything_else(data: st.DataObject, document: Document) -> None:
    for _turn in range(3):
        before = everything(document)
        try:
            new = data.draw(sound_edits(document))(document)
        except DocumentError:
            continue
        after = everything(new)
        told = changed(document, new)
        for address in before.keys() & after.keys():
            assert resolve(new, address) == after[address]
            if address not in told and Address(*_above(address), attribute=_first(address)) not in told:
                assert after[address] == before[address]
        document = new


def _above(address: Address) -> tuple[str, str, str]:
    return address.sheet, address.figure, address.point


def _first(address: Address) -> str:
    return address.attribute.partition(".")[0]


@given(st.data(), documents())
def test_changed_names_what_differs_and_nothing_else(data: st.DataObject, old: Document) -> None:
    try:
        new = data.draw(sound_edits(old))(old)
    except DocumentError:
        return
    told = changed(old, new)
    assert bool(told) == (old.sheets != new.sheets)
    before, after = everything(old), everything(new)
    different = {address for address in before.keys() & after.keys() if before[address] != after[address]}
    assert different <= told
    # Whatever else is told is a list's order or something that came or went.
    for address in told - different:
        lists = (
            "sheets",
            "figures",
            "points_world",
            "palette",
            "ring_ends",
            "knots",
            "beside",
            "views",
            "transforms",
        )
        assert address.attribute in ("*", "clip_world", *lists)
    for address in before.keys() ^ after.keys():
        assert any(
            up in told
            for up in (
                Address(address.sheet),
                Address(address.sheet, address.figure),
                Address(address.sheet, address.figure, address.point),
                Address(*_above(address), attribute=_first(address)),
            )
        )


@settings(max_examples=40)
@given(st.data(), documents())
def test_no_id_is_given_twice(data: st.DataObject, document: Document) -> None:
    seen = {identity for _path, identity in ids(document)}
    for _turn in range(4):
        present = {identity for _path, identity in ids(document)}
        try:
            document = data.draw(sound_edits(document))(document)
        except DocumentError:
            continue
        added = {identity for _path, identity in ids(document)} - present
        assert not added & seen
        seen |= added


def test_moving_inserting_and_removing_others_in_words() -> None:
    house = next(one.document for one in examples() if one.slug == "house")
    walls = house.sheets[0].figures[1]
    corner = walls.points_world[2]
    address = f"s1/{walls.id}/{corner.id}/x"
    assert resolve(house, address) == 42.0
    house = insert_point(walls.id, 0, 1.0, 1.0)(house)
    house = remove_point(f"s1/{walls.id}/{walls.points_world[0].id}/*")(house)
    house = remove_figures([house.sheets[0].figures[0].id])(house)
    house = reorder(walls.id, 5)(house)
    assert resolve(house, address) == 42.0
    assert resolve(move_points({address: (7.0, 24.0)})(house), address) == 7.0
    assert resolve(set_attribute(address, 9)(house), address) == 9.0


def test_a_removed_figures_id_is_not_given_again() -> None:
    document = example_document()
    removed = remove_figures(["f1"])(document)
    assert new_ids(removed, "f", 2) == ["f3", "f4"]


@pytest.mark.parametrize(
    "text",
    ["", "/", "s1/", "s1/f1/p1/x/y", "s9/name", "s1/f9/colour", "s1/f1/p9/x", "s1/f1/p1/z", "s1/palette.99"],
)
def test_an_address_that_leads_nowhere_is_refused(text: str) -> None:
    with pytest.raises(DocumentError):
        resolve(example_document(), text)
