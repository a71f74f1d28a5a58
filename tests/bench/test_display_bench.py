"""What a host frame of a tube costs, time and picture, for a 200 x 150 sheet on 500 pixels."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from fractions import Fraction

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from workbench.display.driver import TubeDriver
from workbench.display.exposure import Screen
from workbench.display.setup import TubeSetup, raster_tube, vector_beam, vector_tube

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
