"""The storage tube: what is above the threshold in one pass stays, until all of it is erased."""

import numpy as np
import pytest

from workbench.display.storage_tube import BACKGROUND, ERASE_S, FADE_S, STORED, StorageTube

LINE = ((5.0, 10.0), (35.0, 10.0), 1.0)
OTHER = ((5.0, 20.0), (35.0, 20.0), 1.0)


def made() -> StorageTube:
    """A face of 80 x 60 pixels, two to a millimetre."""
    return StorageTube((80, 60), (40.0, 30.0), spot_mm=0.5)


def test_a_stroke_at_writing_speed_is_kept_for_minutes_without_refresh() -> None:
    tube = made()
    assert tube.write([LINE]) > 0
    stored = tube.stored.copy()
    tube.advance(60.0)
    assert (tube.stored == stored).all()
    light = tube.light()
    assert light[stored].min() == pytest.approx(
        BACKGROUND + (STORED - BACKGROUND) * np.exp(-60.0 / FADE_S), rel=1e-5
    )
    assert light[~stored].max() == pytest.approx(BACKGROUND)
    assert tube.still


def test_a_stroke_that_is_too_fast_only_flashes_and_nothing_adds_up() -> None:
    tube = made()
    for _pass in range(20):
        assert tube.write([LINE], slowness=0.4) == 0
        assert tube.light().max() > 2 * BACKGROUND
    assert not tube.stored.any()
    assert tube.light().max() > BACKGROUND
    tube.advance(1.0)
    assert tube.light().max() == pytest.approx(BACKGROUND)


def test_writing_through_is_seen_but_not_stored() -> None:
    tube = made()
    tube.write([LINE])
    stored = tube.stored.copy()
    tube.write_through([OTHER])
    assert tube.light()[40].max() > 2 * BACKGROUND
    tube.advance(1.0)
    assert (tube.stored == stored).all()
    assert tube.light()[40].max() == pytest.approx(BACKGROUND)


def test_erasing_flashes_takes_its_time_and_leaves_nothing() -> None:
    tube = made()
    tube.write([LINE, OTHER])
    tube.erase()
    assert tube.light().min() == 1.0
    assert tube.light(flashes=False).max() < 0.1
    assert tube.write([LINE]) == 0, "nothing is written meanwhile"
    tube.advance(ERASE_S / 2)
    assert tube.erasing
    tube.advance(ERASE_S / 2)
    assert not tube.erasing
    assert not tube.stored.any()
    assert tube.write([LINE]) > 0


def test_a_tube_of_another_size_goes_on_with_the_erasure_and_the_age_of_the_one_before() -> None:
    before, after = made(), made()
    before.advance(60.0)
    before.erase()
    before.advance(0.6 * ERASE_S)
    after.continue_from(before)
    assert (after.light() == before.light()).all()
    after.advance(0.5 * ERASE_S)
    assert not after.erasing
    before.advance(0.5 * ERASE_S)
    for tube in (before, after):
        tube.stored[:4] = True
    assert (after.light() == before.light()).all()


def test_there_is_no_way_to_erase_a_part() -> None:
    """One more stroke, of whatever current, never takes anything away."""
    tube = made()
    tube.write([LINE])
    stored = tube.stored.copy()
    for current in (0.0, 0.2, 1.0):
        tube.write([(LINE[0], LINE[1], current)])
        assert (tube.stored | ~stored).all()
