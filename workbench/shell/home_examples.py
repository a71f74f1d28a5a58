"""Small pictures of the examples, for Home."""

from collections.abc import Iterator

from PySide6.QtCore import QLineF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen, QPixmap

from workbench.document.samples.examples import Example, examples
from workbench.document.samples.figures import PALETTE
from workbench.document.scene.model import Scene
from workbench.rendering import frame_buffer
from workbench.rendering.scene import wireframe
from workbench.rendering.scene.viewpoint import window_around
from workbench.shell.home import THUMBNAIL


def thumbnails(ratio: float) -> Iterator[tuple[Example, QPixmap]]:
    """Each example and its picture, one at a time since each takes a few milliseconds."""
    for example in examples():
        yield example, _thumbnail(example, ratio)


def _thumbnail(example: Example, ratio: float) -> QPixmap:
    """The figures alone, in whole device pixels per cell; their colours suit both themes."""
    scene = example.document.sheets[0].scene
    if scene is not None:
        return _edges(scene, ratio)
    pixels = frame_buffer(example.document.sheets[0])
    height, width = pixels.shape
    paper = example.document.sheets[0].palette[example.document.sheets[0].background]
    flipped = pixels[::-1].copy()
    flipped[flipped != paper] |= 0xFF000000
    flipped[flipped == paper] = 0
    image = QImage(flipped.data, width, height, width * 4, QImage.Format.Format_ARGB32).copy()
    room = THUMBNAIL * ratio
    made = QPixmap(room)
    made.fill(Qt.GlobalColor.transparent)
    largest = min(room.width() / width, room.height() / height)
    cells = largest if largest < 1 else float(int(largest))
    smooth = Qt.TransformationMode.SmoothTransformation
    scaled = image.scaled(
        round(width * cells),
        round(height * cells),
        Qt.AspectRatioMode.KeepAspectRatio,
        smooth if cells < 1 else Qt.TransformationMode.FastTransformation,
    )
    painter = QPainter(made)
    painter.drawImage((room.width() - scaled.width()) // 2, (room.height() - scaled.height()) // 2, scaled)
    painter.end()
    made.setDevicePixelRatio(ratio)
    return made


def _edges(scene: Scene, ratio: float) -> QPixmap:
    """The edges of a scene, which need no text to be compiled."""
    room = THUMBNAIL * ratio
    made = QPixmap(room)
    made.fill(Qt.GlobalColor.transparent)
    segments = wireframe(scene)
    window = window_around(segments.reshape(-1, 2), (room.width(), room.height()))
    scale = room.width() / (window.xmax - window.xmin)
    painter = QPainter(made)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(PALETTE[1]), 1.2 * ratio))
    for x0, y0, x1, y1 in segments.tolist():
        painter.drawLine(
            QLineF(
                (x0 - window.xmin) * scale,
                (window.ymax - y0) * scale,
                (x1 - window.xmin) * scale,
                (window.ymax - y1) * scale,
            )
        )
    painter.end()
    made.setDevicePixelRatio(ratio)
    return made
