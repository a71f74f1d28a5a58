"""Selecting in Transform, where a drag becomes a link, and dragging points of a figure as it was drawn."""

from workbench.document.edits import move_points
from workbench.document.transforms.edits import extend
from workbench.document.transforms.links import Translate
from workbench.document.transforms.names import title
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.stage.gesture import Cell, HandleDrag, Modifiers, snapped
from workbench.panels.stage.tools import SelectTool
from workbench.panels.transform.told import place_text
from workbench.rendering.mapping import device_map
from workbench.session.session import Session


class ChainSelectTool(SelectTool):
    """Selects figures; what is dragged at once gets a translation at the end of its chain."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._from = (0.0, 0.0)

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Select what is under the pointer."""
        self._from = x, y
        super().press(x, y, modifiers, reach)

    def move(self, x: float, y: float) -> None:
        """Move the selection by its chain, or draw the band."""
        if not self.busy:
            super().move(x, y)
            return
        right, up = snapped(x - self._from[0], y - self._from[1])
        dx, dy = device_map(self.session.sheet).world_way(float(right), float(up))
        link = Translate("", tx=round(dx, 9), ty=round(dy, 9))
        self.show(
            extend(self.session.state.selection, link) if right or up else lambda document: document,
            title(link),
        )
        self.tag = _("moved by ({right}, {up})").format(right=displayed(dx), up=displayed(dy))


class PointDrag(HandleDrag):
    """Drags a point of the figure as it was drawn, to the nearest pixel: the chain is not asked."""

    def press(self, address: str) -> None:
        """Take hold of the point."""
        self.held = address
        self.begin()

    def drag(self, x: float, y: float) -> Cell:
        """Put it to the nearest pixel, which is returned."""
        cell = snapped(x, y)
        if self.busy:
            place = device_map(self.session.sheet).world_point(*cell)
            self.show(move_points({self.held: place}), _("Move point"))
            self.tag = place_text(*place)
        return cell
