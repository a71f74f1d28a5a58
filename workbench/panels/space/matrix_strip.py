"""The matrices below the picture: M = P V with live numbers, any of M to be changed."""

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QWidget

from workbench.algorithms.projection import vanishing_points
from workbench.document.scene.model import Camera
from workbench.document.scene.view_reference import view_reference
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.exchange.formulas.terms import Sign, Term, matrix
from workbench.geometry.meshes import Array
from workbench.language import _, reason_of
from workbench.panels.space.looking import Looking
from workbench.panels.space.object_handles import INKS
from workbench.widgets.formulas.matrix_row import MatrixRow
from workbench.widgets.formulas.row_surface import Highlight

_VIEW = (
    ("u_x", "u_y", "u_z", "-u·e"),
    ("v_x", "v_y", "v_z", "-v·e"),
    ("n_x", "n_y", "n_z", "-n·e"),
    ("0", "0", "0", "1"),
)
_PERSPECTIVE = (
    ("1", "0", "0", "0"),
    ("0", "1", "0", "0"),
    ("0", "0", "f/((f-n)d)", "-n f/((f-n)d)"),
    ("0", "0", "1/d", "0"),
)
# The same from the view reference point, z towards the eye.
_BOOK_VIEW = (
    ("u_x", "u_y", "u_z", "-u·VRP"),
    ("v_x", "v_y", "v_z", "-v·VRP"),
    ("n_x", "n_y", "n_z", "-n·VRP"),
    ("0", "0", "0", "1"),
)
_BOOK_PERSPECTIVE = (
    ("1", "0", "0", "0"),
    ("0", "1", "0", "0"),
    ("0", "0", "-f/((f-n)d)", "f(z_prp-n)/((f-n)d)"),
    ("0", "0", "-1/d", "z_prp/d"),
)
_ONE_LINE_PX = 150
_ROUNDING = 1e-14  # of the size of what was added up


class MatrixStrip(QWidget):
    """``said`` sends what is wrong with a number, or what is on the clipboard."""

    said = Signal(str)

    def __init__(self, looking: Looking, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._looking = looking
        self._camera: Camera | None = None
        self._z_towards_eye = False
        self._alone = False
        self.row = MatrixRow()
        self.row.set_shows("numbers")
        self.row.edited.connect(self._edit)
        self.row.edit_ended.connect(looking.session.end_merge)
        self.row.copied.connect(self.said)
        line = QHBoxLayout(self)
        line.setContentsMargins(4, 0, 4, 0)
        line.setSpacing(8)
        line.addWidget(self.row, 1)

    def show_camera(self, camera: Camera, anew: bool) -> None:
        """Show the matrices of a camera; ``anew`` they take no more room than their own numbers need."""
        self.row.belong_to(self._looking.session.sheet.id)
        if camera == self._camera and self._looking.z_towards_eye == self._z_towards_eye:
            return
        self._z_towards_eye = self._looking.z_towards_eye
        if anew:
            self._alone = False
            self.row.set_terms(())
        self._camera = camera
        self._show()

    def _show(self) -> None:
        camera = self._camera
        if camera is None:
            return
        try:
            view, plane = view_matrix(camera), projection_matrix(camera)
        except ValueError as error:
            self.said.emit(reason_of(error))
            return
        whole = plane @ view
        self.row.set_terms(self._terms(camera, whole, plane, view))
        if not self._alone and self.row.heightForWidth(self.row.width()) > _ONE_LINE_PX:
            self._alone = True  # for as long as this scene and this width are shown, so that nothing jumps
            self.row.set_terms(self._terms(camera, whole, plane, view))
        self.row.set_highlights(
            [Highlight(0, 3, axis, f"data{INKS[axis] + 1}") for axis in self._columns(whole)]
        )

    @staticmethod
    def _columns(whole: Array) -> list[int]:
        """The columns whose w is not 0: each is a vanishing point."""
        return [axis for axis, point in enumerate(vanishing_points(whole)) if point is not None]

    def _terms(self, camera: Camera, whole: Array, plane: Array, view: Array) -> list[Term]:
        central = camera.projection == "perspective"
        named_plane, named_view = _PERSPECTIVE, _VIEW
        if self._z_towards_eye:
            book = view_reference(camera)
            plane, view = book.projection, book.view
            named_plane, named_view = _BOOK_PERSPECTIVE, _BOOK_VIEW
        product = matrix(whole, name="M", editable=True)
        if self._alone:
            return [product]
        return [
            product,
            Sign("="),
            matrix(plane, named_plane if central else None, name="P"),
            Sign("·"),
            matrix(view, named_view, name="V"),
        ]

    def _edit(self, _term: int, row: int, column: int, value: float) -> None:
        """Another number of M: the projection becomes a matrix, that one which makes this M of the view."""
        camera = self._camera
        if camera is None:
            return
        view = view_matrix(camera)
        plane = projection_matrix(camera)
        whole = plane @ view
        # What rounding left of a 0 would keep a row of zeros from being one
        whole[np.abs(whole) <= _ROUNDING * (np.abs(plane) @ np.abs(view))] = 0.0
        whole[row, column] = value
        entries = tuple(map(float, (whole @ np.linalg.inv(view)).ravel()))
        changed = replace(camera, projection="matrix", entries=entries)
        if refusal := self._looking.change(changed, _("Change the matrix"), "matrix"):
            self.said.emit(refusal)
            self._show()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """M stands alone where all three have no room in one line."""
        super().resizeEvent(event)
        self._alone = False
        self._show()
