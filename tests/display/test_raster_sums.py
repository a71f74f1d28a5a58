"""The sums of exams about raster displays: closed formulas and the numbers that books have."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.display import RasterTiming, raster_modes
from workbench.display import raster_sums as of

VGA = RasterTiming.named("vga-640x480-60")
sides, depths = st.integers(1, 4096), st.sampled_from([1, 2, 4, 8, 12, 24])
rates = st.fractions(1, 240, max_denominator=1001)


def test_the_numbers_of_vga() -> None:
    """Those of a course: with no retrace 54.3 ns a pixel, in truth 39.7 ns."""
    assert of.frame_buffer_bytes(640, 480, 24) == 921_600
    assert of.address_of(3, 2, 640) == 1283
    assert float(of.plain_pixel_s(640, 480, Fraction(60))) == pytest.approx(54.25e-9, rel=1e-4)
    assert float(of.plain_line_s(480, Fraction(60))) == pytest.approx(34.72e-6, rel=1e-4)
    assert float(VGA.pixel_s) == pytest.approx(39.7219464e-9, rel=1e-8)
    assert float(VGA.line_s) == pytest.approx(31.7775571e-6, rel=1e-8)
    assert float(VGA.refresh_hz) == pytest.approx(59.9404762, rel=1e-8)
    assert float(1 - VGA.lit_share) == pytest.approx(1 - 0.731429, abs=1e-6)
    assert float(of.loading_s(of.frame_buffer_bits(640, 480, 24), Fraction(100_000))) == pytest.approx(73.728)
    assert of.aspect(640, 480) == (4, 3)
    assert of.pixel_aspect(640, 480) == 1
    assert of.pixel_aspect(1280, 1024) == Fraction(16, 15)


def test_a_line_of_which_a_quarter_flies_back() -> None:
    """704 clocks of 15.6672 MHz a line, 512 of them seen; 370 lines, 342 of them seen."""
    clock = Fraction(15_667_200)
    hz, h, v = clock / (704 * 370), 192 / clock, 28 * 704 / clock
    assert float(hz) == pytest.approx(60.147, abs=1e-3)
    assert float(of.line_s(342, hz, v)) == pytest.approx(44.935e-6, rel=1e-4)
    assert float(of.pixel_s(512, 342, hz, h, v)) == pytest.approx(63.83e-9, rel=1e-4)
    assert float(of.retrace_share(342, hz, h, v)) == pytest.approx(1 - 512 * 342 / (704 * 370))


@pytest.mark.parametrize("name", raster_modes())
def test_the_retraces_of_a_mode_give_its_own_pixel_time(name: str) -> None:
    mode = RasterTiming.named(name)
    h, v = mode.h_blank * mode.pixel_s, mode.v_blank * mode.line_s
    size = mode.h_active, mode.v_active
    assert of.pixel_s(*size, mode.refresh_hz, h, v) == mode.pixel_s
    assert of.line_s(mode.v_active, mode.refresh_hz, v) == mode.line_s
    assert of.retrace_share(mode.v_active, mode.refresh_hz, h, v) == 1 - mode.lit_share


@given(sides, sides, rates)
def test_without_retraces_both_formulas_agree(width: int, height: int, hz: Fraction) -> None:
    nothing = Fraction(0)
    assert of.pixel_s(width, height, hz, nothing, nothing) == of.plain_pixel_s(width, height, hz)
    assert (
        of.line_s(height, hz, nothing)
        == of.plain_line_s(height, hz)
        == width * of.plain_pixel_s(width, height, hz)
    )


@given(sides, sides, st.integers(0, 4095), st.integers(0, 4095), depths)
def test_addresses_are_those_of_counting(width: int, height: int, x: int, y: int, bits: int) -> None:
    x, y = x % width, y % height
    address = of.address_of(x, y, width)
    assert divmod(address, width) == (y, x)
    byte, bit = of.byte_and_bit(address, bits)
    assert byte * 8 + bit == address * bits
    last = of.address_of(width - 1, height - 1, width)
    assert last + 1 == width * height
    assert of.frame_buffer_bytes(width, height, bits) * 8 == (last + 1) * bits


@given(sides, sides, depths, rates)
def test_what_is_read_out_is_the_buffer_each_frame(width: int, height: int, bits: int, hz: Fraction) -> None:
    rate = of.scan_out_rate(width, height, bits, hz)
    assert rate / hz == of.frame_buffer_bytes(width, height, bits)
    assert of.loading_s(of.frame_buffer_bits(width, height, bits), rate * 8) == 1 / hz
