"""The pages of Display."""

from workbench.language import _
from workbench.panels.stage.workspace_page import PageRow


def pages() -> tuple[PageRow, ...]:
    """In the order of the switch."""
    return (
        PageRow(
            "display",
            _("Tubes"),
            _("The picture on a raster tube and on a vector tube, side by side, with instruments"),
            "workbench.panels.display.tubes_page:TubesPage",
        ),
        PageRow(
            "raster",
            _("Raster"),
            _("From the frame buffer to the beam, line by line: modes, timing, colour table, exam sums"),
            "workbench.panels.display.raster.page:RasterPage",
        ),
    )
