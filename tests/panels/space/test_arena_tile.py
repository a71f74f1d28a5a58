"""What a tile says of its method, in as many words as there is room for."""

import numpy as np
import pytest
from PySide6.QtGui import QFontMetrics

from workbench.algorithms import catalogue
from workbench.panels.space.arena.tile import AIR_PX, LEAST_PX, forms_of_tests, forms_of_time, together
from workbench.rendering.scene.arena import MethodRun
from workbench.rendering.scene.counted import counted_forms, counted_texts, kept_texts
from workbench.rendering.scene.growth import Growth


def run_of(method, counted=None, keeps=None):
    nothing = np.zeros((0, 0), np.int64)
    return MethodRun(method, nothing, nothing, 0, counted or {}, keeps or {})


def forms(method, counted):
    (said,) = counted_forms(run_of(method, counted))
    return said


DIFFER = ("0 px differ", "0 differ")
TESTS = forms_of_tests(1_654_260)
FORETOLD = forms_of_time(Growth("octree", (), (), 5.11, measured=False))
BOX = forms("ray_casting_boxes", {"boxes divided": 1})
SQUARES = forms("area_subdivision", {"squares divided": 85})
CELLS = forms("octree", {"cells divided": 7237})


@pytest.mark.parametrize(
    ("left", "right", "room", "said"),
    [
        (TESTS, FORETOLD, "1,654,260 testsabout 5.11 s", ("1,654,260 tests", "about 5.11 s")),
        (TESTS, FORETOLD, "1,654,260 tests≈ 5.11 s", ("1,654,260 tests", "≈ 5.11 s")),
        (TESTS, FORETOLD, "1.7 M tests≈ 5.11 s", ("1.7 M tests", "≈ 5.11 s")),
        (DIFFER, BOX, "0 px differ1 box divided", ("0 px differ", "1 box divided")),
        (DIFFER, SQUARES, "0 px differ85 divided", ("0 px differ", "85 divided")),
        (DIFFER, CELLS, "0 differ7,237 divided", ("0 differ", "7,237 divided")),
        (DIFFER, CELLS, "0 px differ", ("0 px differ", "")),
        (DIFFER, CELLS, "0", ("0 differ", "")),
        (DIFFER, ("",), "0 px differ", ("0 px differ", "")),
    ],
)
def test_both_ends_of_a_line_say_as_much_as_there_is_room_for(qapp, left, right, room, said):
    """Down to the tightest, where a count goes before it would stand without its noun."""
    metrics = QFontMetrics(qapp.font())
    assert together(left, right, metrics, metrics.horizontalAdvance(room) + 6) == said


def test_nothing_overlaps_in_the_narrowest_tile(qapp):
    metrics, room = QFontMetrics(qapp.font()), LEAST_PX.width() - 2 * AIR_PX
    for n in (0, 1, 12, 4_321, 76_543, 987_654_321):
        for entry in (each for each in catalogue.entries() if each.topic == "visibility"):
            counts = counted_forms(run_of(entry.slug, dict.fromkeys(entry.counted, n)))
            lines = (forms_of_tests(n), FORETOLD), *((DIFFER, each) for each in counts)
            for left, right in lines:
                pair = together(left, right, metrics, room)
                assert metrics.horizontalAdvance("".join(pair)) < room
                assert not any(text.strip().replace(",", "").isdigit() for text in pair)


def test_counts_have_a_singular():
    for divided, said in ((1, "1 box divided"), (7237, "7,237 boxes divided")):
        run = run_of("ray_casting_boxes", {"boxes divided": divided}, {"boxes": 1})
        assert counted_texts(run) == [said]
        assert kept_texts(run) == ["1 box"]
    for entry in catalogue.entries():
        for plural, one in (*entry.counted.items(), *entry.keeps.items()):
            assert not one.singular.endswith("s")
            assert plural != one.singular
