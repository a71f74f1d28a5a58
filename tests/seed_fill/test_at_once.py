"""What stands for a fill that is not compiled yet colours the pixels that the text colours."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from workbench.algorithms import catalogue
from workbench.document.edits import add_figure
from workbench.document.model import SeedFill, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.memory import forget
from workbench.rendering import emissions, frame_buffer, raster

SLUGS = [entry.slug for entry in catalogue.entries() if entry.at_once is not None]
pictures = arrays.arrays(
    np.int64, st.tuples(st.integers(1, 12), st.integers(1, 12)), elements=st.integers(0, 2)
)


def test_every_fill_that_is_compiled_has_one() -> None:
    fills = [e.slug for e in catalogue.entries() if "seed_fill" in e.draws and not e.compiles]
    assert sorted(SLUGS) == sorted(fills)


@pytest.mark.parametrize("slug", SLUGS)
@settings(max_examples=200)
@given(pictures, st.integers(-1, 12), st.integers(-1, 12), st.integers(0, 3), st.integers(0, 3))
def test_both_colour_the_same_pixels(
    slug: str, image: np.ndarray, x: int, y: int, fill: int, stop: int
) -> None:
    entry = catalogue.get(slug)
    colours = (fill, stop)[: len(entry.parameter_names) - 3]
    coloured = np.zeros(image.shape, bool)
    for emitted in entry.function(image.copy(), x, y, *colours):
        if entry.emits == "spans":
            row, left, right = emitted
            coloured[row, left : right + 1] = True
        else:
            coloured[emitted[1], emitted[0]] = True
    assert np.array_equal(entry.at_once(image, x, y, *colours), coloured)


@pytest.mark.parametrize("slug", SLUGS)
def test_a_picture_waits_for_no_text_that_is_not_compiled(slug: str, monkeypatch: pytest.MonkeyPatch) -> None:
    document = blank_sheet(400, 300)
    sheet = document.sheets[0]
    fill = SeedFill("", (WorldPoint("", 20.0, 30.0),), slug, colour=2)
    sheet = add_figure(sheet.id, fill)(document).sheets[0]
    forget()
    compiled = frame_buffer(sheet).copy()
    forget()
    raster._composite.cache_clear()
    for module in (raster, emissions):
        monkeypatch.setattr(module, "at_hand", lambda *_use: False)
    monkeypatch.setattr(emissions, "_run", lambda call: pytest.fail(f"{call.entry.slug} was run"))
    assert np.array_equal(frame_buffer(sheet), compiled)
    assert (compiled == sheet.palette[2]).all()
