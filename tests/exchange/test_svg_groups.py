"""What stays together in an SVG stays together here, and the other way round."""

from itertools import groupby
from xml.etree import ElementTree

import pytest

from tests.exchange.svg_texts import SHEET, svg
from tests.exchange.test_svg_round_trip import bare, sheet_with
from workbench.document.model import Circle, Line, WorldPoint
from workbench.exchange.svg_paths import read_svg, write_svg

LINE = '<line x2="4" stroke="red"/>'
BOTH = '<path d="M 0 0 C 1 2 3 4 5 0 Z" fill="red" stroke="blue"/>'
INKSCAPE = 'xmlns:i="http://www.inkscape.org/namespaces/inkscape" i:groupmode="layer"'


def groups(text: str) -> list[int]:
    return [figure.group for figure in read_svg(text, SHEET).figures]


@pytest.mark.parametrize(
    ("inner", "expected"),
    [
        (LINE, [0]),
        (BOTH, [1, 1]),
        ('<circle r="3" fill="red" stroke="blue"/>', [1, 1]),
        (BOTH + LINE + BOTH, [1, 1, 0, 2, 2]),
        ('<path d="M 0 0 C 1 2 3 4 5 0 M 9 9 C 8 7 6 5 4 3" fill="none" stroke="red"/>', [1, 1]),
        (f"<g>{LINE}{LINE}</g>{LINE}", [1, 1, 0]),
        (f"<g>{LINE}{LINE}</g>", [0, 0]),  # what holds the whole drawing
        (f"<g><g>{LINE}<g>{BOTH}</g></g>{LINE}</g>", [1, 1, 1, 0]),
        (f"<g {INKSCAPE}>{LINE}<g>{LINE}{LINE}</g></g><g {INKSCAPE}>{LINE}{LINE}</g>", [0, 1, 1, 0, 0]),
        (f'<defs><g id="a">{LINE}{LINE}</g></defs><use href="#a"/><use href="#a" x="1"/>', [1, 1, 2, 2]),
        (f"<g>{LINE}</g>{LINE}", [0, 0]),
    ],
)
def test_groups_of_other_programs(inner: str, expected: list[int]) -> None:
    assert groups(svg(inner)) == expected


def line(identity: str, y: float, group: int, visible: bool = True) -> Line:
    ends = WorldPoint(f"p{identity}1", 0, y), WorldPoint(f"p{identity}2", 9, y)
    return Line(f"f{identity}", ends, "dda_line", group=group, visible=visible)


def test_groups_are_written_as_such_and_read_again() -> None:
    centre = (WorldPoint("p9", 5, 5),)
    circle = Circle("f9", centre, "midpoint_circle", group=7, radius_world=2.0)
    sheet = sheet_with(line("1", 0, 4), line("2", 1, 4), line("3", 2, 0), line("4", 3, 7), circle)
    text = write_svg(sheet).text
    root = ElementTree.fromstring(text)
    children = [[inner.tag.split("}")[1] for inner in each] for each in root]
    assert children == [["line", "line"], [], ["line", "circle"]]
    for written in (text, bare(text)):
        assert [figure.group for figure in read_svg(written, sheet).figures] == [1, 1, 0, 2, 2]


def test_a_group_that_is_all_there_is_is_read_again() -> None:
    sheet = sheet_with(line("1", 0, 3), line("2", 1, 3))
    assert [figure.group for figure in read_svg(write_svg(sheet).text, sheet).figures] == [1, 1]


def test_a_member_that_is_not_written_leaves_the_others_together() -> None:
    sheet = sheet_with(line("1", 0, 3), line("2", 1, 3, visible=False), line("3", 2, 3), line("4", 3, 3))
    numbers = [figure.group for figure in read_svg(write_svg(sheet).text, sheet).figures]
    assert [len(list(run)) for _number, run in groupby(numbers)] == [3]
