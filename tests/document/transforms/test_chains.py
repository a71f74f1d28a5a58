"""Links and chains against matrices multiplied by hand, and edits of chains."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.made_documents import chains, links
from workbench.document import DocumentError, edits
from workbench.document.addresses import changed, resolve
from workbench.document.curves.cutting import split
from workbench.document.curves.joining import join
from workbench.document.model import Circle, Curve, CurvePoint, Document, Ellipse, Line, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.document.transforms import edits as chain_edits
from workbench.document.transforms.chains import (
    inverse_of,
    is_singular,
    matrices_of,
    matrix_of,
    read_only_reason,
    transformed,
    unfolded,
)
from workbench.document.transforms.links import Affine, AnyLink, Reflect, Rotate, Scale, Shear, Translate
from workbench.document.transforms.names import title, undo_names

Chain = tuple[AnyLink, ...]


def oracle(link: AnyLink) -> np.ndarray:
    """What the definition of a link says of the two unit vectors and the origin."""

    def moved(x: float, y: float) -> tuple[float, float]:
        match link:
            case Translate():
                return x + link.tx, y + link.ty
            case Rotate(x_pivot=a, y_pivot=b):
                turned = complex(x - a, y - b) * complex(
                    math.cos(math.radians(link.angle)), math.sin(math.radians(link.angle))
                )
                return turned.real + a, turned.imag + b
            case Scale(x_pivot=a, y_pivot=b):
                return a + link.sx * (x - a), b + link.sy * (y - b)
            case Reflect(mirror="point", x_pivot=a, y_pivot=b):
                return 2 * a - x, 2 * b - y
            case Reflect(x_pivot=a, y_pivot=b):
                along = math.cos(math.radians(link.angle)), math.sin(math.radians(link.angle))
                share = (x - a) * along[0] + (y - b) * along[1]
                return 2 * (a + share * along[0]) - x, 2 * (b + share * along[1]) - y
            case Shear():
                return x + link.sh_x * (y - link.y_ref), y + link.sh_y * (x - link.x_ref)
        return link.m11 * x + link.m12 * y + link.m13, link.m21 * x + link.m22 * y + link.m23

    origin, right, up = np.array([moved(0, 0), moved(1, 0), moved(0, 1)])
    return np.array([[*(right - origin)], [*(up - origin)], [*origin]]).T


@given(links("t1"))
def test_a_link_does_what_its_definition_says_and_so_do_its_parts(link: AnyLink) -> None:
    assert np.allclose(link.matrix[:2], oracle(link), atol=1e-9)
    assert link.matrix[2].tolist() == [0.0, 0.0, 1.0]
    whole = np.eye(3)
    for part in link.unfolded():
        whole = part.matrix @ whole
    assert np.allclose(whole, link.matrix, atol=1e-9)


def test_a_link_about_a_pivot_unfolds_into_three_matrices() -> None:
    for link in (
        Rotate("t", angle=30, x_pivot=4, y_pivot=1),
        Scale("t", sx=2, x_pivot=3),
        Reflect("t", y_pivot=2),
    ):
        assert [part.name for part in link.unfolded()][::2] == ["translation", "translation"]
        assert len(link.unfolded()) == 3
        at_origin = replace(link, x_pivot=0.0, y_pivot=0.0)
        assert [part.name for part in at_origin.unfolded()] == [link.unfolded()[1].name]


def test_the_first_link_acts_first_and_one_that_is_off_not_at_all() -> None:
    turn, move = Rotate("t1", angle=90.0), Translate("t2", tx=10.0)
    first, other = matrix_of((turn, move)), matrix_of((move, turn))
    assert first is not None
    assert other is not None
    assert (first @ (1, 0, 1)).tolist() == [10.0, 1.0, 1.0]
    assert (other @ (1, 0, 1)).tolist() == [0.0, 11.0, 1.0]
    assert matrix_of((replace(turn, on=False), move)).tolist() == move.matrix.tolist()  # type: ignore[union-attr]
    assert matrix_of((replace(turn, on=False),)) is None
    assert [part.name for part in unfolded((turn, replace(move, on=False), turn))] == ["rotation"] * 2


@given(chains("f1", most=8))
def test_a_chain_is_the_product_of_its_links_and_its_inverse_leads_back(chain: Chain) -> None:
    whole = np.eye(3)
    for link in chain:
        if link.on:
            whole = np.vstack([oracle(link), [0, 0, 1]]) @ whole
    matrix = matrix_of(chain)
    if matrix is None:
        assert not any(link.on for link in chain)
        return
    assert np.allclose(matrix, whole, rtol=1e-7, atol=1e-7 * max(1.0, np.abs(whole).max()))
    if is_singular(matrix):
        with pytest.raises(ValueError, match="cannot be undone"):
            inverse_of(matrix)
    elif np.linalg.cond(matrix) < 1e7:
        assert np.allclose(inverse_of(matrix) @ matrix, np.eye(3), atol=1e-6)


@pytest.mark.parametrize(
    "link",
    [
        Scale("t", sx=0.0),
        Shear("t", sh_x=2.0, sh_y=0.5),
        Affine("t", m11=3.0, m12=6.0, m21=1.0, m22=2.0),
        Affine("t", m11=1e-3, m12=3e-3, m21=2e-3, m22=6e-3),
    ],
)
def test_what_flattens_the_plane_is_said_and_small_is_not_flat(link: AnyLink) -> None:
    chain = (Rotate("r", angle=33.0), link)
    figure = replace(line_at((0, 0), (4, 2)), transforms=chain)
    assert "flatten" in read_only_reason(figure)
    small = Scale("t", sx=1e-6, sy=1e-6)
    assert read_only_reason(replace(figure, transforms=(small,))) == ""


def line_at(*places: tuple[float, float], chain: Chain = ()) -> Line:
    points = tuple(WorldPoint(f"p{k}", float(x), float(y)) for k, (x, y) in enumerate(places))
    return Line("f1", points, "bresenham_line", transforms=chain)


def test_many_figures_share_one_evaluation() -> None:
    chain = tuple(Rotate(f"t{k}", angle=7.0, x_pivot=float(k)) for k in range(50))
    figures = [line_at((k, 0), (k, 1), chain=chain if k % 2 else ()) for k in range(100)]
    matrices = matrices_of(figures)
    assert np.array_equal(matrices[1], matrix_of(chain))  # type: ignore[arg-type]
    assert np.array_equal(matrices[0], np.eye(3))
    assert figures[1].matrix is figures[1].matrix
    points = np.arange(200.0).reshape(100, 2)
    expected = np.einsum("nij,nj->ni", matrices, np.column_stack([points, np.ones(100)]))[:, :2]
    assert np.allclose(transformed(matrices, points), expected)


def document_with(*figures: Line | Circle | Ellipse | Curve) -> Document:
    document = blank_sheet()
    for figure in figures:
        document = edits.add_figure("s1", figure)(document)
    return document


LINK = Rotate("", angle=30.0, x_pivot=4.0)


def test_links_come_go_move_and_switch_and_keep_their_ids() -> None:
    document = document_with(line_at((0, 0), (4, 2)))
    one = chain_edits.add_transform("f1", LINK)(document)
    both = chain_edits.add_transform("f1", Translate("", tx=3.0), 0)(one)
    chain = both.sheets[0].figures[0].transforms
    first, second = chain
    assert [type(link) for link in chain] == [Translate, Rotate]
    assert len({first.id, second.id, "f1", "p0", "p1"}) == 5
    at = f"s1/f1/{second.id}"
    assert resolve(both, f"{at}/angle") == 30.0
    turned = edits.set_attribute(f"{at}/angle", 45)(both)
    assert {str(address) for address in changed(both, turned)} == {f"{at}/angle"}
    swapped = chain_edits.reorder_transform(f"{at}/*", 0)(turned)
    assert [link.id for link in swapped.sheets[0].figures[0].transforms] == [second.id, first.id]
    off = chain_edits.switch_transform(f"{at}/on", False)(swapped)
    assert resolve(off, f"{at}/on") is False
    other = chain_edits.replace_transform(f"{at}/*", Shear("", sh_x=1.0))(off)
    assert resolve(other, f"{at}/*") == Shear(second.id, sh_x=1.0)
    gone = chain_edits.remove_transform(f"{at}/*")(other)
    assert gone.sheets[0].figures[0].transforms == (first,)
    again = chain_edits.add_transform("f1", LINK)(gone).sheets[0].figures[0].transforms[1]
    assert again.id not in (first.id, second.id)
    with pytest.raises(DocumentError, match="has no transform"):
        chain_edits.switch_transform(f"s1/f1/{second.id}/*", True)(gone)


def test_a_chain_that_leads_beyond_all_numbers_is_refused() -> None:
    document = document_with(line_at((0, 0), (4, 2)))
    for _turn in range(2):
        document = chain_edits.add_transform("f1", Scale("", sx=1e6, sy=1e6))(document)
    with pytest.raises(DocumentError, match="numbers beyond 1e\\+12"):
        chain_edits.add_transform("f1", Scale("", sx=1e6, sy=1e6))(document)


@given(chains("", most=3), links())
def test_extending_is_the_link_after_the_chain(chain: Chain, link: AnyLink) -> None:
    document = document_with(line_at((0, 0), (4, 2)))
    for each in chain:
        document = chain_edits.add_transform("f1", each)(document)
    link = replace(link, on=True)
    before = document.sheets[0].figures[0]
    after = chain_edits.extend(["f1"], link)(document).sheets[0].figures[0]
    expected = link.matrix @ (np.eye(3) if before.matrix is None else before.matrix)
    assert after.matrix is not None
    assert np.allclose(after.matrix, expected, rtol=1e-7, atol=1e-6 * max(1.0, np.abs(expected).max()))
    twice = chain_edits.extend(["f1"], link)(chain_edits.extend(["f1"], link)(document))
    count = len(twice.sheets[0].figures[0].transforms)
    if isinstance(link, Translate | Rotate | Scale):
        assert count == len(after.transforms) <= len(chain) + 1


def outline(figure: Circle | Ellipse) -> np.ndarray:
    angle = np.linspace(0, 2 * np.pi, 73)
    rx, ry = (
        (figure.radius_world,) * 2
        if isinstance(figure, Circle)
        else (figure.radius_x_world, figure.radius_y_world)
    )
    centre = figure.points_world[0]
    local = np.column_stack([centre.x + rx * np.cos(angle), centre.y + ry * np.sin(angle), np.ones(73)])
    return (local @ (np.eye(3) if figure.matrix is None else figure.matrix).T)[:, :2]


@given(chains("", most=2), st.booleans(), links())
def test_a_round_figure_takes_what_it_can_and_its_chain_the_rest(
    chain: Chain, circle: bool, link: AnyLink
) -> None:
    at = (WorldPoint("", 3.0, -2.0),)
    figure: Circle | Ellipse = Circle("f1", at, "midpoint_circle", radius_world=5.0)
    if not circle:
        figure = Ellipse("f1", at, "midpoint_ellipse", radius_x_world=5.0, radius_y_world=2.0)
    document = document_with(replace(figure, transforms=chain))
    before = document.sheets[0].figures[0]
    assert isinstance(before, Circle | Ellipse)
    assume(before.matrix is None or is_singular(before.matrix) or np.linalg.cond(before.matrix) < 1e6)
    result = chain_edits.applied(document, ["f1"], link.matrix)
    after = result.document.sheets[0].figures[0]
    assert isinstance(after, type(before))
    # Added to a link of its kind it may leave no trace: where it does nothing, or all is flat already
    nothing = np.array_equal(link.matrix, np.eye(3)) or is_singular(before.matrix)
    assert (after.transforms != before.transforms) == bool(result.told) or nothing
    expected = outline(before) @ link.matrix[:2, :2].T + link.matrix[:2, 2]
    centre = expected[:-1].mean(axis=0)
    size = max(1.0, float(np.abs(expected).max()))
    seen = outline(after)
    assert np.allclose(seen[:-1].mean(axis=0), centre, atol=1e-6 * size)
    # The same ellipse, though perhaps from another point of it and the other way round.
    away = np.abs(expected[:, None] - _dense(after)[None]).max(axis=2).min(axis=1)
    assert away.max() < 0.02 * size + 1e-6
    baked = chain_edits.baked(result.document, ["f1"])
    if not baked.told:
        plain = baked.document.sheets[0].figures[0]
        assert not any(other.on for other in plain.transforms)
        assert isinstance(plain, Circle | Ellipse)
        assert np.abs(seen[:, None] - _dense(plain)[None]).max(axis=2).min(axis=1).max() < 0.02 * size + 1e-6


def _dense(figure: Circle | Ellipse) -> np.ndarray:
    ring = outline(figure)
    share = np.linspace(0, 1, 12)[:, None, None]
    return (ring[:-1] + share * np.diff(ring, axis=0)).reshape(-1, 2)


def test_what_points_cannot_express_is_said() -> None:
    at = (WorldPoint("", 3.0, -2.0),)
    ellipse = Ellipse("f1", at, "midpoint_ellipse", radius_x_world=5.0, radius_y_world=2.0)
    quarter, eighth = Rotate("", angle=90.0).matrix, Rotate("", angle=45.0).matrix
    turned = chain_edits.applied(document_with(ellipse), ["f1"], quarter)
    figure = turned.document.sheets[0].figures[0]
    assert turned.told == ()
    assert (figure.radius_x_world, figure.radius_y_world) == (2.0, 5.0)  # type: ignore[union-attr]
    askew = chain_edits.applied(document_with(ellipse), ["f1"], eighth)
    assert [identity for identity, _said in askew.told] == ["f1"]
    assert "would turn" in askew.told[0][1]
    assert [type(link) for link in askew.document.sheets[0].figures[0].transforms] == [Rotate]
    further = chain_edits.applied(askew.document, ["f1"], eighth).document.sheets[0].figures[0]
    assert [link.angle for link in further.transforms] == [90.0]  # type: ignore[union-attr]
    bare = chain_edits.remove_transforms(["f1"])(askew.document)
    assert bare.sheets[0].figures == document_with(ellipse).sheets[0].figures
    with pytest.raises(DocumentError, match="not affine"):
        chain_edits.apply_matrix(["f1"], np.ones((3, 3)))(document_with(ellipse))


@given(links(), chains("", most=2))
def test_chosen_points_of_a_curve_go_with_tangents_and_handles(link: AnyLink, chain: Chain) -> None:
    points = tuple(CurvePoint("", 3.0 * k, float(k % 3), tangent_x=1.0, tangent_y=2.0) for k in range(7))
    curve = Curve("f1", points, "bresenham_line", spline="bezier_path", transforms=chain)
    document = document_with(curve)
    before = document.sheets[0].figures[0]
    assume(before.matrix is None or (not is_singular(before.matrix) and np.linalg.cond(before.matrix) < 1e6))
    chosen = f"s1/f1/{before.points_world[3].id}/x"
    after = chain_edits.apply_to_points([chosen], link.matrix)(document).sheets[0].figures[0]
    old, new = (seen(figure) for figure in (before, after))
    moved = old @ link.matrix[:2, :2].T + link.matrix[:2, 2]
    size = max(1.0, np.abs(moved).max())
    assert np.allclose(new[2:5], moved[2:5], atol=1e-6 * size)
    assert np.allclose(np.delete(new, [2, 3, 4], axis=0), np.delete(old, [2, 3, 4], axis=0))


def seen(figure: Curve | Line) -> np.ndarray:
    points = np.array([(p.x, p.y, 1.0) for p in figure.points_world])
    return (points @ (np.eye(3) if figure.matrix is None else figure.matrix).T)[:, :2]


def test_a_figure_is_moved_as_it_is_seen() -> None:
    chain = (Rotate("", angle=90.0), Scale("", sx=2.0))
    document = document_with(line_at((1, 2), (4, 2), chain=chain))
    before = seen(document.sheets[0].figures[0])
    after = edits.move_figures(["f1"], 6.0, -3.0)(document)
    assert np.allclose(seen(after.sheets[0].figures[0]), before + np.array([6.0, -3.0]))
    flat = chain_edits.add_transform("f1", Scale("", sx=0.0))(document)
    with pytest.raises(DocumentError, match="cannot be undone"):
        edits.move_figures(["f1"], 6.0, -3.0)(flat)
    copied = edits.duplicate_figures(["f1"])(flat).sheets[0].figures
    assert len({identity for figure in copied for identity in figure.ids}) == 2 * len(copied[0].ids)


def test_every_link_and_every_edit_has_a_name() -> None:
    for kind in (Translate, Rotate, Scale, Reflect, Shear, Affine):
        assert title(kind("t"))
    assert all(callable(getattr(chain_edits, name)) for name in undo_names())


def test_a_curve_that_is_cut_or_joined_looks_as_before() -> None:
    places = ((0, 0), (2, 6), (6, 6), (8, 0))
    controls = tuple(CurvePoint("", float(x), float(y)) for x, y in places)
    beside = tuple(CurvePoint("", float(x) + 10.0, float(y)) for x, y in places)
    turned, moved = (Rotate("", angle=30.0),), (Scale("", sx=2.0, sy=3.0), Shear("", sh_x=0.5))
    document = document_with(
        Curve("", controls, "bresenham_line", spline="bezier_path", transforms=turned),
        Curve("", beside, "bresenham_line", spline="bezier_path", transforms=moved),
    )
    one, other = document.sheets[0].figures
    joined = join(one.id, other.id)(document).sheets[0].figures
    assert len(joined) == 1
    assert [link.id for link in joined[0].transforms] == [link.id for link in one.transforms]
    for curve in (one, other):
        away = np.abs(seen(joined[0])[:, None] - seen(curve)[None]).max(axis=2).min(axis=0)
        assert away.max() < 1e-9
    parts = split(one.id, 0.5)(document).sheets[0].figures
    assert len(parts) == 3
    assert len({identity for figure in parts for identity in figure.ids}) == sum(len(f.ids) for f in parts)
    assert np.allclose(parts[0].matrix, parts[1].matrix)  # type: ignore[arg-type]


@given(st.lists(chains("f1", most=8), min_size=1, max_size=9))
def test_many_chains_at_once_are_what_each_is_by_itself(some: list[Chain]) -> None:
    many = [(*some[k % len(some)],) for k in range(70)]  # equal, but not the same
    figures = [line_at((0, 0), (4, 2), chain=chain) for chain in many]
    matrices = matrices_of(figures)
    for figure, matrix, chain in zip(figures, matrices, many, strict=True):
        alone = matrix_of(chain)
        assert np.array_equal(matrix, np.eye(3) if alone is None else alone)
        assert (figure.matrix is None) == (alone is None)


def test_links_of_many_chains_are_not_worked_out_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = []
    matrices = Rotate.matrices
    monkeypatch.setattr(Rotate, "matrices", lambda link, *n: calls.append(len(n)) or matrices(link, *n))
    figures = [
        line_at((0, 0), (1, 1), chain=tuple(Rotate(f"t{k}", angle=float(figure + k)) for k in range(50)))
        for figure in range(400)
    ]
    matrices_of(figures)
    assert len(calls) == 1
    angles = np.array([sum(range(figure, figure + 50)) for figure in range(400)])
    expected = np.cos(np.radians(angles))
    assert np.allclose([figure.matrix[0, 0] for figure in figures if figure.matrix is not None], expected)


@pytest.mark.parametrize("shared", [1, 80])
def test_a_chain_that_many_figures_share_is_worked_out_once(shared: int) -> None:
    some = [tuple(Rotate(f"t{k}", angle=float(number + k)) for k in range(50)) for number in range(shared)]
    figures = [line_at((0, 0), (1, 1), chain=some[k % shared]) for k in range(1_000)]
    matrices_of(figures)
    assert len({id(figure.matrix) for figure in figures}) == shared
    assert np.array_equal(figures[-1].matrix, matrix_of(some[999 % shared]))  # type: ignore[arg-type]


def test_a_chain_too_large_is_refused_wherever_its_figure_stands() -> None:
    large = tuple(Scale(f"t{k}", sx=1e4) for k in range(4))
    figures = [
        replace(line_at((0, 0), (1, 1), chain=large if k == 66 else ()), id=f"f{k}") for k in range(70)
    ]
    figures = [
        replace(each, points_world=tuple(replace(p, id=f"{each.id}{p.id}") for p in each.points_world))
        for each in figures
    ]
    with pytest.raises(DocumentError, match=r"figures\[66\]\.transforms has a matrix with numbers beyond"):
        document_with(*figures)
