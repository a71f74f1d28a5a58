"""Parallel against perspective: what the course says of the two, with the numbers of this scene."""

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel, QVBoxLayout, QWidget

from workbench.document.scene.looking import kind_of, kinds
from workbench.document.scene.model import Camera, Scene
from workbench.exchange.tables import Table
from workbench.geometry.meshes import Array
from workbench.language import _, reason_of
from workbench.rendering.scene.contrast import Contrast, Row, contrast
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.scrolled import scrolled
from workbench.widgets.look.tokens import CAPTION_PX
from workbench.widgets.look.type_faces import scaled
from workbench.widgets.tables.feature_table import FeatureTable

_PARALLEL, _PERSPECTIVE = 1, 2
_TELLING_ROW = 2


class ContrastDock(QWidget):
    """``looked`` sends a camera to see the scene by, ``marked`` the segments (n, 2, 3) that the chosen row
    was measured on."""

    looked = Signal(object)
    marked = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = FeatureTable(
            _("Parallel and perspective"),
            _("Choose a row to see in the scene what was measured; its cells switch between the projections"),
        )
        self.table.currentCellChanged.connect(self._choose)
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setContentsMargins(10, 6, 10, 8)
        self.note.setFrameShape(QFrame.Shape.NoFrame)
        self.note.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        inner = QWidget()
        column = QVBoxLayout(inner)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.table, 1)
        column.addWidget(scrolled(self.note))
        self.empty = EmptyView(inner, "")
        self.empty.button.hide()
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(self.empty)
        self.contrast: Contrast | None = None
        self._scene: Scene | None = None
        self._showing = False
        self.in_sight = InSight(self)
        self.in_sight.changed.connect(self._come_in_sight)

    # Showing

    def show_scene(self, scene: Scene) -> None:
        """Measure a scene as it is seen; unseen, when it is looked at."""
        self._scene = scene
        if self.in_sight.now:
            self._measure()

    def _come_in_sight(self, seen: bool) -> None:
        """Measure what was not measured meanwhile; out of sight nothing is marked in the scene."""
        if seen:
            self._measure()
        self._tell()

    def _measure(self) -> None:
        scene = self._scene
        if scene is None:
            return
        now, without = (
            None,
            _("No edge of the scene is in front of the camera, so there is nothing to measure."),
        )
        try:
            now = contrast(self._as_begun(scene))
        except ValueError as error:
            without = reason_of(error)
        self.empty.sentence.setText(without)
        self.empty.set_empty(now is None)
        before, self.contrast = self.contrast, now
        if now is not None and (before is None or _said(now) != _said(before)):
            self._fill(now)
        self._tell()

    def _as_begun(self, scene: Scene) -> Scene:
        """Seen by one of two cameras compared already, the scene is compared by the same two."""
        last = self.contrast
        if last is not None and scene.camera in (last.parallel, last.perspective):
            return replace(scene, camera=last.parallel)
        return scene

    def _fill(self, now: Contrast) -> None:
        self._showing = True
        rows = [(row.feature, row.parallel, row.perspective) for row in now.rows]
        headings = ("", _("Parallel"), _("Perspective"))
        self.table.show_rows(headings, rows, [row.but for row in now.rows])
        for column, camera in ((_PARALLEL, now.parallel), (_PERSPECTIVE, now.perspective)):
            if (heading := self.table.horizontalHeaderItem(column)) is not None:
                heading.setToolTip(title_of(camera))
        if self.table.currentRow() < 0:
            self.table.setCurrentCell(_TELLING_ROW, 0)
        self._showing = False

    # Choosing

    @property
    def chosen(self) -> Row | None:
        """The row that is chosen."""
        number = self.table.currentRow()
        now = self.contrast
        return now.rows[number] if now is not None and 0 <= number < len(now.rows) else None

    def _choose(self, row: int, column: int, *_before: int) -> None:
        now = self.contrast
        if now is None or self._showing:
            return
        if column in (_PARALLEL, _PERSPECTIVE):
            self.looked.emit(now.parallel if column == _PARALLEL else now.perspective)
        self._tell()

    def _tell(self) -> None:
        now, row = self.contrast, self.chosen
        segments: Array = np.zeros((0, 2, 3))
        if now is not None and row is not None:
            segments = row.segments
            titles = {kind.slug: kind.title for kind in kinds()}
            lengths = "; ".join(
                f"{titles[slug]} {', '.join(f'{unit:.3g}' for unit in units)}" for slug, units in now.kinds
            )
            also = _("A unit along x, y and z is as long as: {lengths}.").format(lengths=lengths)
            but = f"<b>{_('But:')}</b> {row.but}<br>" if row.but else ""
            self.note.setText(f"{but}<span style='font-size: {scaled(CAPTION_PX)}px'>{also}</span>")
        self.marked.emit(segments if self.in_sight.now else segments[:0])

    def content(self) -> list[tuple[str, Table]]:
        """Title and content of the table, for export."""
        if self.contrast is None:
            return []
        now = self.contrast
        columns = (_("feature"), *map(title_of, (now.parallel, now.perspective)), _("but"))
        rows = [(row.feature, row.parallel, row.perspective, row.but) for row in now.rows]
        return [(_("Parallel and perspective"), Table(columns, rows, formulas=False))]


def _said(now: Contrast) -> list[tuple[object, ...]]:
    """All that the table says."""
    return [(now.parallel, now.perspective), *(row[:-1] for row in now.rows)]


def title_of(camera: Camera) -> str:
    """What the projection of a camera is called."""
    try:
        slug = kind_of(camera)
    except ValueError:
        slug = camera.projection
    return next((kind.title for kind in kinds() if kind.slug == slug), slug)
