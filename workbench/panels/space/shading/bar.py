"""The bar of the Shading page: which shading, how fine a picture, which highlight, shadows, all four."""

from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QWidget,
)

from workbench.algorithms import catalogue
from workbench.document.subjects import Argument
from workbench.language import _
from workbench.panels.space.looking import Looking
from workbench.panels.stage.folding_card import fill_choices
from workbench.rendering.scene.shading import LIT_SHADINGS
from workbench.rendering.subjects.shading import model_of, shading_of
from workbench.rendering.subjects.visibility import scene_size, size_of
from workbench.session.session import Session
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.elided_label import ElidedLabel

COLUMNS = (16, 24, 36, 48, 64, 96)


class ShadingBar(QWidget):
    """Shows and sets what the session's subject is shaded by; ``together`` shows all four shadings."""

    def __init__(self, session: Session, looking: Looking, together: QAction) -> None:
        super().__init__()
        self._session = session
        self.method, self.size_box = QComboBox(), QComboBox()
        self.halfway, self.shadows = QCheckBox(_("N · H for V · R")), QCheckBox(_("Shadows"))
        self.keep = QPushButton(_("Keep this view"))
        self.together = ActionButton(together)
        self.progress = ElidedLabel()
        self.progress.setProperty("role", "muted")
        for widget, name, tip in (
            (self.method, _("Shading"), _("How light or normals are spread over the faces")),
            (self.size_box, _("Size of the picture"), _("How many pixels the picture that is stepped has")),
            (
                self.halfway,
                _("Halfway vector"),
                _("Highlights by the direction halfway between L and V"),
            ),
            (self.shadows, _("Shadows"), _("Cast a ray to each light from every point that is lit")),
            (
                self.keep,
                _("Keep this view"),
                _("Step the scene as it is seen now: write this camera into the document"),
            ),
            (self.together, _("Four shadings side by side"), _("Four shadings side by side (Shift+4)")),
        ):
            widget.setAccessibleName(name)
            widget.setToolTip(tip)
        for box in (self.method, self.size_box):
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 2, 8, 4)
        row.setSpacing(10)
        for part in (self.method, self.size_box, self.halfway, self.shadows, self.together, self.keep):
            row.addWidget(part)
        self.progress.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.progress.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        row.addWidget(self.progress, 1)
        self.method.activated.connect(lambda k: session.choose(self.method.itemData(k)))
        self.size_box.activated.connect(lambda k: self._give("columns", self.size_box.itemData(k)))
        self.halfway.clicked.connect(lambda on: self._give("by_halfway", on))
        self.shadows.clicked.connect(lambda on: self._give("shadows", on))
        self.keep.clicked.connect(lambda: looking.keep())

    def refresh(self, around: bool) -> None:
        """Show what is set; ``around``: the scene is seen otherwise than it is stepped."""
        session, subject = self._session, self._session.state.subject
        self.setEnabled(session.sheet.scene is not None)
        titles = [(slug, _(catalogue.get(slug).title)) for slug in LIT_SHADINGS]
        fill_choices(self.method, titles, shading_of(subject))
        columns = scene_size(session.sheet, subject)[0]
        sizes = [size_of(session.sheet, each) for each in sorted({*COLUMNS, columns})]
        fill_choices(self.size_box, [(w, f"{w} × {h} px") for w, h in sizes], columns)
        model = model_of(subject)
        self.halfway.setChecked(model.by_halfway)
        self.shadows.setChecked(model.shadows)
        self.keep.setVisible(around)

    def _give(self, name: str, value: Argument) -> None:
        session = self._session
        subject = session.state.subject
        session.update_state(subject=replace(subject, arguments={**subject.arguments, name: value}), step=0)
