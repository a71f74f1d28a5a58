"""Icons of one family (Phosphor, regular weight), coloured by the tokens.

The icon font is loaded with the first icon asked for, so ask after the first frame.
"""

from functools import cache
from typing import Any

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QAction, QIcon, QPixmap

from workbench.widgets.look.tokens import theme, tokens

_made: dict[tuple[str, str, str, str], QIcon] = {}


@cache
def _font() -> Any:
    """The icon font. Only this one family of the many that QtAwesome brings, which keeps loading at 15 ms."""
    import qtawesome
    from qtawesome.iconic_font import CharIconEngine

    class Engine(CharIconEngine):  # type: ignore[misc]
        def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
            """None for a button that a low window leaves no room, where the family would paint on nothing."""
            return QPixmap() if size.isEmpty() else super().pixmap(size, mode, state)

    class Font(qtawesome.IconicFont):  # type: ignore[misc]
        def _icon_by_painter(self, painter: Any, options: Any) -> QIcon:
            return QIcon(Engine(self, painter, options))

    return Font(next(font for font in qtawesome._BUNDLED_FONTS if font[0] == "ph"))


def icon(name: str, role: str = "text") -> QIcon:
    """The icon ``name`` ("play", "skip-back") in the colour of the token ``role``, fainter when disabled.

    Raises LookupError for a name that the family does not have.
    """
    now = tokens()
    key = (name, getattr(now, role), now.field_edge, now.accent)
    if key not in _made:
        if name not in _font().charmap["ph"]:
            raise LookupError(f"The icon family has no icon named {name}.")
        _made[key] = _font().icon(f"ph.{name}", color=key[1], color_disabled=key[2], color_on=key[3])
    return _made[key]


class _ThemedIcon(QObject):
    """Keeps the icon of its parent (a button or an action) in the colours of the theme in use."""

    def __init__(self, owner: Any, name: str, role: str) -> None:
        super().__init__(owner)
        self._owner = owner
        if isinstance(owner, QAction):
            owner.checkableChanged.connect(self._leave_room_for_tick)
            self._leave_room_for_tick(owner.isCheckable())
        self.show(name, role)
        theme.changed.connect(self.refresh)

    def show(self, name: str, role: str) -> None:
        """Set another icon."""
        self._name, self._role = name, role
        self.refresh()

    def _leave_room_for_tick(self, checkable: bool) -> None:
        """In a menu an icon would stand where the tick belongs."""
        self._owner.setIconVisibleInMenu(not checkable)

    def refresh(self) -> None:
        """Set the icon anew."""
        self._owner.setIcon(icon(self._name, self._role))


def set_icon(owner: Any, name: str, role: str = "text") -> None:
    """Give a button or an action (anything with ``setIcon``) an icon that follows the theme."""
    themed = owner.findChild(_ThemedIcon, options=Qt.FindChildOption.FindDirectChildrenOnly)
    if themed is None:
        _ThemedIcon(owner, name, role)
    else:
        themed.show(name, role)
