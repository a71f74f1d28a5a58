"""Icons of one family (Phosphor), coloured by the tokens. The icon font is loaded with the first icon asked for,
so ask after the first frame.
"""

from PySide6.QtCore import QObject
from PySide6.QtGui import QIcon

from workbench.widgets.tokens import theme, tokens

_made: dict[tuple[str, str, str, str], QIcon] = {}


def icon(name: str, role: str = "text") -> QIcon:
    """The icon ``name`` ("play", "skip-back", ...) in the colour of the token ``role``, muted when disabled.

    Raises LookupError for a name that the family does not have.
    """
    now = tokens()
    key = (name, getattr(now, role), now.muted, now.accent)
    if key not in _made:
        import qtawesome  # the font takes 0.1 s to load: not before the first frame

        try:
            _made[key] = qtawesome.icon(
                f"ph.{name}", color=key[1], color_disabled=now.field_edge, color_on=now.accent
            )
        except Exception as error:
            raise LookupError(f"The icon family has no icon named {name}.") from error
    return _made[key]


class ThemedIcon(QObject):
    """Keeps the icon of ``owner`` (a button or an action) in the colours of the theme in use."""

    def __init__(self, owner: QObject, name: str, role: str = "text") -> None:
        super().__init__(owner)
        self._owner, self._name, self._role = owner, name, role
        theme.changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Set the icon anew."""
        self._owner.setIcon(icon(self._name, self._role))  # type: ignore[attr-defined]


def set_icon(owner: QObject, name: str, role: str = "text") -> None:
    """Give a button or an action an icon that follows the theme."""
    for earlier in owner.findChildren(ThemedIcon):
        earlier.deleteLater()
    ThemedIcon(owner, name, role)
