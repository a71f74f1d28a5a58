"""The answers of a page that has nothing more to offer."""

from collections.abc import Sequence

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.panels.panel import Cell, DockPart, Said


class PlainPage:
    """Goes before the widget among the bases of a page: no docks, no commands, nothing said or exported.

    What is stepped is the active figure, and an example is the house.
    """

    usual = Subject()
    example = "house"

    @property
    def widget(self) -> QWidget:
        """Itself."""
        assert isinstance(self, QWidget), "it goes before a widget"
        return self

    def docks(self) -> Sequence[DockPart]:
        """None."""
        return ()

    def commands(self) -> Sequence[QAction]:
        """None."""
        return ()

    def said(self) -> Said:
        """Nothing."""
        return Said()

    def tables(self) -> Sequence[tuple[str, Table]]:
        """None."""
        return ()

    def copy(self) -> bool:
        """Nothing."""
        return False

    def paste(self) -> bool:
        """Nothing."""
        return False

    def derivation(self) -> Derivation | None:
        """None."""
        return None

    def drawing(self) -> Derivation | None:
        """None."""
        return None

    def offer_export(self, menu: QMenu) -> None:
        """It has no menu of its own."""

    def point_at(self, cell: Cell | None) -> None:
        """There is nothing to show it on."""
