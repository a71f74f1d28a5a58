"""Help: how to begin, and all keys in one table."""

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QPushButton

from workbench.language import _
from workbench.shell.actions import commands, key_text, keys_elsewhere, menu_titles
from workbench.shell.pages import SidePage, heading, paragraph

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


_GAP_PX = 8


def _sections() -> tuple[tuple[tuple[str, ...], str, str], ...]:
    """The workspaces that a section is about, its title and its words."""
    return (
        (
            ("draw",),
            _("Draw"),
            _(
                "Choose a tool on the left and drag on the canvas. Click a figure to select it: drag its "
                "handles, or type their coordinates in the card at the top left. Figures that you group "
                "with Ctrl+G stay together; Alt and a click picks one of them. The wheel zooms at the "
                "pointer."
            ),
        ),
        (
            (),
            _("Step"),
            _(
                "The bar below the canvas walks through the algorithm that made the picture: the keys . "
                "and , go forward and back everywhere. The two lines of words say what was decided "
                "and why."
            ),
        ),
        (
            (),
            _("Read"),
            _(
                "Source shows the algorithm itself with the current line marked, Variables what changed, "
                "and the hand table is the one you would write on paper. About tells what always holds "
                "of it, and leads to the next algorithm of its kind."
            ),
        ),
        (
            (),
            _("Guess"),
            _("With Ask first on, click the next pixel before it is shown; right and wrong are counted."),
        ),
        (
            ("fill", "clip"),
            _("Fill and clip"),
            _(
                "In Fill draw a polygon or set a seed, and watch the tables and the stack. In Clip drag "
                "the window. Press Y at any pixel to ask why it is as it is; Compare counts what two "
                "algorithms do with the same figures."
            ),
        ),
        (
            ("transform",),
            _("Transform"),
            _(
                "Drag a figure, or the handles of its box, and each drag becomes a link of its chain. The "
                "cards of the chain can be typed into, switched off and dragged into another order; their "
                "matrices stand below, the product at the left. The page In space does so with an object."
            ),
        ),
        (
            ("view",),
            _("View"),
            _(
                "At the left is the world, at the right the device. Drag the window or the viewport, or "
                "their sides, and see what becomes of the picture; send a point through, and its way is "
                "worked out number by number."
            ),
        ),
        (
            ("curves",),
            _("Shape curves"),
            _(
                "In Curves click point after point, then drag points, handles, knots, or the curve "
                "itself. Drag the ring to see how the construction finds a point, and show other "
                "kinds of curves over the same points."
            ),
        ),
        (
            ("space",),
            _("Space"),
            _(
                "Drag to look around, drag the eye in the view from outside, and choose a projection. On "
                "the page Visibility a method for hidden surfaces is stepped, and on Hidden surfaces all "
                "of them draw one scene side by side."
            ),
        ),
        (
            ("animate",),
            _("Animate"),
            _(
                "Turn auto-key on, go to another frame, and move a figure there: it has keys now, and the "
                "frames between them follow. Drag keys on the timeline or on the path, bend the easing, "
                "and step through one in-between."
            ),
        ),
        (
            ("display",),
            _("See it glow"),
            _(
                "Display shows the same picture on a raster tube and on a vector tube. Slow the beam "
                "down until you see it move."
            ),
        ),
        (
            (),
            _("Keep"),
            _(
                "Save keeps picture and step in one .gwb file. Drop such a file, an SVG or a list of "
                "points on the window to open it. Ctrl+K finds any command by a few letters."
            ),
        ),
    )


class HelpPage(SidePage):
    """The first ten minutes; it opens at what is about the workspace that one comes from."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window, _("Help"))
        self.about: dict[str, QLabel] = {}
        for slugs, title, text in _sections():
            label = heading(self.column, title)
            self.about |= dict.fromkeys(slugs, label)
            paragraph(self.column, text)
        row = QHBoxLayout()
        for name in ("hints", "keys", "about"):
            action = window.menus.actions[name]
            button = QPushButton(action.text())
            button.setToolTip(action.toolTip())
            button.clicked.connect(action.trigger)
            row.addWidget(button)
        row.addStretch(1)
        self.column.addSpacing(8)
        self.column.addLayout(row)
        self.column.addStretch(1)

    def showEvent(self, event: QShowEvent) -> None:
        """Begin with the workspace that one comes from."""
        super().showEvent(event)
        QTimer.singleShot(0, self, self._begin)

    def _begin(self) -> None:
        label, body = self.about.get(self._window.came_from), self.widget()
        for each in self.about.values():
            each.setProperty("here", each is label)
            each.style().polish(each)
        top = label.mapTo(body, label.rect().topLeft()).y() - _GAP_PX if label and body else 0
        self.verticalScrollBar().setValue(top)


class KeysPage(SidePage):
    """The key table, made from the table of commands."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window, _("Keys"))
        titles = {name: title.replace("&", "") for name, title in menu_titles()}
        groups: dict[str, list[tuple[str, str]]] = {}
        for command in commands():
            if command.keys:
                keys = "  ".join(key_text(key) for key in command.keys)
                groups.setdefault(titles[command.menu], []).append((keys, command.tooltip))
        for part, keys, text in keys_elsewhere():
            groups.setdefault(part, []).append((keys, text))
        for part, rows in groups.items():
            heading(self.column, part)
            grid = QGridLayout()
            grid.setHorizontalSpacing(16)
            grid.setVerticalSpacing(4)
            grid.setColumnMinimumWidth(0, 200)
            grid.setColumnStretch(1, 1)
            for place, (keys, text) in enumerate(rows):
                for column, words in enumerate((keys, text)):
                    label = QLabel(words)
                    label.setTextFormat(Qt.TextFormat.PlainText)
                    label.setWordWrap(column == 1)
                    label.setAlignment(Qt.AlignmentFlag.AlignTop)
                    if column == 1:
                        label.setProperty("role", "muted")
                    grid.addWidget(label, place, column)
            self.column.addLayout(grid)
        self.column.addStretch(1)
