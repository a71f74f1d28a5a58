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
        PageRow(
            "raster",
            _("Raster"),
            _("From the frame buffer to the beam, line by line: modes, timing, colour table, exam sums"),
            "workbench.panels.display.raster.page:RasterPage",
        ),
        PageRow(
            "vector",
            _("Random scan"),
            _("A display list, run instruction by instruction, and how many lines it takes to flicker"),
            "workbench.panels.display.vector.page:VectorPage",
        ),
        PageRow(
            "comparison",
            _("Raster or random"),
            _("One picture on both kinds of display: stairs, areas, memory, and time"),
            "workbench.panels.display.comparison.page:ComparisonPage",
        ),
        PageRow(
            "flicker",
            _("Flicker"),
            _("Refresh rate against phosphor: flickers, steady or smears, in numbers and on the tube"),
            "workbench.panels.display.flicker.page:FlickerPage",
        ),
        PageRow(
            "colour",
            _("Colour"),
            _("Colour models, the mask of a colour tube close up, and colour by accelerating voltage"),
            "workbench.panels.display.colour.page:ColourPage",
        ),
    )
