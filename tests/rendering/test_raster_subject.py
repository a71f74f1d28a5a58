"""The frame buffer of a sheet as a subject: which mode, which bits, which table, and what is refused."""

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.display import RasterTiming, raster_modes
from workbench.document.errors import DocumentError
from workbench.document.samples.examples import example
from workbench.document.subjects import Subject
from workbench.rendering import frame_buffer
from workbench.rendering.subjects.raster import (
    ARGUMENTS,
    depth_of,
    fault_of,
    mode_of,
    scan_of,
    table_of,
    timing_of,
    typed,
    with_given,
)
from workbench.rendering.subjects.registry import calls_of, checked

SHEET = example("house").document.sheets[0]
USUAL = Subject("raster")


def test_at_first_the_sheet_itself_is_scanned() -> None:
    (call,) = calls_of(SHEET, USUAL)
    image, table, h_blank, v_blank, fields, width, height = call.arguments
    assert np.array_equal(image, frame_buffer(SHEET))
    assert len(table) == 0
    timing = timing_of(SHEET, USUAL)
    assert timing == RasterTiming.synthesised(SHEET.width_px, SHEET.height_px, 60)
    assert (h_blank, v_blank, fields) == (timing.h_blank, timing.v_blank, 1)
    assert width / height == pytest.approx(SHEET.width_px / SHEET.height_px)


@pytest.mark.parametrize("name", raster_modes())
@pytest.mark.parametrize("at_mode", [False, True])
def test_every_mode_is_scanned_at_its_own_pixels_or_those_of_the_sheet(name: str, at_mode: bool) -> None:
    subject = checked(Subject("raster", arguments={"mode": name, "at_mode": at_mode, "depth": 4}))
    mode = RasterTiming.named(name)
    (call,) = calls_of(SHEET, subject)
    expected = (mode.v_active, mode.h_active) if at_mode else (SHEET.height_px, SHEET.width_px)
    assert call.arguments[0].shape == expected
    assert call.arguments[4] == mode.fields
    assert timing_of(SHEET, subject).refresh_hz == mode.refresh_hz
    assert int(call.arguments[0].max()) < len(call.arguments[1]) == 16


def test_typed_numbers_are_those_of_the_mode_they_began_with() -> None:
    pal = RasterTiming.named("pal-625i")
    subject = checked(with_given(USUAL, **typed(pal)))
    again = mode_of(SHEET, subject)
    assert again.clocks_per_frame == pal.clocks_per_frame
    assert (again.refresh_hz, again.interlaced) == (pal.refresh_hz, True)


def test_what_cannot_be_scanned_has_no_calls_and_a_sentence() -> None:
    mode = typed(RasterTiming.named("vga-640x480-60"))
    for changes in ({"h_sync": 0}, {"h_active": 0}, {"clock_mhz": 0.0}):
        subject = checked(with_given(USUAL, **{**mode, **changes}))
        assert calls_of(SHEET, subject) == []
        assert scan_of(SHEET, subject) is None
        assert fault_of(SHEET, subject).endswith(".")
    wide = checked(with_given(USUAL, **{**mode, "h_active": 8192, "v_active": 4096, "at_mode": True}))
    assert "more than a tube can show" in fault_of(SHEET, wide)


@pytest.mark.parametrize("own", [None, (0.0, float(0xFFB000)), (float(0x000080), 0.0)])
def test_one_bit_tells_what_is_drawn_from_the_background(own: tuple[float, ...] | None) -> None:
    picture = frame_buffer(SHEET)
    paper = SHEET.palette[SHEET.background]
    given = {} if own is None else {"own_table": True, "table": own}
    scan = scan_of(SHEET, checked(with_given(USUAL, depth=1, **given)))
    assert scan is not None
    assert np.array_equal(scan.buffer.bits, picture != paper)
    assert 0 < scan.buffer.bits.sum() < picture.size
    table = (paper, 0xFFFFFF) if own is None else tuple(map(int, own))
    assert np.array_equal(scan.buffer.shown, np.array(table)[scan.buffer.bits])


def test_on_white_paper_one_bit_draws_black() -> None:
    sheet = replace(SHEET, palette=(0xFFFFFF, *SHEET.palette[1:]), background=0)
    assert table_of(sheet, with_given(USUAL, depth=1)) == (0xFFFFFF, 0)


def test_what_is_lost_is_counted_in_the_pixels_that_the_mode_scans() -> None:
    subject = checked(with_given(USUAL, mode="vga-640x480-60", at_mode=True, depth=1))
    scan = scan_of(SHEET, subject)
    assert scan is not None
    whole = scan_of(SHEET, with_given(subject, depth=24))
    assert whole is not None
    assert scan.buffer.bits.size == 640 * 480
    assert scan.buffer.loss.changed == int((scan.buffer.shown != whole.buffer.shown).sum())


def test_an_own_table_is_taken_even_when_it_is_short() -> None:
    subject = checked(with_given(USUAL, depth=2, own_table=True, table=(0.0, float(0xFF0000), -5.0)))
    assert depth_of(subject) == 2
    assert table_of(SHEET, subject) == (0, 0xFF0000, 0)
    scan = scan_of(SHEET, subject)
    assert scan is not None
    assert set(np.unique(scan.buffer.shown)) <= {0, 0xFF0000}
    empty = checked(with_given(USUAL, depth=2, own_table=True, table=()))
    assert not scan_of(SHEET, empty).buffer.shown.any()  # type: ignore[union-attr]


def test_a_depth_between_two_is_the_next_one() -> None:
    assert [depth_of(with_given(USUAL, depth=d)) for d in (1, 3, 5, 9, 24)] == [1, 4, 8, 24, 24]


def test_arguments_out_of_their_range_are_refused() -> None:
    for name, value in (("depth", 0), ("h_sync", -1), ("clock_mhz", -1.0), ("refresh_hz", 0.0), ("mode", 3)):
        assert name in ARGUMENTS
        with pytest.raises(DocumentError):
            checked(with_given(USUAL, **{name: value}))


def test_a_mode_of_another_version_is_scanned_as_vga() -> None:
    assert mode_of(SHEET, with_given(USUAL, mode="cga-9")).refresh_hz == 60
