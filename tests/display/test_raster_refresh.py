"""The compiled way of the raster tube gives the light of the NumPy way."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display import RasterBeam, Tube, face_kernels
from workbench.display.driver import TubeDriver
from workbench.display.exposure import Screen
from workbench.display.setup import TubeSetup, raster_tube
from workbench.display.timings import RasterTiming

SIZE = 60, 45
TICKS = 10**12


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    face_kernels.compile_all()
    assert face_kernels.at_hand()


def picture(seed: int, dark: float = 0.4) -> np.ndarray:
    chance = np.random.default_rng(seed)
    image = chance.integers(0, 1 << 24, (12, 16)).astype(np.uint32)
    image[chance.random((12, 16)) < dark] = 0
    image[3] = image[4]
    image[7] = 0
    return image


def both(seed: int, phosphor: str, interlaced: bool) -> list[tuple[Tube, RasterBeam]]:
    """The same tube by compiled texts and by NumPy in float64."""
    timing = RasterTiming.named("ntsc-525i").scaled(16, 12) if interlaced else None
    pairs = [
        raster_tube(picture(seed), SIZE, TubeSetup(phosphor), kind, timing)
        for kind in (np.float32, np.float64)
    ]
    assert pairs[0][1]._compiled(pairs[0][0]) is not None
    assert pairs[1][1]._compiled(pairs[1][0]) is None
    return pairs


def alike(a: np.ndarray, b: np.ndarray) -> bool:
    return bool(np.abs(a - b).max() <= 2e-5 * max(np.abs(b).max(), 1e-6) + 2e-6)


@settings(max_examples=25, deadline=None)
@given(
    st.integers(0, 99),
    st.sampled_from(["P31", "P1", "P7", "P22"]),
    st.booleans(),
    st.lists(st.one_of(st.integers(1, 10**9), st.integers(10**9, 5 * 10**10)), min_size=1, max_size=6),
)
def test_both_ways_give_the_same_light_however_time_is_cut(seed, phosphor, interlaced, cuts) -> None:
    (fast, fast_beam), (slow, slow_beam) = both(seed, phosphor, interlaced)
    for beam, tube in ((fast_beam, fast), (slow_beam, slow)):
        beam.settle(tube)
        tube.exposure()
        for ticks in cuts:
            beam.play(tube, ticks)
    assert fast.ticks == slow.ticks
    for gun in range(len(fast.guns)):
        assert alike(fast.stored[gun], slow.stored[gun])
    seconds = sum(cuts) / TICKS
    for a, b in zip(fast.exposure(), slow.exposure(), strict=True):
        assert alike(a / seconds, b / seconds)
    assert fast.deposited_energy() == pytest.approx(slow.deposited_energy(), rel=1e-4)


def test_a_whole_frame_leaves_the_same_energy() -> None:
    (_fast, fast_beam), (_slow, slow_beam) = both(3, "P22", False)
    for gun in range(3):
        assert alike(fast_beam.energy_per_frame(gun) * 60, slow_beam.energy_per_frame(gun) * 60)


def test_the_picture_of_the_screen_is_that_of_numpy_to_one_level(monkeypatch: pytest.MonkeyPatch) -> None:
    tube, beam = raster_tube(picture(5), SIZE, TubeSetup("P31"))
    colours = [colour for gun in tube.guns for _name, colour in gun.colours]
    light = [beam.energy_per_frame() * np.float32(60)]
    printed = Screen(SIZE, colours).picture([light[0].copy()]).copy()
    monkeypatch.setattr("workbench.display.exposure.at_hand", lambda: False)
    plain = Screen(SIZE, colours).picture([light[0].copy()])
    for shift in (0, 8, 16):
        a, b = ((each >> shift & 255).astype(int) for each in (printed, plain))
        assert np.abs(a - b).max() <= 2
    assert printed.max() > 0xFF101010


def test_a_frame_allocates_next_to_nothing() -> None:
    import tracemalloc

    image = np.zeros((480, 640), np.uint32)
    image[::10] = 0xFFFFFF
    tube, beam = raster_tube(image, (640, 480), TubeSetup())
    driver, screen = TubeDriver(tube, beam), Screen((640, 480), [tube.guns[0].colours[0][1]])

    def frame() -> None:
        driver.advance(Fraction(TICKS, 60), False)
        screen.picture(driver.lights)

    for _ in range(3):
        frame()
    tracemalloc.start()
    frame()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 100_000
