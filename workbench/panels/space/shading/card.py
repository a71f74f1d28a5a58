"""The card of the Shading page: which shading, how fine a picture, which highlight, shadows."""

from msgspec.structs import replace
from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QWidget

from workbench.algorithms import catalogue
from workbench.document.subjects import Argument
from workbench.language import _
from workbench.panels.stage.folding_card import FoldingCard, fill_choices
from workbench.rendering.scene.shading import LIT_SHADINGS
from workbench.rendering.subjects.shading import model_of, shading_of
from workbench.rendering.subjects.visibility import scene_size, size_of
from workbench.session.session import Session

WIDTH_PX = 196
COLUMNS = (16, 24, 36, 48, 64, 96)


class ShadingCard(FoldingCard):
    """Shows and sets what the session's subject is shaded by."""

    def __init__(self, session: Session, canvas: QWidget) -> None:
        super().__init__(canvas, WIDTH_PX)
        self._session = session
        self.title.setText(_("Shading"))
        self.method, self.size_box = QComboBox(), QComboBox()
        for box, name, tip in (
            (self.method, _("Shading"), _("How light or normals are spread over the faces")),
            (self.size_box, _("Size of the picture"), _("How many pixels the stepped picture has")),
        ):
            box.setAccessibleName(name)
            box.setToolTip(tip)
            self.body.addWidget(box)
        self.method.activated.connect(lambda k: session.choose(self.method.itemData(k)))
        self.size_box.activated.connect(lambda k: self._give("columns", self.size_box.itemData(k)))
        self.halfway = QCheckBox(_("N · H for V · R"))
        self.halfway.setToolTip(_("Find the highlight by the vector halfway between light and eye"))
        self.halfway.clicked.connect(lambda on: self._give("by_halfway", on))
        self.shadows = QCheckBox(_("Shadows"))
        self.shadows.setToolTip(_("Cast a ray to each light from every place that is lit"))
        self.shadows.clicked.connect(lambda on: self._give("shadows", on))
        self.legend = QLabel()
        self.legend.setWordWrap(True)
        self.legend.setProperty("role", "muted")
        for widget in (self.halfway, self.shadows, self.legend):
            self.body.addWidget(widget)

    def refresh(self, legend: str) -> None:
        """Show what is set, and a sentence about it."""
        session = self._session
        self.setVisible(session.sheet.scene is not None)
        if session.sheet.scene is None:
            return
        subject = session.state.subject
        titles = [(slug, _(catalogue.get(slug).title)) for slug in LIT_SHADINGS]
        fill_choices(self.method, titles, shading_of(subject))
        columns = scene_size(session.sheet, subject)[0]
        sizes = [size_of(session.sheet, each) for each in sorted({*COLUMNS, columns})]
        fill_choices(self.size_box, [(w, f"{w} × {h} px") for w, h in sizes], columns)
        model = model_of(subject)
        self.halfway.setChecked(model.by_halfway)
        self.shadows.setChecked(model.shadows)
        self.legend.setText(legend)
        self.legend.setVisible(bool(legend))
        self._fit()

    def _give(self, name: str, value: Argument) -> None:
        session = self._session
        subject = session.state.subject
        session.update_state(subject=replace(subject, arguments={**subject.arguments, name: value}), step=0)
