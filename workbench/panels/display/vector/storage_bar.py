"""What can be done with a storage tube: write, write through, erase all; a part cannot be erased."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from workbench.display.storage_tube import ERASE_S
from workbench.language import _
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.tube.storage_view import StorageView


class StorageBar(QWidget):
    """Its buttons work on ``view``. With Calm on, erasing asks first, since the whole face flashes."""

    said = Signal(str)

    def __init__(self, view: StorageView, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._view = view
        self.write = QPushButton(_("Write"))
        self.write.setToolTip(_("Draw the whole list once; the tube keeps it"))
        self.through = QCheckBox(_("Write through"))
        self.through.setToolTip(
            _("Show the list by a beam too weak to store it: it is gone as soon as it is no longer drawn")
        )
        self.erase = QPushButton(_("Erase all"))
        erasing = _("Erase the whole face; a real tube flashes meanwhile, for {s:g} s")
        self.erase.setToolTip(erasing.format(s=ERASE_S))
        self.part = QPushButton(_("Erase a stroke"))
        self.part.setToolTip(_("Try to erase the chosen stroke alone"))
        self.flash, self.dark = QPushButton(_("With the flash")), QPushButton(_("Without it"))
        self.flash.setToolTip(_("Erase as a real tube does: the whole face becomes bright at once"))
        self.dark.setToolTip(_("Erase without the bright face; all else is the same"))
        self.warning = QLabel(_("The whole face will flash once, brightly."))
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setProperty("role", "muted")
        self.note.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        buttons = QWidget()
        row = flowing(buttons, across=6, down=2)
        for part in (self.write, self.through, self.erase, self.part, self.warning, self.flash, self.dark):
            part.setAccessibleName(part.text())
            row.addWidget(part)
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 0, 4, 0)
        column.setSpacing(2)
        column.addWidget(self.note)
        column.addWidget(buttons)  # below the note, so that they stay where they are when it is longer
        self.write.clicked.connect(self._write)
        self.through.toggled.connect(view.set_write_through)
        self.erase.clicked.connect(self._ask)
        self.part.clicked.connect(self.refuse_part)
        self.flash.clicked.connect(lambda: self._erase(True))
        self.dark.clicked.connect(lambda: self._erase(False))
        view.changed.connect(self.refresh)
        self._warn(False)
        self.refresh()

    def _warn(self, on: bool) -> None:
        for part in (self.warning, self.flash, self.dark):
            part.setVisible(on)
        for part in (self.write, self.erase, self.part):
            part.setVisible(not on)

    def _ask(self) -> None:
        if comfort.calm:
            self._warn(True)
            self.dark.setFocus()
        else:
            self._erase(True)

    def _erase(self, flashes: bool) -> None:
        self._warn(False)
        self._view.erase(flashes)

    def _write(self) -> None:
        stored = self._view.write()
        said = _("{n:,} more pixels of the face are stored.")
        self.said.emit(said.format(n=stored))

    def refuse_part(self) -> None:
        """A stroke cannot be erased alone: say so."""
        self.note.setText(
            _(
                "A storage tube cannot erase one stroke: the flood guns keep all that is written. Erase all, "
                "then write the list without it."
            )
        )

    def refresh(self) -> None:
        """Say how the face and the list agree."""
        view = self._view
        for part in (self.write, self.erase, self.through):
            part.setEnabled(not view.erasing)
        if view.erasing:
            said = _("All of it is being erased: {s:g} s, in which nothing can be written.").format(s=ERASE_S)
        elif view.differs:
            said = _(
                "The list has changed, but what was written stays: a storage tube cannot erase a part. "
                "Erase all, then write anew."
            )
        elif view.lacks:
            said = _("The list has strokes that are not written yet.")
        else:
            said = _(
                "Written once and kept for minutes: no refresh, no flicker, however long the list is. "
                "One brightness, no motion, and no erasing of a part."
            )
        self.note.setText(said)
