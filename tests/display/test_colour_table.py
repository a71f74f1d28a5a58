"""Frame buffers of few bits: the nearest entry of the table, and what is lost."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display.colour_table import (
    DEPTHS,
    channels_of,
    most_frequent,
    ramp,
    stored,
    table_fault,
    usual_table,
)

colours = st.integers(0, 0xFFFFFF)
pictures = st.integers(1, 7).flatmap(
    lambda width: st.lists(
        st.lists(
            st.one_of(colours, st.sampled_from([0, 0xFFFFFF, 0xFF0000])), min_size=width, max_size=width
        ),
        min_size=1,
        max_size=5,
    )
)


def nearest_by_hand(colour: int, table: tuple[int, ...]) -> int:
    """The first entry with the least sum of squares, channel by channel."""

    def distance(other: int) -> int:
        return sum(((colour >> shift & 255) - (other >> shift & 255)) ** 2 for shift in (0, 8, 16))

    return min(range(len(table)), key=lambda entry: (distance(table[entry]), entry))


@settings(max_examples=60)
@given(pictures, st.sampled_from([1, 2, 4, 8]), st.lists(colours, min_size=1, max_size=20))
def test_every_pixel_gets_its_nearest_entry(rows, depth, table) -> None:
    image = np.array(rows, np.uint32)
    buffer = stored(image, depth, tuple(table))
    kept = tuple(table[: 1 << depth])
    for place, colour in np.ndenumerate(image):
        entry = nearest_by_hand(int(colour), kept)
        assert buffer.bits[place] == entry
        assert buffer.shown[place] == kept[entry]
    before, after = channels_of(image.ravel()), channels_of(buffer.shown.ravel())
    errors = np.abs(before - after)
    loss = buffer.loss
    assert loss.colours == len(set(image.ravel().tolist()))
    assert loss.kept == len(set(buffer.shown.ravel().tolist()))
    assert loss.lost == loss.colours - loss.kept
    assert loss.changed == int((image != buffer.shown).sum())
    assert loss.largest == errors.max()
    assert loss.mean == pytest.approx(errors.mean())


@given(pictures)
def test_a_direct_buffer_loses_nothing(rows) -> None:
    image = np.array(rows, np.uint32)
    buffer = stored(image, 24, ())
    assert np.array_equal(buffer.shown, image)
    assert np.array_equal(buffer.bits, image)
    assert (buffer.loss.lost, buffer.loss.changed, buffer.loss.largest) == (0, 0, 0)


@given(pictures)
def test_a_table_of_the_picture_s_own_colours_loses_nothing(rows) -> None:
    image = np.array(rows, np.uint32)
    table = most_frequent(image, 256)
    assert len(table) == len(set(image.ravel().tolist()))
    assert not stored(image, 8, table).loss.changed
    counts = [int((image == colour).sum()) for colour in table]
    assert counts == sorted(counts, reverse=True)


def test_more_bits_never_err_more_with_ramps() -> None:
    greys = np.array([[value * 0x010101 for value in range(256)]], np.uint32)
    largest = [stored(greys, depth, ramp(1 << depth)).loss.largest for depth in (1, 2, 4, 8)]
    assert largest == [127, 42, 8, 0]


def test_the_usual_tables_have_as_many_entries_as_the_bits_tell_apart() -> None:
    for depth in DEPTHS:
        table = usual_table(depth)
        assert len(table) == (0 if depth == 24 else 1 << depth)
        assert len(set(table)) == len(table)
        assert table_fault(depth, table) == ""
    assert ramp(4, 0xFF0000) == (0x000000, 0x550000, 0xAA0000, 0xFF0000)


def test_a_table_that_is_empty_too_short_or_too_long_is_told_of() -> None:
    assert "too short: 2 bits tell 4 entries apart, and it has 3" in table_fault(2, (0, 1, 2))
    assert "empty" in table_fault(2, ())
    assert "4" in table_fault(2, (0,) * 5)
    assert not stored(np.ones((2, 2), np.uint32), 2, ()).shown.any()
