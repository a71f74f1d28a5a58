"""Modes that are scaled or typed, their parts over time, and the path of the beam."""

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms.scanning.raster_scan import raster_scan
from workbench.display import RasterTiming, raster_modes
from workbench.display.beam_path import beam_path, frame_segments, line_segments
from workbench.display.colour_table import stored, usual_table
from workbench.display.scan import Scan, resampled
from workbench.engine.recorder import record

VGA = RasterTiming.named("vga-640x480-60")


@given(st.sampled_from(raster_modes()), st.integers(2, 90), st.integers(2, 70))
def test_a_mode_around_other_pixels_keeps_its_rate_and_its_fields(name: str, width: int, height: int) -> None:
    mode = RasterTiming.named(name)
    scaled = mode.scaled(width, height)
    assert (scaled.h_active, scaled.v_active) == (width, height)
    assert scaled.refresh_hz == mode.refresh_hz
    assert scaled.interlaced == mode.interlaced
    assert not scaled.fault


@pytest.mark.parametrize("name", raster_modes())
def test_the_parts_of_a_line_and_a_frame_are_where_the_beam_is(name: str) -> None:
    mode = RasterTiming.named(name)
    across, down = line_segments(mode), frame_segments(mode)
    assert sum(part.length for part in across) == mode.h_total
    assert sum(part.length for part in down) == mode.v_total
    assert sum(part.length for part in down if part.kind == "active") == mode.v_active
    for line in range(mode.v_total):
        middle = line + 0.5
        part = next(p for p in down if p.start <= middle < p.start + p.length)
        assert (part.kind == "active") == (mode.row_of_line(line) is not None)
    kinds = [part.kind for part in down]
    assert kinds == ["active", "front_porch", "sync", "back_porch"] * mode.fields


def test_what_cannot_be_scanned_says_why() -> None:
    for changes, word in (
        ({"h_active": 0}, "no pixels"),
        ({"v_sync": 0}, "sync"),
        ({"h_back_porch": -700}, "smaller than the picture"),
        ({"pixel_clock_hz": Fraction(0)}, "clock of 0 MHz"),
        ({"pixel_clock_hz": Fraction(5e-324) * 10**6}, "clock of 4.94066e-324 MHz"),
        ({"v_active": 1, "interlaced": True}, "two lines"),
    ):
        assert word in replace(VGA, **changes).fault
    assert VGA.fault == ""


def test_the_sources_doubts_come_with_a_mode() -> None:
    assert "v_sync" in RasterTiming.named("mda-720x350-50").uncertain_fields
    assert VGA.uncertain_fields == ()


@given(st.integers(1, 200), st.booleans(), st.integers(2, 50))
def test_the_path_goes_on_where_it_was_and_ends_at_the_top(height: int, interlaced: bool, most: int) -> None:
    mode = replace(VGA, v_active=height, interlaced=interlaced and height > 1)
    path = beam_path(mode, most)
    for field in range(mode.fields):
        own = [stretch for stretch in path if stretch.field == field]
        lines = [s for s in own if s.kind == "line"]
        assert 1 <= len(lines) <= most
        assert all(s.end[1] == s.begin[1] for s in lines)
        assert own[-1].end[1] == 0.0
        ways = [s for s in own if s.kind != "vertical"]
        assert all(a.end == b.begin for a, b in pairwise(ways))
    if most >= height:
        rows = [s.begin[1] for s in path if s.kind == "line"]
        assert sorted(rows) == [row + 0.5 for row in range(height)]


def test_a_picture_is_enlarged_pixel_by_pixel() -> None:
    image = np.arange(12, dtype=np.uint32).reshape(3, 4)
    mode = replace(VGA, h_active=12, v_active=6)
    assert np.array_equal(resampled(image, mode), image.repeat(2, axis=0).repeat(3, axis=1))


@pytest.mark.parametrize("interlaced", [False, True])
@pytest.mark.parametrize("depth", [2, 24])
def test_each_clock_has_the_numbers_of_the_text(interlaced: bool, depth: int) -> None:
    """Where the text sends a pixel, the scan tells the same address, bits, colour, place and clock."""
    image = np.random.default_rng(4).integers(0, 1 << 24, (5, 6)).astype(np.uint32)
    mode = replace(VGA, h_active=6, v_active=5, interlaced=interlaced)
    scan = Scan(mode, stored(image, depth, usual_table(depth)), (60.0, 40.0))
    arguments = (scan.buffer.bits, scan.table, mode.h_blank, mode.v_blank, mode.fields, *scan.size_mm)
    recording = record(raster_scan, *arguments)
    names = {
        "field",
        "line",
        "x",
        "y",
        "address",
        "bits",
        "colour",
        "red",
        "green",
        "blue",
        "x_mm",
        "y_mm",
        "clock",
    }
    told = []
    before: dict[str, object] = {}
    for event in range(len(recording)):
        now = recording[event].variables
        if (
            before.get("clock") != now.get("clock")
            and "x_mm" in before
            and int(now["clock"]) == int(before["clock"]) + 1
        ):
            told.append({name: before[name] for name in names})
        before = dict(now)
    assert len(told) == 30
    for text in told:
        moment = scan.at(int(text["clock"]))
        assert moment is not None
        assert moment._asdict() == pytest.approx({name: float(value) for name, value in text.items()})
    dark = [clock for clock in range(mode.clocks_per_frame) if scan.at(clock) is None]
    assert len(dark) == mode.clocks_per_frame - 30


@pytest.mark.parametrize("name", ["vga-640x480-60", "pal-625i"])
def test_a_pixel_is_hit_when_its_line_is_scanned(name: str) -> None:
    """Between the begin and the end of its clock, in the line of its row counted from above."""
    timing = RasterTiming.named(name)
    for x, y in ((0, 0), (5, 1), (timing.h_active - 1, timing.v_active - 1)):
        line, clock = divmod(timing.hit_s(x, y) * timing.pixel_clock_hz, timing.h_total)
        assert timing.row_of_line(int(line)) == timing.v_active - 1 - y
        assert clock == x + Fraction(1, 2)
