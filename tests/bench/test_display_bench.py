"""What a host frame of a tube costs, time and picture, for a 200 x 150 sheet on 500 pixels."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from fractions import Fraction

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from workbench.algorithms.scanning.beam_strokes import beam_strokes
from workbench.display.driver import TubeDriver
from workbench.display.exposure import Screen
from workbench.display.face_kernels import compile_all
from workbench.display.setup import TubeSetup, raster_tube, vector_beam, vector_tube
from workbench.engine.compiled import paint

HOST = Fraction(10**12, 60)


def _picture() -> np.ndarray:
    image = np.zeros((150, 200), dtype=np.uint32)
    image[20:130:10] = 0xFFFFFF
    image[:, 50] = 0x00FF00
    return image


def _strokes() -> list[tuple[float, float, float, float, int]]:
    made = []
    for k in range(40):
        angle = 2 * np.pi * k / 40
        made.append((100.0, 75.0, 100 + 70 * np.cos(angle), 75 + 70 * np.sin(angle), 0xFFFFFF))
    return made


@pytest.mark.parametrize(
    ("phosphor", "slow", "averaged"),
    [("P31", 1, True), ("P31", 1, False), ("P31", 100, False), ("P31", 10_000, False), ("P7", 100, False)],
)
@pytest.mark.parametrize("kind", ["raster", "vector"])
def test_a_host_frame(
    benchmark: BenchmarkFixture, kind: str, phosphor: str, slow: int, averaged: bool
) -> None:
    setup = TubeSetup(phosphor)
    if kind == "raster":
        tube, beam = raster_tube(_picture(), (500, 375), setup)
        driver = TubeDriver(tube, beam)
    else:
        tube = vector_tube((200, 150), (500, 375), setup)
        driver = TubeDriver(tube, vector_beam(tube, _strokes(), (200, 150), setup))
    screen = Screen((500, 375), [colour for gun in tube.guns for _name, colour in gun.colours])

    def frame() -> None:
        driver.advance(HOST / slow, averaged)
        driver._settled = False  # a steady picture would cost nothing
        screen.picture(driver.lights)

    frame()
    benchmark.pedantic(frame, rounds=40, iterations=1)


@pytest.mark.parametrize("change", [True, False])
def test_a_frame_of_ten_thousand_vectors(benchmark: BenchmarkFixture, change: bool) -> None:
    """A list that has changed is drawn whole, on 640 x 480 pixels; one that stands is only looked at."""
    size = 640, 480
    random = np.random.default_rng(1)
    strokes = np.full((10_000, 5), float(0xFFFFFF))
    strokes[:, 0:2] = random.uniform(20.0, np.array(size) - 20.0, (10_000, 2))
    strokes[:, 2:4] = strokes[:, 0:2] + random.uniform(-8.0, 8.0, (10_000, 2))
    compile_all()
    paint(beam_strokes, np.zeros((1, 1), np.uint32), 0, np.zeros((4, 4)), np.zeros((1, 5)), 0.8)
    tube = vector_tube(size, size, TubeSetup())
    driver = TubeDriver(tube, vector_beam(tube, strokes, size, TubeSetup()))
    screen = Screen(size, [colour for gun in tube.guns for _name, colour in gun.colours])

    def frame() -> None:
        if change:
            driver.show(vector_beam(tube, strokes, size, TubeSetup()))
        driver.advance(HOST, True)
        driver._settled = False
        screen.picture(driver.lights)

    frame()
    benchmark.pedantic(frame, rounds=40, iterations=1)
