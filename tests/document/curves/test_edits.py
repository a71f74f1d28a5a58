"""Edits of curves: sound or refused, undone and redone to the same, handles and knots in order."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.curves.made_curves import curve_edit_of, documents_with_curves, places
from tests.document.test_addresses import everything
from workbench.document import DocumentError
from workbench.document.addresses import changed, resolve
from workbench.document.building import both
from workbench.document.check import check, ids
from workbench.document.curves import edits as curve_edits
from workbench.document.curves.paths import natural_joint, place
from workbench.document.curves.pieces import fault_of, pieces_of, points_of
from workbench.document.edits import add_figure, move_points, set_attribute
from workbench.document.laws import needed_knots
from workbench.document.model import Curve, CurvePoint, Document, Knot
from workbench.document.samples.figures import document_of
from workbench.document.storage.files import Stored, decode, encode


def curve_of(places: list[tuple[float, float]], **how: object) -> Document:
    """One curve through or along ``places``; its id is f1, those of its points p1, p2 and so on."""
    points = tuple(CurvePoint("", x, y) for x, y in places)
    return document_of("Curve", 320, 200, [Curve("", points, "bresenham_line", **how)])  # type: ignore[arg-type]


def the_curve(document: Document) -> Curve:
    curve = document.sheets[0].figures[0]
    assert isinstance(curve, Curve)
    return curve


def where(document: Document) -> list[tuple[float, float]]:
    return [place(point) for point in the_curve(document).points_world]


@settings(max_examples=120)
@given(st.data(), documents_with_curves())
def test_an_edit_of_a_curve_is_sound_or_refused_in_a_sentence(
    data: st.DataObject, document: Document
) -> None:
    told: list[str] = []
    for _turn in range(3):
        before = encode(Stored(document))
        try:
            new = data.draw(curve_edit_of(document))(document)
        except DocumentError as refusal:
            told.append(str(refusal))
            assert encode(Stored(document)) == before
            continue
        assert check(new) is new
        assert encode(Stored(document)) == before
        assert decode(encode(Stored(new))).document == new
        for curve in new.sheets[0].figures:
            assert isinstance(curve, Curve)
            if curve.knot_rule == "free":
                assert len(curve.knots) == needed_knots(curve)
            if not fault_of(curve):
                assert np.isfinite(pieces_of(curve).controls).all()
        if not new.sheets[0].figures:
            break
        document = new
    assert all(sentence.endswith(".") and "\n" not in sentence for sentence in told)


@settings(max_examples=60)
@given(st.data(), documents_with_curves())
def test_an_address_of_a_point_or_knot_finds_it_after_edits(data: st.DataObject, document: Document) -> None:
    given_ids = {identity for _path, identity in ids(document)}
    for _turn in range(4):
        before = everything(document)
        try:
            new = data.draw(curve_edit_of(document))(document)
        except DocumentError:
            continue
        if not new.sheets[0].figures:
            return
        after, told = everything(new), changed(document, new)
        for address in before.keys() & after.keys():
            assert resolve(new, str(address)) == after[address]
            if address.point and after[address] != before[address]:
                assert address in told
        now = {identity for _path, identity in ids(new)}
        fresh = now - {identity for _path, identity in ids(document)}
        assert not fresh & given_ids
        given_ids |= now
        document = new


PATH = [(0, 0), (10, 10), (20, 10), (30, 0), (40, -10), (50, -10), (60, 0)]


def test_a_point_of_a_path_carries_its_handles() -> None:
    document = curve_of(PATH, spline="bezier_path")
    moved = curve_edits.move_curve_points({"s1/f1/p4/x": (33, 5)})(document)
    assert where(moved) == [(0, 0), (10, 10), (23, 15), (33, 5), (43, -5), (50, -10), (60, 0)]
    assert move_points({"s1/f1/p4/x": (33, 5)})(document) == moved


@given(st.sampled_from(["smooth", "symmetric"]), st.floats(-50, 50), st.floats(-50, 50))
def test_a_handle_turns_the_one_opposite(joint: str, x: float, y: float) -> None:
    document = curve_edits.set_joint(["s1/f1/p4/*"], joint)(curve_of(PATH, spline="bezier_path"))
    length = math.dist(where(document)[2], where(document)[3])
    moved = where(curve_edits.move_curve_points({"s1/f1/p5/*": (x, y)})(document))
    assert moved[4] == (x, y)
    size = math.dist((x, y), (30, 0))
    if size < 1e-6:
        return
    assert natural_joint(moved[2], moved[3], moved[4]) in (joint, "symmetric")
    if joint == "smooth":
        assert math.isclose(math.dist(moved[2], moved[3]), length, rel_tol=1e-9)


def test_a_corner_of_a_path_is_made_smooth_and_says_what_moved() -> None:
    curve = the_curve(curve_of(PATH, spline="bezier_path"))
    made, moved = curve_edits.joints_made(curve, ["p4"], "smooth")
    assert moved == {}  # the handles already lie in one direction
    made, moved = curve_edits.joints_made(
        the_curve(
            curve_edits.move_curve_points({"s1/f1/p3/x": (20, 0)})(curve_of(PATH, spline="bezier_path"))
        ),
        ["p4"],
        "smooth",
    )
    assert set(moved) == {"p3", "p5"}
    assert [point.joint for point in made.points_world if point.id == "p4"] == ["smooth"]


def test_a_pen_draws_a_path() -> None:
    document = curve_of([(0, 0)], spline="bezier_path")
    document = curve_edits.add_path_point("f1", 30, 0)(document)
    assert where(document) == [(0, 0), (10, 0), (20, 0), (30, 0)]
    document = curve_edits.add_path_point("f1", 60, 30, (60, 45))(document)
    assert where(document)[4:] == [(40, 10), (60, 15), (60, 30)]
    document = curve_edits.add_path_point("f1", 0, 60)(document)
    assert where(document)[7] == (60, 45)
    document = curve_edits.set_curve_closed("f1", True)(document)
    assert len(where(document)) == 12
    assert fault_of(the_curve(document)) == ""
    with pytest.raises(DocumentError, match="closed"):
        curve_edits.add_path_point("f1", 1, 1)(document)


@settings(max_examples=40)
@given(documents_with_curves("bezier_path"))
def test_a_path_that_is_opened_looks_as_before_and_closes_again(document: Document) -> None:
    curve = the_curve(document)
    if not curve.closed or fault_of(curve):
        return
    before = pieces_of(curve)
    document = curve_edits.set_curve_closed(curve.id, False)(document)
    np.testing.assert_array_equal(pieces_of(the_curve(document)).controls, before.controls)
    again = curve_edits.set_curve_closed(curve.id, True)(document)
    np.testing.assert_array_equal(pieces_of(the_curve(again)).controls, before.controls)


@settings(max_examples=60)
@given(documents_with_curves("bezier_path"), st.booleans())
def test_a_path_that_is_closed_or_opened_loses_no_point(document: Document, close: bool) -> None:
    curve = the_curve(document)
    try:
        new = the_curve(curve_edits.set_curve_closed(curve.id, close)(document))
    except DocumentError:
        return
    kept = {point.id for point in new.points_world}
    lost = [point for point in curve.points_world if point.id not in kept]
    assert all(math.dist(place(point), place(curve.points_world[0])) <= 1e-7 for point in lost)
    assert len(lost) <= 1


def test_points_that_wait_become_the_handles_of_the_piece_that_closes_a_path() -> None:
    for more in ([(70, 10)], [(70, 10), (-5, -20)]):
        document = curve_of([*PATH, *more], spline="bezier_path")
        closed = curve_edits.set_curve_closed("f1", True)(document)
        assert where(closed)[: len(PATH) + len(more)] == [*PATH, *more]
        assert len(where(closed)) == 9
    again = curve_edits.set_curve_closed("f1", False)(curve_of([*PATH, *more], spline="bezier_path"))
    assert where(again) == [*PATH, *more]


def test_of_a_closed_path_without_a_piece_the_points_left_stay() -> None:
    document = curve_of([(0, 0), (10, 10)], spline="bezier_path", closed=True)
    assert where(curve_edits.remove_points(["s1/f1/p1/*"])(document)) == [(10, 10)]


@settings(max_examples=60)
@given(documents_with_curves(), st.lists(places, min_size=1, max_size=4))
def test_points_added_at_once_are_those_added_one_by_one(
    document: Document, more: list[tuple[float, float]]
) -> None:
    curve = the_curve(document)
    spread_anew = curve.spline == "bezier_path" or len(curve.points_world) <= curve.degree
    if curve.closed or (curve.knot_rule == "free" and spread_anew):
        return
    for index, order in ((None, more), (0, more[::-1])):
        at_once = the_curve(curve_edits.add_points(curve.id, more, index)(document))
        one_by_one = the_curve(
            both(*(curve_edits.add_points(curve.id, [at], index) for at in order))(document)
        )
        np.testing.assert_array_equal(points_of(at_once), points_of(one_by_one))
        np.testing.assert_allclose(
            [knot.u for knot in at_once.knots], [knot.u for knot in one_by_one.knots], atol=1e-9
        )


def test_removing_a_point_of_a_path_takes_its_handles() -> None:
    document = curve_of(PATH, spline="bezier_path")
    assert where(curve_edits.remove_points(["s1/f1/p4/*"])(document)) == [
        (0, 0),
        (10, 10),
        (50, -10),
        (60, 0),
    ]
    assert where(curve_edits.remove_points(["s1/f1/p1/*"])(document)) == PATH[3:]
    assert where(curve_edits.remove_points(["s1/f1/p3/*"])(document))[2] == (30, 0)
    everywhere = [f"s1/f1/{p.id}/*" for p in the_curve(document).points_world]
    assert curve_edits.remove_points(everywhere)(document).sheets[0].figures == ()


POINTS = [(0, 0), (20, 40), (50, 50), (80, 10), (110, 0), (130, 40)]


def test_free_knots_begin_as_they_were_and_do_not_change_the_curve() -> None:
    for rule in ("open_uniform", "uniform"):
        document = curve_of(POINTS, spline="b_spline", knot_rule=rule)
        free = curve_edits.set_knot_rule("f1", "free")(document)
        np.testing.assert_array_equal(
            pieces_of(the_curve(free)).controls, pieces_of(the_curve(document)).controls
        )
    closed = curve_of(POINTS, spline="b_spline", closed=True)
    free = curve_edits.set_knot_rule("f1", "free")(closed)
    assert len(the_curve(free).knots) == 7
    np.testing.assert_array_equal(pieces_of(the_curve(free)).controls, pieces_of(the_curve(closed)).controls)


def test_a_knot_may_not_pass_its_neighbour() -> None:
    document = curve_edits.set_knot_rule("f1", "free")(curve_of(POINTS, spline="b_spline"))
    knot = the_curve(document).knots[5]
    with pytest.raises(DocumentError, match="must not decrease"):
        curve_edits.set_knot(f"s1/f1/{knot.id}/u", 0.5)(document)
    moved = curve_edits.set_knot(f"s1/f1/{knot.id}/u", 1.5)(document)
    assert resolve(moved, f"s1/f1/{knot.id}/u") == 1.5
    with pytest.raises(DocumentError, match="choose a knot"):
        curve_edits.set_knot("s1/f1/p1/x", 1.5)(document)


def test_two_knots_of_one_id_are_refused() -> None:
    document = curve_edits.set_knot_rule("f1", "free")(curve_of(POINTS, spline="b_spline"))
    curve = the_curve(document)
    twice = replace(curve, knots=(*curve.knots[:-1], replace(curve.knots[-1], id=curve.knots[0].id)))
    sheet = replace(document.sheets[0], figures=(twice,))
    with pytest.raises(DocumentError, match="which another one already has"):
        check(replace(document, sheets=(sheet,)), document)


def test_a_point_behind_the_last_leaves_what_was_drawn() -> None:
    document = curve_edits.set_knot_rule("f1", "free")(
        curve_of(POINTS, spline="b_spline", knot_rule="uniform")
    )
    longer = curve_edits.add_points("f1", [(160, 60)])(document)
    before, after = pieces_of(the_curve(document)), pieces_of(the_curve(longer))
    assert len(after.controls) == len(before.controls) + 1
    np.testing.assert_allclose(after.controls[: len(before.controls)], before.controls, rtol=1e-12)
    front = curve_edits.add_points("f1", [(-20, 10)], 0)(document)
    np.testing.assert_allclose(pieces_of(the_curve(front)).controls[1:], before.controls, rtol=1e-12)


def test_tangents_are_made_from_the_neighbours_once() -> None:
    document = curve_edits.set_spline("f1", "hermite")(curve_of([(0, 0), (10, 20), (40, 20)]))
    tangents = [(p.tangent_x, p.tangent_y) for p in the_curve(document).points_world]
    assert tangents == [(10, 20), (20, 10), (30, 0)]
    document = set_attribute("s1/f1/p1/tangent_x", 5.0)(document)
    document = curve_edits.set_spline("f1", "clamped_cubic")(document)
    assert the_curve(document).points_world[0].tangent_x == 5


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (curve_edits.set_spline("f1", "spline"), "choose one of bezier"),
        (curve_edits.set_knot_rule("f1", "wild"), "open_uniform"),
        (curve_edits.set_weights({"s1/f1/p1/*": 0.0}), "weight is 0.0"),
        (curve_edits.set_degree("f1", 8), "degree is 8"),
        (curve_edits.set_degree("f1", 0), "degree is 0"),
        (curve_edits.add_path_point("f1", 1, 1), "not a path"),
        (curve_edits.move_curve_points({"s1/f1/p1/x": (math.nan, 1)}), "finite"),
        (curve_edits.move_curve_points({"s1/f1/p98/x": (1, 1)}), "no point"),
        (curve_edits.set_joint(["s1/f1/p1/*"], "round"), "corner"),
        (curve_edits.add_points("f1", [(1, 1)], 99), "no position 99"),
        (curve_edits.add_points("f9", [(1, 1)]), "no figure"),
    ],
)
def test_what_would_not_be_sound_is_refused_in_one_sentence(edit: curve_edits.Edit, words: str) -> None:
    with pytest.raises(DocumentError, match=words) as refusal:
        edit(curve_of(POINTS, spline="nurbs"))
    assert str(refusal.value).endswith(".")


def test_numbers_of_any_type_become_plain() -> None:
    point = CurvePoint("", np.float64(1), np.int64(2), weight=np.float32(2), tangent_x=np.float64(3))
    knots = tuple(Knot("", np.float64(k)) for k in range(4))
    made = Curve(
        "",
        (point, replace(point, x=5)),
        "bresenham_line",
        degree=1,
        knot_rule="free",
        knots=knots,
        alpha=np.float64(1),
    )
    document = add_figure("s1", made)(document_of("Empty", 10, 10, []))
    assert decode(encode(Stored(document))).document == document
    assert the_curve(document).points_world[0].weight == 2.0
