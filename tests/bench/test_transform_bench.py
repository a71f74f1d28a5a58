"""How fast the transform box answers on many figures, and how fast many different chains are worked out.

Run with ``pytest tests/bench/test_transform_bench.py --benchmark-enable -s``.
"""

import time

import numpy as np
from msgspec.structs import replace
from PySide6.QtWidgets import QApplication, QMainWindow

from tests.bench.drags import measure_drag
from workbench.document.edits import add_figures
from workbench.document.model import Line, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.document.transforms.chains import matrices_of, matrix_of
from workbench.document.transforms.links import Reflect, Rotate, Scale, Shear, Translate
from workbench.panels.draw.panel import DrawPanel
from workbench.session.session import Session

FIGURES, MOVES, LINKS = 100, 300, 50


def test_the_box_on_a_hundred_figures(qtbot, benchmark):
    """300 moves of the box on 100 lines, on 320 x 240 at 1280 x 680; the 99th of the times matters."""
    places = np.random.default_rng(2).uniform((60, 50), (240, 180), (FIGURES, 2, 2)).tolist()
    lines = [Line("", tuple(WorldPoint("", *end) for end in ends), "bresenham_line") for ends in places]
    document = add_figures("s1", lines)(blank_sheet(320, 240))
    session = Session(document=document)
    window = QMainWindow()
    qtbot.addWidget(window)
    panel = DrawPanel(session)
    window.setCentralWidget(panel.center)
    window.resize(1280, 680)
    window.show()
    panel.choose_tool("select")
    names = tuple(figure.id for figure in session.sheet.figures)
    session.update_state(selection=names, active=names[0])
    QApplication.processEvents()
    qtbot.waitUntil(lambda: session.run.done, timeout=20_000)
    panel.boxing.switch(True)
    QApplication.processEvents()
    corner = next(iter(panel.boxing.box.places().values()))  # of any handle
    angle = np.linspace(0, 6 * np.pi, MOVES)
    path = np.array(corner) + 25 * np.column_stack([np.cos(angle) - 1, np.sin(angle)])
    measure_drag(benchmark, f"the box on {FIGURES} figures", panel.canvas, corner, path.tolist())
    qtbot.waitUntil(lambda: session.run.done, timeout=20_000)


def chain(number):
    """50 links of every kind, in none of which two chains are alike."""
    shift = number / 10
    links = (
        Rotate("", angle=7.0 + number, x_pivot=shift),
        Translate("", tx=shift, ty=1.0),
        Scale("", sx=1.01, sy=0.99, x_pivot=shift),
        Reflect("", angle=shift, y_pivot=2.0),
        Shear("", sh_x=0.01, y_ref=shift),
    )
    return tuple(replace(links[k % 5], id=f"t{k}") for k in range(LINKS))


def test_ten_thousand_different_chains(benchmark):
    """All at once, beside one by one."""
    count = 10_000 if not benchmark.disabled else 100
    points = WorldPoint("p0", 0.0, 0.0), WorldPoint("p1", 1.0, 1.0)

    def figures():
        chains = [chain(number) for number in range(count)]
        return [Line(f"f{k}", points, "bresenham_line", transforms=each) for k, each in enumerate(chains)]

    together, alone = figures(), figures()
    work = time.process_time()
    benchmark.pedantic(lambda: matrices_of(together), rounds=1)
    ours = time.process_time() - work
    work = time.process_time()
    each = [matrix_of(figure.transforms) for figure in alone]
    peer = time.process_time() - work
    assert np.array_equal(np.array(each), matrices_of(together))
    print(f"\n{count:,} chains of {LINKS} links: {ours * 1e3:.0f} ms, one by one {peer * 1e3:.0f} ms,")
    print(f"ratio {peer / ours:.1f} of processor time")
