"""The family of projections as a tree: which is a kind of which; the present one is marked."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QTreeWidget, QTreeWidgetItem, QWidget

from workbench.algorithms.numerals import with_minus
from workbench.algorithms.projection import classify
from workbench.document.scene.looking import kinds
from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.language import _, reason_of
from workbench.panels.space.camera_card import families
from workbench.widgets.look.scrolled import scrolled
from workbench.widgets.look.split import Split

_SLUG = Qt.ItemDataRole.UserRole


def _meanings() -> dict[str, str]:
    return {
        "parallel": _("The projectors are parallel: their centre is at infinity"),
        "orthographic": _("The projectors are perpendicular to the view plane"),
        "axonometric": _("Orthographic, with three sides seen at once"),
        "oblique": _("The projectors meet the view plane at an angle"),
        "perspective": _("All projectors meet at the eye, the centre of projection"),
        "general": _("Any matrix with a picture"),
    }


class FamilyTree(QTreeWidget):
    """``chosen`` sends the slug of the projection that was clicked, or entered by the keyboard."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setHeaderHidden(True)
        self.setAccessibleName(_("Family of projections"))
        self._rows: dict[str, QTreeWidgetItem] = {}
        parallel = self._branch(None, "parallel", _("Parallel"))
        parents: dict[str, QTreeWidgetItem] = {}
        for family, title in families().items():
            inside = None if family in ("perspective", "general") else parallel
            parents[family] = self._branch(inside, family, title)
        for kind in kinds():
            row = self._branch(parents[kind.family], "", kind.title)
            row.setData(0, _SLUG, kind.slug)
            self._rows[kind.slug] = row
        self.expandAll()
        self.itemClicked.connect(self._choose)
        self.itemActivated.connect(self._choose)

    def _branch(self, parent: QTreeWidgetItem | None, meaning: str, title: str) -> QTreeWidgetItem:
        row = QTreeWidgetItem([title])
        row.setToolTip(0, _meanings().get(meaning, title))
        if parent is None:
            self.addTopLevelItem(row)
        else:
            parent.addChild(row)
        return row

    def _choose(self, row: QTreeWidgetItem) -> None:
        if slug := row.data(0, _SLUG):
            self.chosen.emit(slug)

    def show_kind(self, slug: str) -> None:
        """Mark the present projection."""
        if slug in self._rows and self.currentItem() is not self._rows[slug]:
            self.setCurrentItem(self._rows[slug])


class FamilyDock(Split):
    """The tree, and under it what kind of projection the scene is seen by, read off its matrix, in words."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Vertical, parent)
        self.tree = FamilyTree()
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.words.setContentsMargins(10, 6, 10, 6)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.addWidget(self.tree)
        self.addWidget(scrolled(self.words))

    def show_camera(self, camera: Camera, slug: str) -> None:
        """Mark the projection of a camera, and say what its matrix tells."""
        self.tree.show_kind(slug)
        try:
            view = view_matrix(camera)
            words = classify(projection_matrix(camera) @ view, view).words
        except ValueError as error:
            words = reason_of(error)
        self.words.setText(with_minus(words))
