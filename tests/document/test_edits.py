"""Edits give sound documents or refuse, and never touch what they are given."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.made_documents import documents, figures, sound_edits
from workbench.document import DocumentError, edits
from workbench.document.addresses import resolve
from workbench.document.building import without_ids
from workbench.document.check import check
from workbench.document.faults import shown
from workbench.document.model import Circle, Document, Line, Polygon, Rectangle, SeedFill, WorldPoint
from workbench.document.samples.examples import blank_sheet, example, example_document
from workbench.document.storage.files import Stored, encode

BAD_NUMBERS = [math.nan, math.inf, -math.inf, 1.0000001e6, -1e300, "7", None, True, 10**400, 10**5000, 1j]


@given(st.data(), documents())
def test_an_edit_gives_a_sound_document_and_leaves_the_old_one(
    data: st.DataObject, document: Document
) -> None:
    before = encode(Stored(document))
    try:
        new = data.draw(sound_edits(document))(document)
    except DocumentError:
        pass
    else:
        assert check(new) is new
    assert encode(Stored(document)) == before


@pytest.mark.parametrize("value", BAD_NUMBERS, ids=shown)
def test_numbers_that_are_none_are_refused_with_their_field(value: Any) -> None:
    circles = example("circles").document
    tried = {
        edits.move_points({"s1/f1/p1/x": (value, 1.0)}): "sheets[0].figures[0].points_world[0].x",
        edits.move_points({"s1/f1/p1/y": (1.0, value)}): "sheets[0].figures[0].points_world[0].y",
        edits.set_window("v1", Rectangle(value, 0.0, 1.0, 1.0)): "sheets[0].views[0].window_world.xmin",
        edits.set_viewport("v1", Rectangle(0.0, 0.0, 1.0, value)): "sheets[0].views[0].viewport_device.ymax",
        edits.set_sheet_size("s1", value, 10): "sheets[0].width_px",
    }
    for edit, field in tried.items():
        with pytest.raises(DocumentError) as refusal:
            edit(circles)
        assert refusal.value.field == field
        assert str(refusal.value).startswith(field)
    others = [edits.move_figures(["f1"], value, 0.0), edits.duplicate_figures(["f1"], 0.0, value)]
    for address in ("s1/f1/radius_world", "s1/f1/p1/x", "s1/f3/radius_x_world", "s1/v1/window_world.xmin"):
        others.append(edits.set_attribute(address, value))
    for edit in others:
        with pytest.raises(DocumentError):
            edit(circles)


@pytest.mark.parametrize(
    ("edit", "field"),
    [
        (edits.set_attribute("s1/f1/radius_world", -1), "sheets[0].figures[0].radius_world"),
        (edits.set_attribute("s1/f3/radius_y_world", -0.5), "sheets[0].figures[2].radius_y_world"),
        (edits.set_attribute("s1/f1/colour", 8), "sheets[0].figures[0].colour"),
        (edits.set_attribute("s1/f1/colour", -1), "sheets[0].figures[0].colour"),
        (edits.set_attribute("s1/background", 99), "sheets[0].background"),
        (edits.set_algorithm("f1", "bresenham_line"), "sheets[0].figures[0].algorithm"),
        (edits.set_algorithm("f1", "no_such_thing"), "sheets[0].figures[0].algorithm"),
        (edits.set_sheet_size("s1", 4097, 10), "sheets[0].width_px"),
        (edits.set_sheet_size("s1", 10, 0), "sheets[0].height_px"),
        (edits.set_sheet_size("s1", -10, 10), "sheets[0].width_px"),
        (edits.set_window("v1", Rectangle(4.0, 0.0, 4.0, 1.0)), "sheets[0].views[0].window_world"),
        (edits.set_viewport("v1", Rectangle(4.0, 3.0, 5.0, 1.0)), "sheets[0].views[0].viewport_device"),
        (edits.set_palette("s1", [0, 1, 2]), "sheets[0].figures[1].colour"),
        (edits.set_palette("s1", [0] * 7 + [-1]), "sheets[0].palette[7]"),
        (edits.set_palette("s1", [0]), "sheets[0].palette"),
        (edits.remove_sheet("s1"), "sheets"),
        (edits.rename_sheet("s1", "x" * 201), "sheets[0].name"),
        (edits.rename_figure("f1", "\ud800"), "sheets[0].figures[0].name"),
        (edits.remove_figures(["f9"]), "f9"),
        (edits.reorder("f1", 9), "figures"),
        (edits.insert_point("f1", 0, 1.0, 1.0), "f1"),
        (edits.add_sheet(blank_sheet().sheets[0], 7), "sheets"),
        (edits.set_attribute("s1/f1/name", 3), "s1/f1/name"),
        (edits.set_attribute("s1/f1/visible", 1), "s1/f1/visible"),
        (edits.set_attribute("s1/f1/colour", 1.5), "s1/f1/colour"),
        (edits.set_attribute("s1/f1/id", "f7"), "s1/f1/id"),
        (edits.set_attribute("s1/f1/points_world", ()), "s1/f1/points_world"),
        (edits.set_attribute("s1/f1/*", 1), "s1/f1/*"),
        (edits.add_figure("s1", Line("f1", (), "dda_line")), "sheets[0].figures[3].points_world"),
    ],
)
def test_what_would_not_be_sound_is_refused_in_one_sentence(edit: edits.Edit, field: str) -> None:
    circles = example("circles").document
    with pytest.raises(DocumentError) as refusal:
        edit(circles)
    error = refusal.value
    assert error.field == field
    assert str(error).endswith(".")
    assert "!" not in str(error)
    assert "\n" not in str(error)
    assert error.short.endswith(".")


def test_an_id_that_is_taken_is_refused() -> None:
    again = Line("f1", (WorldPoint("p8", 0.0, 0.0), WorldPoint("p9", 1.0, 1.0)), "dda_line")
    with pytest.raises(DocumentError) as refusal:
        edits.add_figure("s1", again)(example_document())
    assert refusal.value.field == "sheets[0].figures[1].id"


@given(figures())
def test_a_figure_without_ids_gets_new_ones(figure: Any) -> None:
    document = edits.add_figure("s1", figure)(example_document())
    added = document.sheets[0].figures[-1]
    assert added.id == "f3"
    assert [point.id for point in added.points_world] == [f"p{4 + i}" for i in range(len(added.points_world))]


def test_a_radius_of_nothing_is_a_pixel() -> None:
    document = edits.set_attribute("s1/f1/radius_world", 0)(example("circles").document)
    assert resolve(document, "s1/f1/radius_world") == 0.0


def test_numbers_of_any_type_become_plain() -> None:
    circle = Circle(
        "", (WorldPoint("", np.float32(1.5), np.int64(2)),), "midpoint_circle", radius_world=np.float64(3)
    )
    document = edits.add_figure("s1", circle)(example_document())
    document = edits.set_attribute("s1/f3/colour", np.int64(2))(document)
    document = edits.move_points({"s1/f1/p1/x": (np.float64(4), np.float32(5))})(document)
    assert check(document) is document
    assert encode(Stored(document))


def test_several_figures_are_moved_and_copied_at_once() -> None:
    star = example("octants").document
    wanted = [figure.id for figure in star.sheets[0].figures[:3]]
    moved = edits.move_figures(wanted, 2, -3)(star)
    for old, new in zip(star.sheets[0].figures, moved.sheets[0].figures, strict=True):
        dx, dy = (2, -3) if old.id in wanted else (0, 0)
        assert [(p.x + dx, p.y + dy) for p in old.points_world] == [(p.x, p.y) for p in new.points_world]
    copied = edits.duplicate_figures(wanted)(star)
    kinds = [figure.colour for figure in copied.sheets[0].figures]
    assert kinds[:6] == [1, 1, 2, 2, 3, 3]
    assert len({figure.id for figure in copied.sheets[0].figures}) == 19


def test_a_sheet_keeps_its_scale_when_it_grows() -> None:
    grown = edits.set_sheet_size("s1", 80, 14)(example_document()).sheets[0]
    assert grown.first_view.viewport_device == Rectangle(-0.5, -0.5, 79.5, 13.5)
    assert grown.first_view.window_world == Rectangle(-0.5, -0.5, 79.5, 13.5)


def test_a_viewport_of_its_own_stays_when_the_sheet_grows() -> None:
    small = edits.set_viewport("v1", Rectangle(2.0, 2.0, 10.0, 10.0))(example_document())
    grown = edits.set_sheet_size("s1", 80, 14)(small).sheets[0]
    assert grown.first_view.viewport_device == Rectangle(2.0, 2.0, 10.0, 10.0)
    assert grown.first_view.window_world == small.sheets[0].first_view.window_world


def test_a_sheet_that_is_added_again_gets_ids_of_its_own() -> None:
    document = example_document()
    twice = edits.add_sheet(document.sheets[0])(document)
    assert check(twice) is twice
    assert twice.sheets[0] == document.sheets[0]
    assert [p.x for p in twice.sheets[1].figures[0].points_world] == [20.0, 30.0]


def test_several_edits_are_done_together_or_not_at_all() -> None:
    document = example_document()
    with pytest.raises(DocumentError):
        edits.set_attributes({"s1/f1/p1/x": 5, "s1/f1/colour": 77})(document)
    done = edits.set_attributes({"s1/f1/p1/x": 5, "s1/f1/colour": 2})(document)
    assert (resolve(done, "s1/f1/p1/x"), resolve(done, "s1/f1/colour")) == (5.0, 2)


def _square(identity: str = "") -> Polygon:
    places = [(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]
    return Polygon(identity, tuple(WorldPoint("", x, y) for x, y in places), "scan_line_exact")


def test_a_polygon_takes_rings_and_corners() -> None:
    document = edits.add_figure("s1", _square())(blank_sheet())
    polygon = document.sheets[0].figures[0]
    document = edits.add_ring(polygon.id, [(2, 2), (6, 2), (4, 6)])(document)
    document = edits.insert_point(polygon.id, 4, 2.0, 4.0)(document)
    document = edits.remove_point(f"s1/{polygon.id}/{polygon.points_world[0].id}/*")(document)
    changed = document.sheets[0].figures[0]
    assert isinstance(changed, Polygon)
    assert changed.ring_ends == (3, 7)
    assert [[(p.x, p.y) for p in ring] for ring in changed.rings] == [
        [(8, 0), (8, 8), (0, 8)],
        [(2, 4), (2, 2), (6, 2), (4, 6)],
    ]


def test_a_ring_of_two_corners_is_refused() -> None:
    document = edits.add_figure("s1", _square())(blank_sheet())
    polygon = document.sheets[0].figures[0].id
    with pytest.raises(DocumentError, match="2 of at least 3 points in ring 2"):
        edits.add_ring(polygon, [(2, 2), (6, 2)])(document)
    with pytest.raises(DocumentError, match="3"):
        edits.add_figure("s1", replace(_square(), points_world=_square().points_world[:2]))(document)


def test_a_clip_window_without_area_is_refused() -> None:
    document = edits.set_clip("v1", Rectangle(0, 0, 30, 20))(blank_sheet())
    assert document.sheets[0].first_view.clip_world == Rectangle(0.0, 0.0, 30.0, 20.0)
    with pytest.raises(DocumentError, match="clip_world has no width"):
        edits.set_clip("v1", Rectangle(4, 0, 4, 20))(document)
    assert edits.set_clip("v1", None)(document) == blank_sheet()
    with pytest.raises(DocumentError, match="line_clipper"):
        edits.set_clipper("s1", "bresenham_line")(document)


@given(documents(), documents())
def test_many_figures_are_added_at_once_with_ids_of_their_own(document: Document, other: Document) -> None:
    wanted = [figure for sheet in other.sheets for figure in sheet.figures]
    wanted = [replace(f, colour=0, **({"boundary": 0} if isinstance(f, SeedFill) else {})) for f in wanted]
    new = edits.add_figures(document.sheets[0].id, wanted)(document)
    assert check(new) is new
    kept = len(document.sheets[0].figures)
    assert new.sheets[0].figures[:kept] == document.sheets[0].figures
    added = new.sheets[0].figures[kept:]
    assert [replace(without_ids(f), group=0) for f in added] == [
        replace(without_ids(f), group=0) for f in wanted
    ]
    assert not {f.group for f in added} - {0} & {f.group for f in document.sheets[0].figures}
    for one, given_one in zip(added, wanted, strict=True):
        for other_one, given_other in zip(added, wanted, strict=True):
            if one is not other_one:
                together = 0 != one.group == other_one.group
                assert together is (0 != given_one.group == given_other.group)
