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
