"""What the window asks of a panel, and the answers of one that has nothing more to offer."""

from collections.abc import Callable, Collection, Generator, Sequence
from typing import TYPE_CHECKING, NamedTuple, Protocol, cast

from PySide6.QtCore import QEvent, QObject, Qt, SignalInstance
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QVBoxLayout, QWidget

from workbench.exchange.tables import Table

if TYPE_CHECKING:
    from workbench.exchange.diagrams import Derivation
    from workbench.panels.stage.export import Exporter
    from workbench.session.session import Session
    from workbench.widgets.stepping.step_bar import Steps

# The name by which a dock is remembered, its title, what it holds, and where it begins.
DockPart = tuple[str, str, QWidget, str | Qt.DockWidgetArea]
Cell = tuple[int, int]


class Said(NamedTuple):
    """Signals of a text for the status bar: what is under the pointer or said in passing, and the zoom."""

    hover: SignalInstance | None = None
    zoom: SignalInstance | None = None


class Panel(Protocol):
    """A part of a workspace over one session. The first of a workspace fills its middle with ``center``.

    A panel takes the session as its only argument, and never another panel.
    """

    @classmethod
    def making(cls, session: "Session") -> "Generator[None, None, Panel]":
        """Make it, so much in each step as does not hold the interface, and return it."""

    @property
    def center(self) -> QWidget:
        """What fills the middle of a workspace whose first panel this is."""

    def docks(self) -> Sequence[DockPart]:
        """Its docks, in order."""

    def actions(self) -> Sequence[QAction]:
        """Its commands, for the window and for who looks for a command."""

    @property
    def step_bar(self) -> "Steps | None":
        """What stands below every workspace with steps, if it has that."""

    @property
    def stepping(self) -> SignalInstance | None:
        """Sends whether the buttons that step are wanted; None where they always are."""

    def said(self) -> Said:
        """What it says in the status bar."""

    @property
    def pointing(self) -> SignalInstance | None:
        """Sends a pixel that is pointed at elsewhere than on a canvas, None when no longer."""

    def point_at(self, cell: Cell | None) -> None:
        """Show in the middle where such a pixel is."""

    @property
    def example_wanted(self) -> SignalInstance | None:
        """Sent when one of its docks, with nothing to show, is asked for an example."""

    def show_example(self) -> None:
        """Open an example of what the workspace is about; asked of the panel in the middle."""

    def show_page(self, slug: str = "") -> None:
        """Show one of its pages, where it has several; an empty slug means the first."""

    @property
    def exporter(self) -> "Exporter | None":
        """What makes pages of its steps, if it shows any."""

    def tables(self) -> Sequence[tuple[str, Table]]:
        """Title and content of each table of its own that can be exported now."""

    def points(self) -> Sequence[tuple[float, float]]:
        """The points (world) of the curve that is worked on, if any."""

    def derivation(self) -> "Derivation | None":
        """The page that derives what is shown, if there is any."""

    def drawing(self) -> "Derivation | None":
        """The drawing alone of what the workspace explains, if it has one, with labels where they are on."""

    def offer_export(self, menu: QMenu) -> None:
        """Let its own menus lead to what can be exported."""

    def transforming(self) -> Sequence[QAction]:
        """Those of its commands that transform what is selected."""

    def copy(self) -> bool:
        """Put what is selected, or else the picture, on the clipboard; whether it has anything to copy."""

    def paste(self) -> bool:
        """Take what is on the clipboard; whether anything can be pasted into it."""


class SwapPlace(QWidget):
    """The part of a panel's middle that the tube takes when both are exchanged; without one it takes all."""

    def __init__(self, content: QWidget) -> None:
        super().__init__()
        self.content = content
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(content)


class KeysWhileSeen(QObject):
    """Enables ``actions`` while ``part`` is seen: several panels have a command on the same key, and only the
    one that is seen may take it.
    """

    def __init__(self, part: QWidget, actions: Collection[QAction]) -> None:
        super().__init__(part)
        self._actions = actions
        self._enable(part.isVisible())
        part.installEventFilter(self)

    def eventFilter(self, part: QObject, event: QEvent) -> bool:
        """Before the part itself is told, which then knows better of some of them."""
        if event.type() in (QEvent.Type.Show, QEvent.Type.Hide):
            self._enable(event.type() == QEvent.Type.Show)
        return False

    def _enable(self, on: bool) -> None:
        for action in self._actions:
            action.setEnabled(on)


class PlainPanel:
    """Goes before the widget among the bases of a panel: no docks, no commands, nothing said."""

    @classmethod
    def making(cls, session: "Session") -> "Generator[None, None, Panel]":
        """In one step."""
        yield from ()
        return cast("Callable[[Session], Panel]", cls)(session)

    def docks(self) -> Sequence[DockPart]:
        """None."""
        return ()

    def actions(self) -> list[QAction]:
        """None."""
        return []

    @property
    def step_bar(self) -> "Steps | None":
        """None."""
        return None

    @property
    def stepping(self) -> SignalInstance | None:
        """None."""
        return None

    def said(self) -> Said:
        """Nothing."""
        return Said()

    @property
    def pointing(self) -> SignalInstance | None:
        """Nothing."""
        return None

    def point_at(self, cell: Cell | None) -> None:
        """There is nothing to show it on."""

    @property
    def example_wanted(self) -> SignalInstance | None:
        """Nothing."""
        return None

    def show_example(self) -> None:
        """It has none."""

    def show_page(self, slug: str = "") -> None:
        """There is but one."""

    exporter: "Exporter | None" = None

    def tables(self) -> Sequence[tuple[str, Table]]:
        """None."""
        return ()

    def points(self) -> Sequence[tuple[float, float]]:
        """None."""
        return ()

    def derivation(self) -> "Derivation | None":
        """None."""
        return None

    def drawing(self) -> "Derivation | None":
        """None."""
        return None

    def offer_export(self, menu: QMenu) -> None:
        """It has no menu of its own."""

    def transforming(self) -> Sequence[QAction]:
        """None."""
        return ()

    def copy(self) -> bool:
        """Nothing."""
        return False

    def paste(self) -> bool:
        """Nothing."""
        return False
