"""The box around the chosen points of a curve, or, with fewer than two chosen, around what is selected."""

from workbench.algorithms.transforms import Matrix
from workbench.document.model import Curve, Document
from workbench.document.transforms.edits import Applied, apply_to_points
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.shape import device_points
from workbench.panels.stage.boxing import Boxing
from workbench.panels.stage.gesture import Gesture
from workbench.panels.stage.outline import Curve as Line
from workbench.rendering.extents import extent_of_points
from workbench.rendering.mapping import Box as Extent
from workbench.widgets.canvas.pixel_canvas import PixelCanvas


class CurveBoxing(Boxing):
    """Chosen points are transformed with their tangents, and points of a path with their handles."""

    def __init__(self, focus: CurveFocus, canvas: PixelCanvas, gesture: Gesture) -> None:
        self.focus = focus
        super().__init__(focus.session, canvas, gesture, whole_moves=False)

    def _curve(self) -> Curve | None:
        """The selected curve, where at least two of its points are chosen."""
        curve = self.focus.selected
        return curve if curve is not None and len(self.focus.numbers(curve)) > 1 else None

    def boxed(self) -> tuple[str, ...]:
        """The ids of the points, or of the figures."""
        curve = self._curve()
        if curve is None:
            return super().boxed()
        return tuple(curve.points_world[k].id for k in self.focus.numbers(curve))

    def extent(self) -> Extent | None:
        """How far the points, or the figures, reach."""
        curve = self._curve()
        if curve is None:
            return super().extent()
        return extent_of_points(device_points(self.session.sheet, curve)[self.focus.numbers(curve)])

    def outlines(self) -> list[Line]:
        """The chosen points joined in their order, and the curve itself when it is all of them."""
        curve = self._curve()
        if curve is None:
            return super().outlines()
        numbers = self.focus.numbers(curve)
        whole = super().outlines() if len(numbers) == len(curve.points_world) else []
        return [device_points(self.session.sheet, curve)[numbers], *whole]

    def transformed(self, document: Document, matrix: Matrix) -> Applied:
        """The points, or the figures, under a matrix. Raises: DocumentError."""
        curve = self._curve()
        if curve is None:
            return super().transformed(document, matrix)
        place = f"{self.session.sheet.id}/{curve.id}"
        return Applied(
            apply_to_points([f"{place}/{point}/x" for point in self.boxed()], matrix)(document), ()
        )
