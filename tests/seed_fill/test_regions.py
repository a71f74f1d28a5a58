"""Every seed fill against the regions that scikit-image labels, for both connectivities."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from numpy.typing import NDArray
from skimage.measure import label

from workbench.algorithms import catalogue
from workbench.algorithms.seed_fill.example import picture
from workbench.engine.compiled import collect, paint
from workbench.engine.limited import collect_limited

FILL, BOUNDARY = 2, 1
Image = NDArray[np.int64]
images = arrays(np.int64, array_shapes(min_dims=2, max_dims=2, max_side=12), elements=st.integers(0, 3))
places = st.integers(-2, 13)

BOUNDARY_FILLS = {
    "boundary_fill_4": 1,
    "boundary_fill_8": 2,
    "boundary_fill_recursive": 1,
    "boundary_fill_spans": 1,
}
FLOOD_FILLS = {"flood_fill_4": 1, "flood_fill_8": 2}


def region_of(fillable: NDArray[np.bool_], groups: Image, x: int, y: int, connectivity: int) -> Any:
    """The region of (x, y) among the ``fillable`` pixels of its group, as a picture of truths."""
    height, width = fillable.shape
    if not (0 <= x < width and 0 <= y < height and fillable[y, x]):
        return np.zeros(fillable.shape, bool)
    regions = label(np.where(fillable, groups + 1, 0), connectivity=connectivity, background=0)
    return regions == regions[y, x]


def pixels(slug: str, emitted: Iterator[tuple[int, ...]]) -> list[tuple[int, int]]:
    """What was emitted as pixels, spans spread out."""
    if catalogue.get(slug).emits != "spans":
        return [(x, y) for x, y in emitted]
    return [(x, y) for y, left, right in emitted for x in range(left, right + 1)]


def holds(slug: str, image: Image, x: int, y: int, arguments: tuple[int, ...], region: Any) -> None:
    """The fill colours this region, each pixel of it once, and emits what it colours."""
    expected = np.where(region, FILL, image)
    made: list[tuple[int, int]] = pixels(slug, catalogue.get(slug).function(image, x, y, *arguments))
    assert np.array_equal(image, expected)
    assert len(set(made)) == len(made) == region.sum()
    assert set(made) == {(x, y) for y, x in np.argwhere(region).tolist()}


@pytest.mark.parametrize(("slug", "connectivity"), BOUNDARY_FILLS.items())
@given(image=images, x=places, y=places)
def test_boundary_fills_colour_the_region_of_the_seed(
    slug: str, connectivity: int, image: Image, x: int, y: int
) -> None:
    fillable = (image != BOUNDARY) & (image != FILL)
    region = region_of(fillable, np.zeros_like(image), x, y, connectivity)
    holds(slug, image, x, y, (FILL, BOUNDARY), region)


@pytest.mark.parametrize(("slug", "connectivity"), FLOOD_FILLS.items())
@given(image=images, x=places, y=places)
def test_flood_fills_colour_the_region_of_the_seed_s_colour(
    slug: str, connectivity: int, image: Image, x: int, y: int
) -> None:
    region = region_of(image != FILL, image, x, y, connectivity)
    holds(slug, image, x, y, (FILL,), region)


@given(image=images, x=places, y=places)
def test_all_that_four_ways_reach_eight_do(image: Image, x: int, y: int) -> None:
    for four, eight, colours in (
        ("boundary_fill_4", "boundary_fill_8", (FILL, BOUNDARY)),
        ("flood_fill_4", "flood_fill_8", (FILL,)),
    ):
        reached = [set(catalogue.get(slug).function(image.copy(), x, y, *colours)) for slug in (four, eight)]
        assert reached[0] <= reached[1]


class Guarded(np.ndarray[Any, Any]):
    """A picture that lets nobody look or write beside it: an index below 0 would count from the other end."""

    def _inside(self, place: Any) -> None:
        indexes = place if isinstance(place, tuple) else (place,)
        for index, side in zip(indexes, self.shape, strict=False):
            first, last = (index.start, index.stop - 1) if isinstance(index, slice) else (index, index)
            assert 0 <= first <= last < side, place

    def __getitem__(self, place: Any) -> Any:
        self._inside(place)
        return super().__getitem__(place)

    def __setitem__(self, place: Any, value: Any) -> None:
        self._inside(place)
        super().__setitem__(place, value)


@pytest.mark.parametrize("slug", [*BOUNDARY_FILLS, *FLOOD_FILLS])
@given(image=images, x=places, y=places)
def test_nothing_is_read_or_written_outside_the_picture(slug: str, image: Image, x: int, y: int) -> None:
    colours = (FILL, BOUNDARY) if slug in BOUNDARY_FILLS else (FILL,)
    list(catalogue.get(slug).function(image.view(Guarded), x, y, *colours))


@pytest.mark.parametrize("slug", ["boundary_fill_4", "boundary_fill_8", "boundary_fill_spans"])
def test_a_large_region_compiled(slug: str) -> None:
    """A maze of walls with gaps, 200 x 300, filled in place by the compiled text."""
    image = np.zeros((200, 300), np.uint32)
    generator = np.random.default_rng(3)
    image[generator.random(image.shape) < 0.35] = BOUNDARY
    image[100, 150] = 0
    connectivity = BOUNDARY_FILLS[slug]
    region = region_of(image != BOUNDARY, np.zeros(image.shape, np.int64), 150, 100, connectivity)
    assert 1000 < region.sum() < image.size
    function = catalogue.get(slug).function
    emitted = collect(function, image, 150, 100, FILL, BOUNDARY)
    assert len(pixels(slug, iter(emitted.tolist()))) == region.sum()
    paint(function, image, FILL, image, 150, 100, FILL, BOUNDARY)
    assert np.array_equal(image == FILL, region)


LEAKING = (
    "0000000",
    "0001000",
    "0010100",
    "0100010",
    "0010100",
    "0001000",
    "0000000",
)


@pytest.mark.parametrize(
    ("slug", "leaks"), [("boundary_fill_4", False), ("boundary_fill_8", True), ("boundary_fill_spans", False)]
)
def test_a_boundary_that_touches_at_corners_holds_four_ways_and_leaks_eight_ways(
    slug: str, leaks: bool
) -> None:
    image = picture(*LEAKING)
    list(catalogue.get(slug).function(image, 3, 3, FILL, BOUNDARY))
    assert bool(image[0, 0] == FILL) is leaks


def open_area(side: int) -> Image:
    image = np.zeros((side, side), np.int64)
    image[[0, -1], :] = image[:, [0, -1]] = BOUNDARY
    return image


@pytest.mark.parametrize("side", [60, 500])
def test_the_recursion_overflows_is_told_and_hurts_nothing(side: int) -> None:
    image = open_area(side)
    function: Callable[..., Any] = catalogue.get("boundary_fill_recursive").function
    found = collect_limited(function, 1000, image, side // 2, side // 2, FILL, BOUNDARY)
    assert found.overflowed
    filled = np.count_nonzero(image == FILL)
    assert 0 < filled == len(found.rows) < (side - 2) ** 2
    assert np.array_equal(image == BOUNDARY, open_area(side) == BOUNDARY)


def test_a_limit_beyond_the_area_is_never_reached() -> None:
    image = open_area(30)
    function = catalogue.get("boundary_fill_recursive").function
    found = collect_limited(function, 4000, image, 15, 15, FILL, BOUNDARY)
    assert not found.overflowed
    assert np.count_nonzero(image == FILL) == len(found.rows) == 28 * 28
