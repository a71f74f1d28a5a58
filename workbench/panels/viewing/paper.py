"""The two open pictures of View on paper: labelled, in the light theme, over the sentence of a step."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QFont, QImage, QPainter

from workbench.panels.viewing.stages import Geometry, plane_of, world_box
from workbench.rendering.subjects.window import parted, view_of
from workbench.session.run import Run
from workbench.session.session import Session
from workbench.widgets.canvas.plane import Plane, paint_plane, scene_of
from workbench.widgets.canvas.view import Area
from workbench.widgets.look.tokens import LIGHT

if TYPE_CHECKING:
    from workbench.panels.viewing.panel import ViewingPanel

_HEADING_PX, _GAP_PX, _TITLE_PX = 26, 12, 13


@dataclass(frozen=True, slots=True, eq=False)
class PlanesPage:
    """Planes side by side, each under its title."""

    planes: tuple[tuple[str, Plane], ...]
    caption: str

    def paint(self, painter: QPainter, size: tuple[int, int], font: QFont, unit: float, vector: bool) -> None:
        """One beside the other, as large as one another."""
        gap, above = round(_GAP_PX * unit), round(_HEADING_PX * unit)
        wide = (size[0] - gap * (len(self.planes) + 1)) // len(self.planes)
        bold = QFont(font)
        bold.setBold(True)
        bold.setPixelSize(round(_TITLE_PX * unit))
        for number, (title, plane) in enumerate(self.planes):
            left = gap + number * (wide + gap)
            painter.setFont(bold)
            painter.setPen(QColor(LIGHT.text))
            painter.drawText(QRectF(left, 0, wide, above), Qt.AlignmentFlag.AlignVCenter, title)
            scene = replace(
                scene_of(plane, Area(left, above, left + wide, size[1]), LIGHT, unit, font, small=False),
                vector=vector,
            )
            paint_plane(painter, plane, scene, small=False)


class ViewOnPaper:
    """Gives the pictures that are open in a panel, at its steps."""

    def __init__(self, panel: "ViewingPanel") -> None:
        self._panel = panel
        self.session: Session = panel.session

    def stepped_run(self) -> Run | None:
        """The run of the points that are sent through."""
        run = self.session.run
        return run if run.subject == self.session.subject else None

    def page(self, number: int | None, caption: str) -> PlanesPage:
        """Both pictures now, or at one step of the run."""
        sheet = self.session.sheet
        view = view_of(sheet, self.session.subject)
        geometry = Geometry(sheet, view, world_box(sheet, view), LIGHT)
        run = self.stepped_run()
        marks = self._panel.marks() if number is None or run is None else tuple(run.marks(number))
        world, device = parted(marks)
        shown = {"world": world, "device": device, "normalised": ()}
        planes = []
        for picture in (self._panel.left, self._panel.right):
            stage = picture.stage
            plane = plane_of(stage, geometry, shown[stage.frame] if stage.rectangle else ())
            planes.append((stage.heading, replace(plane, handles=())))
        return PlanesPage(tuple(planes), caption)

    def grab_picture(self) -> QImage:
        """All that the panel shows, as it is seen."""
        return self._panel.grab().toImage()
