"""The colours of the program, by what they are for. A widget that paints itself reads ``tokens()`` in its
``paintEvent`` and repaints on ``theme.changed``; only the shell changes the theme.
"""

from typing import NamedTuple

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor


class Tokens(NamedTuple):
    """One theme. Every colour is a ``#RRGGBB`` text; ``colour`` makes it a QColor.

    ``data`` are six colours for data, told apart also without colour vision: the first algorithm takes
    data[0], the second data[1]; a shape or pattern stands beside every colour. ``agreement`` is for what both
    share, ``selected`` lies behind selected rows.
    """

    name: str
    window: str
    surface: str
    raised: str
    line: str
    field_edge: str
    text: str
    muted: str
    accent: str
    on_accent: str
    selected: str
    warn: str
    error: str
    canvas: str
    grid: str
    grid_strong: str
    agreement: str
    data: tuple[str, str, str, str, str, str]

    @property
    def dark(self) -> bool:
        """Whether light words stand on a dark ground."""
        return self.name == "dark"


LIGHT = Tokens(
    name="light",
    window="#F4F5F7",
    surface="#FFFFFF",
    raised="#FFFFFF",
    line="#D9DDE3",
    field_edge="#808A99",
    text="#1B1F24",
    muted="#5B6470",
    accent="#0B6BCB",
    on_accent="#FFFFFF",
    selected="#E6F0FB",
    warn="#8A5C00",
    error="#B42318",
    canvas="#FFFFFF",
    grid="#E4E7EC",
    grid_strong="#BCC3CD",
    agreement="#7A838F",
    data=("#0072B2", "#D55E00", "#00805C", "#C2417C", "#A97400", "#1F86BF"),
)

DARK = Tokens(
    name="dark",
    window="#15181C",
    surface="#1D2126",
    raised="#262B31",
    line="#343A42",
    field_edge="#6B7684",
    text="#E8EBEF",
    muted="#9AA4B1",
    accent="#5AA9FF",
    on_accent="#15181C",
    selected="#1E3750",
    warn="#E3B341",
    error="#FF8A80",
    canvas="#101316",
    grid="#2A2F36",
    grid_strong="#4A525C",
    agreement="#8C96A3",
    data=("#56B4E9", "#FF8A4C", "#2CC295", "#CC79A7", "#E69F00", "#F0E442"),
)

SPACING = (4, 8, 12, 16, 24)
RADIUS = 6
TEXT_PX, CAPTION_PX, TITLE_PX = 13, 11, 15


class Theme(QObject):
    """The current tokens. ``changed`` is sent after another theme has taken effect."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.current = LIGHT

    def use(self, chosen: Tokens) -> None:
        """Make ``chosen`` the current tokens; called by the shell."""
        if chosen != self.current:
            self.current = chosen
            self.changed.emit()


theme = Theme()
theme_changed = theme.changed


def tokens() -> Tokens:
    """The tokens of the theme in use now."""
    return theme.current


def colour(value: str, alpha: int = 255) -> QColor:
    """A token as a QColor; ``alpha`` 0 to 255."""
    made = QColor(value)
    made.setAlpha(alpha)
    return made
