"""A tick of playing, from the clock to the painted frame, in Animate at 1280 x 680.

Run it by hand with ``-s -p no:xdist`` on a quiet machine: 100 figures with 20 tracks each over a picture of
320 x 240 play at 60 frames a second, 20,000 triangles under a moving camera at 30.
"""

import math
import time

import numpy as np
from msgspec.structs import replace
from PySide6.QtWidgets import QApplication

from tests.bench.drags import Frames
from workbench.algorithms.visibility import depth_buffer
from workbench.document.building import with_sheet
from workbench.document.model import Document
from workbench.document.motion.model import Key, Motion, Track
from workbench.document.samples.examples import blank_sheet
from workbench.document.samples.figures import document_of, polygon
from workbench.document.scene import edits as scene_edits
from workbench.document.scene.model import Object
from workbench.document.scene.solids import Sphere
from workbench.engine.compiled import ready
from workbench.engine.warm import load
from workbench.panels.animate.panel import AnimatePanel
from workbench.session import Session

TICKS = 300
FRAMES = 120


def track(number: int, target: str, values: list[tuple[float, ...]]) -> Track:
    keys = tuple(
        Key(f"k{number}-{at}-", at * (FRAMES // len(values)), value, "ease_in_out")
        for at, value in enumerate(values)
    )
    return Track(f"a{number}-", target, keys)


def moving(document: Document, tracks: list[Track]) -> Document:
    sheet = replace(document.sheets[0], motion=Motion(FRAMES, 60.0, tuple(tracks)))
    return with_sheet(document, sheet)


def figures() -> Document:
    """100 polygons of ten corners, each number of which has a track."""
    chance = np.random.default_rng(1)
    corners = [(8 * math.cos(k * math.pi / 5), 8 * math.sin(k * math.pi / 5)) for k in range(10)]
    places = chance.uniform(12, 228, (100, 2))
    rings = [[(x + dx, y + dy) for dx, dy in corners] for x, y in places.tolist()]
    shapes = [polygon([ring], 1 + k % 5, f"Star {k}") for k, ring in enumerate(rings)]
    document = document_of("100 figures", 320, 240, shapes)
    tracks = []
    for figure in document.sheets[0].figures:
        for point in figure.points_world:
            for name in ("x", "y"):
                begin = getattr(point, name)
                values = [(begin + far,) for far in (0.0, *chance.uniform(-20, 80, 3).tolist())]
                tracks.append(track(len(tracks), f"{figure.id}/{point.id}/{name}", values))
    return moving(document, tracks)


def scene() -> Document:
    """A sphere of 20,000 triangles, around which the eye goes."""
    document = blank_sheet(320, 240)
    ball = Object("", solid=Sphere(slices=100, stacks=101), material="")
    document = scene_edits.add_object(document.sheets[0].id, ball)(document)
    eyes = [(5 * math.sin(a), 2.0, 5 * math.cos(a)) for a in np.linspace(0.0, 5.0, 6).tolist()]
    return moving(document, [track(0, "scene.camera.eye", eyes)])


def play(qtbot, benchmark, title: str, document: Document, allowed: int) -> None:
    session = Session(document=document)
    for figure in session.sheet.figures[:1]:  # as the program has it before it is asked for
        load(figure.drawn_with, lambda: False)
    panel = AnimatePanel(session)
    qtbot.addWidget(panel)
    panel.resize(1280, 680)
    panel.show()
    if session.sheet.scene is not None:
        load("depth_buffer", lambda: False)
        assert ready(depth_buffer)
    qtbot.wait(500)
    painted, times, busy = Frames(panel.canvas), [], []
    frames = session.frames
    frames.mode = "loop"

    def ticks() -> None:
        frames.play()
        frames._timer.setInterval(1 << 30)  # ticks come one by one
        for number in range(TICKS):
            frames._since = (0.0, 0.0)
            frames._clock = lambda number=number: (number + 1.5) / 60.0
            seen, began, worked = painted.painted, time.perf_counter(), time.thread_time()
            frames.tick()
            while painted.painted == seen:
                QApplication.processEvents()
            times.append((time.perf_counter() - began) * 1e3)
            busy.append((time.thread_time() - worked) * 1e3)
        frames.stop()

    benchmark.pedantic(ticks, rounds=1)
    p50, p99, worst = np.percentile(times, [50, 99, 100])
    own = np.percentile(busy, [50, 99])
    print(
        f"\n{title}: median {p50:.1f}, 99th of {TICKS} {p99:.1f}, worst {worst:.1f} ms; {allowed} ms allowed"
    )
    print(f"of its own thread: median {own[0]:.1f}, 99th {own[1]:.1f} ms")
    session.close()


def test_a_hundred_figures_with_twenty_tracks_each(qtbot, benchmark) -> None:
    play(qtbot, benchmark, "100 figures, 2,000 tracks", figures(), 16)


def test_twenty_thousand_triangles_under_a_moving_camera(qtbot, benchmark) -> None:
    play(qtbot, benchmark, "20,000 triangles", scene(), 33)
