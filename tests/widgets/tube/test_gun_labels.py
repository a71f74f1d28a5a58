"""The labels of the tube that is cut open cover no line of it, at the sizes that its window gives it."""

import pytest
import shapely
from pytestqt.qtbot import QtBot
from shapely.geometry import LineString

from tests.display.overlaps import crowded
from workbench.display.cutaway import labels, shapes
from workbench.display.gun import Gun
from workbench.widgets.look.tokens import DARK, LIGHT, Tokens, theme
from workbench.widgets.tube.gun_view import GunView, lines_of


@pytest.mark.parametrize("now", [LIGHT, DARK])
@pytest.mark.parametrize(
    ("size", "coils"),
    [
        ((425, 185), False),
        ((520, 240), False),
        ((520, 240), True),
        ((640, 300), False),
        ((1200, 620), True),
    ],
)
def test_no_label_covers_a_line_of_the_drawing(
    qtbot: QtBot, size: tuple[int, int], coils: bool, now: Tokens
) -> None:
    theme.use(now)
    view, gun = GunView(), Gun(coils=coils)
    qtbot.addWidget(view)
    view.resize(*size)
    view.show_gun(gun, gun.way())
    view.grab()
    theme.use(LIGHT)
    assert len(view._placed) == len(labels(gun))
    assert not crowded(view._placed)
    for placed in view._placed:
        box = shapely.box(*placed.box).buffer(-1e-6)
        for shape in shapes(gun):
            points = shape.points.tolist()
            line = LineString([*points, points[0]] if shape.closed else points)
            assert not line.intersects(box), (placed.label.title, shape.part or shape.kind)


@pytest.mark.parametrize("size", [(300, 100), (330, 110), (385, 100), (385, 130), (425, 140)])
@pytest.mark.parametrize("coils", [False, True])
def test_where_there_is_no_room_a_label_is_left_out(qtbot: QtBot, size: tuple[int, int], coils: bool) -> None:
    view, gun = GunView(), Gun(coils=coils)
    qtbot.addWidget(view)
    view.resize(*size)
    view.show_gun(gun, gun.way())
    view.grab()
    view.show_gun(gun, gun.way(), seconds=0.0)
    view.grab()
    assert view.wording == "short" or len(view._placed) == len(labels(gun))
    assert len(view._placed) >= 4
    assert not crowded(view._placed)


def test_where_names_are_long_they_become_short_before_what_parts_are_set_to_goes(qtbot: QtBot) -> None:
    worded = {}
    for size in ((1200, 620), (520, 240), (425, 185)):
        view, gun = GunView(), Gun()
        qtbot.addWidget(view)
        view.resize(*size)
        view.show_gun(gun, gun.way())
        view.grab()
        grid = next(each.label for each in view._placed if each.label.part == "grid")
        worded[size] = lines_of(grid, view.wording)
    value = worded[1200, 620][1]
    assert worded == {
        (1200, 620): ["control grid", value],
        (520, 240): ["grid", value],
        (425, 185): ["grid"],
    }
