"""The page Colour: colour models, the mask of a colour tube, and the beam-penetration tube."""

from collections.abc import Mapping, Sequence
from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence
from PySide6.QtWidgets import (
    QButtonGroup,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from workbench.display.colour_tube import as_levels
from workbench.display.setup import too_many_pixels
from workbench.document.model import Sheet
from workbench.document.state import Look, as_seen
from workbench.document.subjects import Argument, Position, Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.colour.derivation import derivation
from workbench.panels.display.colour.mask_view import MaskView
from workbench.panels.display.colour.models_view import ModelsView, coordinates
from workbench.panels.display.colour.penetration_view import PenetrationView
from workbench.panels.panel import KeysWhileSeen, Said
from workbench.panels.shared.lighting import Lighting
from workbench.panels.shared.tube_feed import picture_of
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.display_program import tube_strokes
from workbench.rendering.subjects.colour_model import (
    KIND,
    TO_CMY,
    TO_HSV,
    cmy_of,
    given,
    hsv_of,
    is_of_a_colour,
    rgb_of,
    setup_of,
    with_rgb,
)
from workbench.session.session import Session
from workbench.widgets.colour.solids import Model
from workbench.widgets.tube.refusal import Refusal

PAGE = "colour"
MODELS, MASK, PENETRATION = PARTS = ("models", "mask", "penetration")


class ColourPage(PlainPage, QWidget):
    """Three parts, switched at the top; all work on one colour and one picture."""

    hover_text = Signal(str)

    usual = Subject(KIND, entry=TO_HSV)
    example = "colour-bars"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.models, self.masked, self.penetration = ModelsView(), MaskView(), PenetrationView()
        self._colour_tubes = (self.masked.whole, self.masked.magnified)
        self._refusals = [Refusal(view) for view in self._colour_tubes]
        self._drawn: tuple[Sheet, Look | None, bool] | None = None
        self._lighting = Lighting(self.refresh, self)
        self.stack = QStackedWidget()
        self.switch = QButtonGroup(self)
        self.picked = QLabel()
        self.picked.setProperty("role", "muted")
        self._actions: list[QAction] = []
        head = QHBoxLayout()
        head.setSpacing(4)
        titles = (
            (_("Models"), _("RGB, CMY and HSV as solids and as sliders"), self.models),
            (_("Mask"), _("Shadow mask or grille close up, three beams and their convergence"), self.masked),
            (
                _("Penetration"),
                _("Two layers of phosphor, and a colour by voltage, for random scan"),
                self.penetration,
            ),
        )
        for number, (title, hint, part) in enumerate(titles):
            self.stack.addWidget(part)
            button = QPushButton(title)
            button.setCheckable(True)
            button.setProperty("flat", True)
            button.setToolTip(f"{hint} (Shift+{number + 1})")
            self.switch.addButton(button, number)
            head.addWidget(button)
            action = QAction(_("Colour: {title}").format(title=title), self)
            action.setObjectName(f"colour.{PARTS[number]}")
            action.setShortcut(QKeySequence(f"Shift+{number + 1}"))
            action.triggered.connect(partial(self._show_part, number))
            self.addAction(action)
            self._actions.append(action)
        head.addStretch(1)
        head.addWidget(self.picked)
        copying = QAction(_("Copy the picture of Colour"), self)
        copying.setObjectName("colour.copy_picture")
        copying.triggered.connect(lambda _on=False: self.copy())
        self._actions.append(copying)
        self.addAction(copying)
        for view in (*self.models.solids.values(), *self._colour_tubes, self.penetration.tube):
            view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
            view.addActions(self._actions)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(12, 4, 12, 8)
        whole.setSpacing(6)
        whole.addLayout(head)
        whole.addWidget(self.stack, 1)
        KeysWhileSeen(self, self._actions)
        self._connect()

    def _connect(self) -> None:
        session, run = self.session, self.session.run
        self._waiting = QTimer(self, singleShot=True, interval=0)
        self._waiting.timeout.connect(self.refresh)
        grown = session.unfolding.grown, session.ahead.arrived
        for told in (session.changed, session.state_changed, *grown):
            told.connect(lambda *_a: self._waiting.start())
        for told in (run.changed, run.moved, run.grown):
            told.connect(self._show_marks)
        self.switch.idClicked.connect(self._show_part)
        for part in (self.models, self.masked, self.penetration):
            part.changed.connect(self.change)
        self.models.text_chosen.connect(self.step_text)
        self.models.held.connect(session.hold_runs)
        for view in self._colour_tubes:
            view.picked.connect(self.pick)
            view.shown.connect(self.refresh)
        self.penetration.tube.shown.connect(self.refresh)

    # What the panel asks of a page

    def commands(self) -> Sequence[QAction]:
        """The switch of its parts."""
        return self._actions

    def said(self) -> Said:
        """What is said in passing."""
        return Said(self.hover_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The colour in three models, and the colours of the beam-penetration tube."""
        subject = self.subject
        values: Mapping[Model, Sequence[float]] = {
            "rgb": rgb_of(subject),
            "cmy": cmy_of(subject),
            "hsv": hsv_of(subject),
        }
        rows = [
            (one.letter, one.meaning, value)
            for model in values
            for one, value in zip(coordinates(model), values[model], strict=True)
        ]
        models = Table((_("symbol"), _("meaning"), _("value")), rows, formulas=False)
        return (_("Colour in three models"), models), (_("Beam penetration"), self.penetration.table)

    def derivation(self) -> Derivation:
        """How a tube shows colours, as an answer in an exam."""
        return derivation(self.subject)

    def copy(self) -> bool:
        """Put the part that is seen on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.stack.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    # What is set

    @property
    def subject(self) -> Subject:
        """What this page steps, whether it is seen or not."""
        return self.session.state.positions.get(PAGE, Position(self.usual)).subject

    def change(self, changes: Mapping[str, Argument]) -> None:
        """Set some of its numbers."""
        if self.session.state.workspace == PAGE:
            arguments = {**self.subject.arguments, **changes}
            self.session.update_state(subject=replace(self.subject, arguments=arguments))

    def step_text(self, slug: str) -> None:
        """Step this text on the colour."""
        if self.session.state.workspace == PAGE:
            self.session.update_state(subject=replace(self.subject, entry=slug), step=0)

    def _show_part(self, number: int, *_checked: object) -> None:
        self.change({"part": PARTS[number]})

    def pick(self, x: int, y: int) -> None:
        """Work on the colour of this pixel of the picture."""
        packed = int(self.masked.whole.image[y, x])
        for view in self._colour_tubes:
            view.set_probe((x, y))
        self.change(with_rgb(as_levels(packed)))
        said = _("Pixel ({x}, {y}) is #{colour:06X}.").format(x=x, y=y, colour=packed)
        self.picked.setText(said)
        self.hover_text.emit(said)

    # What is shown

    def refresh(self) -> None:
        """Show the session as it is now."""
        if not self.isVisible():
            return
        subject, sheet = self.subject, self.session.shown
        part = str(given(subject, "part"))
        number = PARTS.index(part) if part in PARTS else 0
        self.switch.button(number).setChecked(True)
        self.stack.setCurrentIndex(number)
        self.setFocusProxy((self.models.solids["rgb"], self.masked.whole, self.penetration.tube)[number])
        size = sheet.width_px, sheet.height_px
        if PARTS[number] == MODELS:
            self.models.show_subject(subject)
            self._show_marks()
        elif PARTS[number] == MASK:
            self._show_mask(subject, sheet)
        else:
            seen = as_seen(self.session.state, sheet)
            strokes = self.session.ahead.of(seen, "strokes", partial(tube_strokes, seen))
            if strokes is not None:
                self.penetration.show_subject(subject, strokes, size)

    def _show_mask(self, subject: Subject, sheet: Sheet) -> None:
        size = sheet.width_px, sheet.height_px
        self.masked.show_subject(subject, size)
        refused = too_many_pixels(size)
        for refusal in self._refusals:
            refusal.say(refused)
        if refused:
            return
        drawn = sheet, self.session.state.looks.get(sheet.id), self._lighting.lit(sheet)
        same = self._drawn is not None and self._drawn[0] is sheet and self._drawn[1:] == drawn[1:]
        seen = as_seen(self.session.state, sheet)
        image = self.masked.whole.image if same else picture_of(self.session, seen, drawn[2])
        if image is None:
            return
        self._drawn = drawn
        for view in self._colour_tubes:
            view.show_picture(image, setup_of(subject))

    def _show_marks(self) -> None:
        """What the run has worked out, on its hexagon."""
        run, subject = self.session.run, self.subject
        if not self.isVisible() or not is_of_a_colour(run.subject):
            return
        self.models.show_marks(subject.entry or TO_CMY, list(run.marks()))
