"""The exam sums of any numbers: what they say is equal is equal, and is of a pixel that there is."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtWidgets import QLabel, QScrollArea
from pytestqt.qtbot import QtBot

from tests.panels.display.conftest import put_on_screen
from workbench.panels.display.raster.setting import RasterSetting
from workbench.panels.display.raster.sums import Numbers, worked_out
from workbench.panels.display.raster.sums_dock import SumsDock
from workbench.session.session import Session
from workbench.widgets.fields.number_field import NumberField


@pytest.mark.parametrize(
    ("width", "height", "size"),
    [
        (720, 480, "1,036,800 B = 1,012.5 KiB"),
        (1024, 768, "2,359,296 B = 2,304 KiB"),
        (3, 2, "18 B \N{ALMOST EQUAL TO} 0.01758 KiB"),
    ],
)
def test_a_size_in_kib_equals_that_in_bytes_where_it_says_so(width: int, height: int, size: str) -> None:
    numbers = Numbers(width, height, 24, Fraction(60), Fraction(0), Fraction(0), Fraction(1000))
    assert worked_out(numbers, None)[0].result == size


@given(st.integers(1, 2000), st.integers(1, 2000), st.integers(0, 4000), st.integers(0, 4000))
def test_the_pixel_that_is_addressed_is_one_of_the_picture(w: int, h: int, x: int, y: int) -> None:
    numbers = Numbers(w, h, 1, Fraction(60), Fraction(0), Fraction(0), Fraction(1000), (x, y))
    address = worked_out(numbers, None)[2]
    assert int(address.result.replace(",", "")) < w * h
    if x < w and y < h:
        assert address.title == f"Address of ({x}, {y})"
        assert address.result == f"{y * w + x:,}"


@pytest.mark.parametrize("width", [280, 400, 600])
def test_fields_and_results_are_seen_whole_in_a_dock_of_any_width(
    qtbot: QtBot, session: Session, width: int
) -> None:
    dock = SumsDock(RasterSetting(session))
    dock._setting.give(sums_typed=True, sum_width=1024, sum_height=768, sum_v_us=2860.0, sum_h_us=10.22)
    put_on_screen(qtbot, dock, width, 500)
    dock.refresh()
    area = dock.findChild(QScrollArea)
    assert isinstance(area, QScrollArea)
    room, body = area.viewport(), area.widget()
    qtbot.waitUntil(lambda: body.width() == room.width())
    parts = [each for kind in (NumberField, QLabel) for each in body.findChildren(kind) if each.isVisible()]
    assert len(parts) > 20
    for part in parts:
        qtbot.waitUntil(lambda part=part: part.width() >= part.minimumSizeHint().width())
        assert part.mapTo(body, part.rect().bottomRight()).x() <= room.width()
