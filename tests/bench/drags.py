"""Drags on a canvas, measured from the mouse event to the painted frame."""

import time

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

MOVES = 500


def mouse(canvas, kind, x, y, button=Qt.MouseButton.LeftButton):
    place = canvas.widget_position(x, y)
    button_now = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseMove else button
    buttons = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else button
    position = QPointF(place)
    event = QMouseEvent(
        kind, position, canvas.mapToGlobal(position), button_now, buttons, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(canvas, event)


class Frames:
    """Counts painted frames of a canvas by watching its paint events end."""

    def __init__(self, canvas):
        self.painted = 0
        paint = canvas.paintEvent

        def counted(event):
            paint(event)
            self.painted += 1

        canvas.paintEvent = counted


def measure_drag(benchmark, title, canvas, begin, path):
    """Press at ``begin``, move along ``path`` (m, 2), sheet, and print what the moves took; 16 ms allowed."""
    frames = Frames(canvas)
    times, busy = [], []

    def drag():
        times.clear()
        busy.clear()
        mouse(canvas, QEvent.Type.MouseButtonPress, *begin)
        for x, y in path:
            before, worked, seen = time.perf_counter(), time.thread_time(), frames.painted
            mouse(canvas, QEvent.Type.MouseMove, x, y)
            while frames.painted == seen:
                QApplication.processEvents()
            times.append((time.perf_counter() - before) * 1e3)
            busy.append((time.thread_time() - worked) * 1e3)
        mouse(canvas, QEvent.Type.MouseButtonRelease, x, y)
        QApplication.processEvents()

    benchmark.pedantic(drag, rounds=1)
    p50, p99, worst = np.percentile(times, [50, 99, 100])
    own = np.percentile(busy, [50, 99])
    print(f"\n{title}: median {p50:.1f}, 99th of {len(path)} {p99:.1f}, worst {worst:.1f} ms; 16 ms allowed")
    print(f"of which this thread worked: median {own[0]:.1f}, 99th {own[1]:.1f} ms")
    benchmark.extra_info.update(median_ms=p50, p99_ms=p99)
