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
            "gun",
            _("Gun"),
            _("The tube cut open: heater, grid, focus, acceleration, deflection, and the spot they make"),
            "workbench.panels.display.gun.page:GunPage",
        ),
    )
