"""Small pictures of the examples, for Home."""

from collections.abc import Iterator

from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPainter, QPixmap

from workbench.document.samples.examples import Example, examples
from workbench.rendering import frame_buffer
from workbench.shell.home import THUMBNAIL


def thumbnails(ratio: float) -> Iterator[tuple[str, str, QPixmap]]:
    """Slug, title and picture of each example, one at a time since each takes a few milliseconds."""
    for example in examples():
        yield example.slug, example.title, _thumbnail(example, ratio)


def _thumbnail(example: Example, ratio: float) -> QPixmap:
    """The figures alone, in whole device pixels per cell; their colours suit both themes."""
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
