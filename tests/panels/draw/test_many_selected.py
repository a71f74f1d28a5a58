"""Of thousands of selected points no grips are shown, which would cover the picture; of few all are."""

import pytest
from msgspec.structs import replace

from workbench.document.model import Line, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.stage.compose import with_selection
from workbench.widgets.canvas.overlay import Overlay


@pytest.mark.parametrize(("count", "grips"), [(1000, 2000), (1001, 0)])
def test_grips_of_many_figures(count, grips):
    figures = [
        Line(f"f{k}", (WorldPoint(f"p{k}", 1.0, 1.0), WorldPoint(f"q{k}", 9.0, k % 50)), "bresenham_line")
        for k in range(count)
    ]
    sheet = replace(blank_sheet().sheets[0], figures=tuple(figures))
    overlay = with_selection(Overlay(), sheet, figures, "")
    assert len(overlay.handles) == grips
    assert len(overlay.outlined) >= count
