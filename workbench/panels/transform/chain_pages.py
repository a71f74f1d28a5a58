"""The dock of the chain: that of the figure in the plane, or that of the object in space, and the switch."""

from functools import partial

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QPushButton, QStackedWidget, QVBoxLayout, QWidget

from workbench.language import _
from workbench.panels.stage.workspace_page import PageRow
from workbench.panels.transform.ground import Ground

PLANE, SPACE = "plane", "space"


def pages() -> tuple[PageRow, ...]:
    """In the order of the switch."""
    return (
        PageRow(PLANE, _("In the plane"), _("Figures, with matrices of 3 × 3")),
        PageRow(
            SPACE,
            _("In space"),
            _("Objects, with matrices of 4 × 4: rotation about any axis in seven steps"),
        ),
    )


class ChainPages(Ground):
    """``chosen`` sends the page that a button of the switch asks for."""

    chosen = Signal(str)

    def __init__(self, plane: QWidget, space: QWidget) -> None:
        super().__init__()
        self.stack = QStackedWidget()
        self.buttons: dict[str, QPushButton] = {}
        group = QButtonGroup(self)
        row = QHBoxLayout()
        row.setContentsMargins(12, 6, 12, 0)
        row.setSpacing(0)
        for number, (page, part) in enumerate(zip(pages(), (plane, space), strict=True), 1):
            button = self.buttons[page.slug] = QPushButton(page.title)
            button.setCheckable(True)
            button.setProperty("low", True)
            button.setToolTip(f"{page.tooltip} (Alt+{number})")
            button.clicked.connect(partial(self._choose, page.slug))
            group.addButton(button)
            row.addWidget(button)
            self.stack.addWidget(part)
        row.addStretch(1)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addLayout(row)
        whole.addWidget(self.stack, 1)
        self.show_page(PLANE)

    def _choose(self, slug: str, *_checked: object) -> None:
        self.chosen.emit(slug)

    def show_page(self, slug: str) -> None:
        """Show one of both."""
        self.stack.setCurrentIndex([*self.buttons].index(slug))
        self.buttons[slug].setChecked(True)
