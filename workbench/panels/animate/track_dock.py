"""What docks about the chosen track share: a title, a picture drawn by marks, fields, and its numbers."""

from collections.abc import Iterable

import numpy as np
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel, QPushButton, QScrollArea, QVBoxLayout, QWidget

from workbench.algorithms.marks import Points
from workbench.document.model import Sheet
from workbench.document.motion.model import Key, Track
from workbench.language import _
from workbench.rendering.subjects.track import Interval
from workbench.widgets.canvas.drawing import Drawn
from workbench.widgets.canvas.overlay import Handle
from workbench.widgets.canvas.plane import Box, Plane
from workbench.widgets.canvas.plane_view import PlaneView
from workbench.widgets.look.type_faces import keep_code_font

USUAL_PX = 118
_MARGIN = 0.06


class _Picture(PlaneView):
    """As large as the numbers below it leave room for."""

    def __init__(self) -> None:
        super().__init__()
        self._height = 0

    def set_height(self, height: int) -> None:
        """Be no lower than this."""
        if height != self._height:
            self._height = height
            self.setMinimumHeight(height)
            self.updateGeometry()

    def sizeHint(self) -> QSize:
        """No higher than it must be."""
        return QSize(220, self._height)


class TrackDock(QScrollArea):
    """One interval of the chosen track; ``key`` is the one that leads into it, None where there is none.

    ``example_wanted``: there is none, and a picture is asked for that has one.
    """

    example_wanted = Signal()

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.key: Key | None = None
        self.title = QLabel()
        self.title.setProperty("role", "title")
        self.title.setWordWrap(True)
        self.picture = _Picture()
        self.picture.setAccessibleName(name)
        self.fields = QVBoxLayout()
        self.fields.setSpacing(6)
        self.layout_below = QVBoxLayout()
        self.sums = QLabel()
        keep_code_font(self.sums, 12)
        self.sums.setWordWrap(True)
        self.sums.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.sums.setAccessibleName(name)
        self.note = QLabel()
        self.note.setProperty("role", "muted")
        self.note.setWordWrap(True)
        for label in (self.title, self.note):  # which have names of the user's
            label.setTextFormat(Qt.TextFormat.PlainText)
        self.example = QPushButton(_("Show an example"))
        self.example.setToolTip(_("Open a picture that already moves"))
        self.example.clicked.connect(lambda: self.example_wanted.emit())
        self.example.hide()
        inner = QWidget()
        self.setWidget(inner)
        self.setWidgetResizable(True)
        self.viewport().setAutoFillBackground(False)
        inner.setAutoFillBackground(False)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setMinimumSize(220, 180)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        column = QVBoxLayout(inner)
        column.setContentsMargins(12, 8, 12, 8)
        column.setSpacing(6)
        column.addWidget(self.title)
        column.addLayout(self.fields)
        column.addWidget(self.picture, 1)
        column.addWidget(self.sums)
        column.addWidget(self.note)
        column.addWidget(self.example, 0, Qt.AlignmentFlag.AlignLeft)
        column.addLayout(self.layout_below)
        column.addStretch(0)

    def sizeHint(self) -> QSize:
        """As high as all of it, where there is room."""
        return QSize(260, 360)

    def show_interval(
        self, sheet: Sheet, shown: Sheet, track: Track | None, around: Interval | None, frame: int
    ) -> None:
        """Show the keys ``around`` a frame of a track; without a track what to do."""
        raise NotImplementedError

    def show_nothing(self, title: str, note: str) -> None:
        """Say why there is nothing to see."""
        self.key = None
        self.title.setText(title)
        self.note.setText(note)
        for widget, there in (
            (self.picture, False),
            (self.sums, False),
            (self.note, True),
            (self.example, True),
        ):
            widget.setVisible(there)

    def show_drawn(
        self,
        title: str,
        drawn: Iterable[Drawn],
        box: Box,
        lines: Iterable[str] | str,
        note: str,
        handles: Iterable[Handle] = (),
        height: int = USUAL_PX,
    ) -> None:
        """Show a picture, so high at least, with ``box`` in it, and numbers, line by line or as rich text."""
        self.title.setText(title)
        self.picture.set_height(height)
        self.picture.set_plane(Plane(box, drawn=tuple(drawn), handles=tuple(handles), bare=True))
        self.sums.setText(lines if isinstance(lines, str) else "\n".join(lines))
        self.note.setText(note)
        self.example.hide()
        for widget, full in ((self.picture, True), (self.sums, self.sums.text()), (self.note, note)):
            widget.setVisible(bool(full))


def as_table(rows: Iterable[Iterable[str]]) -> str:
    """Rows of words as rich text, numbers under numbers."""
    lines = (
        "".join(f"<td align='{'right' if place else 'left'}'>{cell}</td>" for place, cell in enumerate(row))
        for row in rows
    )
    return "<table cellpadding='1'>" + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


def box_of(*outlines: Points) -> Box:
    """What holds outlines (n, 2), with a margin."""
    points = np.concatenate(outlines)
    low, high = points.min(axis=0), points.max(axis=0)
    room = max(float((high - low).max()), 1e-6) * _MARGIN
    (xmin, ymin), (xmax, ymax) = (low - room).tolist(), (high + room).tolist()
    return xmin, ymin, xmax, ymax
