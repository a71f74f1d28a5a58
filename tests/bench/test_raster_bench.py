"""A refresh of the raster tube, beam, phosphor and picture: processor time, memory, and NumPy beside it.

A frame may take a quarter of a core at 640 x 480, half of one at 1024 x 768, and at most 100 kB of memory.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import time
import tracemalloc
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from workbench.display import face_kernels
from workbench.display.driver import TubeDriver
from workbench.display.exposure import Screen
from workbench.display.setup import TubeSetup, raster_tube

HOST = Fraction(10**12, 60)
ROUNDS = 60
SHARES = {(640, 480): 0.25, (1024, 768): 0.5}
PASSES = 19
"""How often a pixel of the face is read or written: three terms, four spread rows, light, noise, picture."""


def frame_of(size: tuple[int, int]) -> Callable[[], None]:
    """One picture scanned and shown, on a face with as many pixels as the picture."""
    image = np.zeros(size[::-1], np.uint32)
    image[20:-20:10] = 0xFFFFFF
    image[:, 50] = 0x00FF00
    tube, beam = raster_tube(image, size, TubeSetup())
    driver = TubeDriver(tube, beam)
    screen = Screen(size, [colour for gun in tube.guns for _name, colour in gun.colours])

    def frame() -> None:
        driver.advance(HOST, False)
        screen.picture(driver.lights)

    frame()
    frame()
    return frame


def plain_frame_of(size: tuple[int, int]) -> Callable[[], None]:
    """The same equations as they are written, in NumPy: whole matrices, a new array for each of them."""
    image = np.zeros(size[::-1], np.uint32)
    image[20:-20:10] = 0xFFFFFF
    image[:, 50] = 0x00FF00
    tube, beam = raster_tube(image, size, TubeSetup())
    screen = Screen(size, [tube.guns[0].colours[0][1]])
    terms = tube.guns[0].terms
    spread = [beam._spread_rows(0, tau) for tau in (np.inf, *(term.tau_s for term in terms))]
    kept = [np.float32(np.exp(-1 / (60 * term.tau_s))) for term in terms]
    ages = np.linspace(1.0, 0.0, size[1], dtype=np.float32)[:, None] / 60

    def frame() -> None:
        energy = beam._across @ spread[0]
        light = np.zeros_like(energy)
        for k, (term, share) in enumerate(zip(terms, tube.guns[0].energy_fractions, strict=True)):
            state, tau = tube.stored[0][k], np.float32(term.tau_s)
            left = beam._across @ (np.exp(-ages / tau) * spread[k + 1])
            light = light + state * tau * (1 - kept[k]) + (energy - left) * np.float32(share)
            tube.stored[0][k] = state * kept[k] + left * np.float32(share / term.tau_s)
        screen.picture([light * np.float32(60)])

    frame()
    return frame


def processor_ms(frame: Callable[[], None], rounds: int = ROUNDS) -> float:
    """The median of what a frame takes of a core."""
    taken = []
    for _ in range(rounds):
        before = time.process_time()
        frame()
        taken.append(time.process_time() - before)
    return 1e3 * float(np.median(taken))


def copied_bytes_a_second() -> float:
    """Bytes that a copy reads and writes in a second, in arrays that no cache holds."""
    given = np.ones(16_000_000, np.float32)
    taken = np.empty_like(given)
    best = np.inf
    for _ in range(5):
        before = time.perf_counter()
        np.copyto(taken, given)
        best = min(best, time.perf_counter() - before)
    return 2 * given.nbytes / best


@pytest.mark.parametrize("size", list(SHARES))
def test_a_refresh(size: tuple[int, int], monkeypatch: pytest.MonkeyPatch) -> None:
    face_kernels.compile_all()
    frame = frame_of(size)
    ms = processor_ms(frame)
    tracemalloc.start()
    frame()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    limit = 1e3 * 4 * PASSES * size[0] * size[1] / copied_bytes_a_second()
    for module in ("raster_beam", "exposure"):
        monkeypatch.setattr(f"workbench.display.{module}.at_hand", lambda: False)
    numpy_ms = processor_ms(frame_of(size), 10)
    plain_ms = processor_ms(plain_frame_of(size), 5)
    share = ms * 60 / 1e3
    print(
        f"\n{size[0]} x {size[1]}: {ms:.2f} ms of a core a frame, {100 * share:.0f} % at 60 Hz "
        f"(at most {100 * SHARES[size]:.0f} %); {ms / limit:.1f} times what memory takes; "
        f"the equations in NumPy as they stand {plain_ms:.1f} ms, {plain_ms / ms:.1f} times as long, banded "
        f"and in place {numpy_ms:.1f} ms, {numpy_ms / ms:.1f} times; {peak / 1e3:.0f} kB"
    )
    assert peak < 100_000
