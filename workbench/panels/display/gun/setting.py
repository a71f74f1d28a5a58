"""The tube that a session's subject is set to, and how it is changed from every part of the page."""

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import QObject, Signal

from workbench.display.gun import OFF, Gun
from workbench.language import _
from workbench.rendering.subjects.gun import changed, gun_of, is_of_a_gun, with_settings
from workbench.session.session import Session

PAGE = "gun"


class Setting(QObject):
    """``gun`` is the tube; ``told``: it is another one.

    ``refused`` sends why a change was not taken, or "" once one is.
    """

    told = Signal()
    refused = Signal(str)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.gun = Gun()
        session.state_changed.connect(self.follow)

    @property
    def here(self) -> bool:
        """Whether the page is what is stepped now."""
        state = self._session.state
        return state.workspace == PAGE and is_of_a_gun(state.subject)

    def follow(self, *_states: object) -> None:
        """Take what the session has."""
        if self.here:
            gun = gun_of(self._session.state.subject)
            if gun != self.gun:
                self.gun = gun
                self.told.emit()

    def change(self, changes: Mapping[str, Any]) -> None:
        """Set what ``changes`` says, by the names of the arguments; what cannot be is refused in words."""
        gun = changed(self.gun, changes)
        fault = gun.fault()
        self.refused.emit(fault)
        if fault or gun == self.gun or not self.here:
            return
        self._session.update_state(subject=with_settings(self._session.state.subject, changes))
        self.follow()

    def steer(self, x: float | None, y: float | None) -> str:
        """Send the beam to a place of the face (mm), by holding what bends it; what is to be said of it."""
        _z, now_x, now_y, _r = self.gun.way()[-1]
        drive = self.gun.drive_to(now_x if x is None else x, now_y if y is None else y)
        name, decimals = ("field", 4) if self.gun.coils else ("volts", 1)
        changes: dict[str, Any] = {}
        held = False
        for way, value, drive_value in (("x", x, drive[0]), ("y", y, drive[1])):
            if value is not None or self.gun.coils:
                changes[f"{way}_{name}"] = round(drive_value, decimals)
                held = held or getattr(self.gun, way).wave != OFF
                changes[f"{way}_wave"] = OFF
        self.change(changes)
        return _("The input is off now: the spot stays where you put it.") if held else ""
