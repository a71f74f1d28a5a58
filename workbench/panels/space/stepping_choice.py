"""The choice over the outside view of what is stepped: a vertex on its way, or clipping to the volume."""

from PySide6.QtWidgets import QComboBox, QWidget

from workbench.algorithms import catalogue
from workbench.language import _
from workbench.rendering.subjects.projection import is_of_a_vertex
from workbench.session.session import Session


class SteppingChoice(QComboBox):
    """Shows what the session steps, and changes it."""

    def __init__(self, session: Session, parent: QWidget) -> None:
        super().__init__(parent)
        self._session = session
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.setAccessibleName(_("What is stepped"))
        self.setToolTip(
            _("Step a vertex on its way into the picture, or the clipping of its object to the view volume")
        )
        self.activated.connect(self._choose)

    def refresh(self) -> None:
        """Show the present choice; nothing where another page is stepped."""
        subject = self._session.subject
        here = is_of_a_vertex(subject) and self._session.sheet.scene is not None
        self.setVisible(here)
        if not here:
            return
        slugs = self._session.choices_of()
        if [self.itemData(k) for k in range(self.count())] != list(slugs):
            self.clear()
            for slug in slugs:
                self.addItem(_(catalogue.get(slug).title), slug)
        self.setCurrentIndex(max(self.findData(subject.entry), 0))
        self.ensurePolished()
        self.adjustSize()

    def _choose(self, index: int) -> None:
        self._session.choose(self.itemData(index))
