"""The bar above the drawing: plates or coils, phosphor, labels, examples, saving; below it the time."""

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from workbench.display.gun import Gun
from workbench.display.phosphor import Phosphor
from workbench.display.setup import COLOUR_TUBE, phosphor_choices
from workbench.document.state import TubeSettings
from workbench.language import _
from workbench.panels.display.controls import phosphor_title
from workbench.panels.display.gun.presets import presets
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.slider_field import SliderField
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tips import tell_choice

_NARROW_PX = 700


class GunBar(QWidget):
    """``edited`` sends settings by name, ``preset_wanted`` the slug of an example, ``labelled`` whether parts
    are named, ``paused`` and ``slowed`` how the tube's time runs, ``moment_wanted`` a time in milliseconds.
    """

    edited = Signal(dict)
    preset_wanted = Signal(str)
    labelled = Signal(bool)
    paused = Signal(bool)
    slowed = Signal(float)
    moment_wanted = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.bent_by, self.phosphor = ChoiceBox(9), ChoiceBox(16)
        self.bent_by.addItem(_("by plates"), False)
        self.bent_by.addItem(_("by coils"), True)
        for name in phosphor_choices():
            self.phosphor.addItem(_phosphor_title(name), name)
        self.labels = QCheckBox(_("Labels"))
        self.labels.setChecked(True)
        self.labels.setAccessibleName(_("Labels"))
        self.labels.setToolTip(_("Name the parts in the drawing, here and where it is saved"))
        self.examples = QToolButton()
        self.examples.setText(_("Examples"))
        self.examples.setAccessibleName(_("Examples"))
        self.examples.setToolTip(_("Settings worth looking at: a worked sum, a Lissajous figure, a sweep"))
        self.examples.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.examples.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        set_icon(self.examples, "caret-down")
        menu = QMenu(self.examples)
        menu.setToolTipsVisible(True)
        for each in presets():
            action = menu.addAction(each.title)
            action.setToolTip(each.told)
            action.triggered.connect(lambda _on=False, slug=each.slug: self.preset_wanted.emit(slug))
        self.examples.setMenu(menu)
        self.reset = QToolButton()
        self.reset.setFixedSize(30, 30)
        self.reset.setAccessibleName(_("Reset the tube"))
        self.reset.setToolTip(_("Put the tube back as it was at first; Undo does not reach what is set here"))
        set_icon(self.reset, "arrow-counter-clockwise")
        self.reset.clicked.connect(lambda: self.preset_wanted.emit(presets()[0].slug))
        self.save = QToolButton()
        self.save.setText(_("Save drawing"))
        self.save.setAccessibleName(_("Save drawing"))
        self.save.setToolTip(_("Save the tube as SVG or PDF, with its labels or without"))
        self.save.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        set_icon(self.save, "download-simple")
        row = QHBoxLayout(self)
        row.setSpacing(8)
        self._titles = []
        for title, box, meaning in (
            (_("Deflection"), self.bent_by, _("What bends the beam: an electric or a magnetic field")),
            (_("Phosphor"), self.phosphor, _("What the screen is coated with, and its persistence to 10 %")),
        ):
            label = QLabel(title)
            label.setProperty("role", "muted")
            label.setBuddy(box)
            self._titles.append(label)
            box.setAccessibleName(title)
            box.setToolTip(meaning)
            tell_choice(box)
            row.addWidget(label)
            row.addWidget(box)
        for part in (self.labels, self.examples, self.reset):
            row.addWidget(part)
        row.addStretch(1)
        row.addWidget(self.save)
        row.setContentsMargins(0, 0, 0, 0)
        self._make_time()
        self.bent_by.activated.connect(lambda _row: self.edited.emit({"coils": self.bent_by.currentData()}))
        self.phosphor.activated.connect(
            lambda _row: self.edited.emit({"phosphor": self.phosphor.currentData()})
        )
        self.labels.toggled.connect(self.labelled)

    def _make_time(self) -> None:
        """A row of its own, which stands where the cards do."""
        self.time = QWidget()
        self.pause = QToolButton()
        self.pause.setText(_("Pause"))
        self.pause.setCheckable(True)
        self.pause.setIconSize(QSize(16, 16))
        self.pause.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.pause.setAccessibleName(_("Pause"))
        self.pause.setToolTip(_("Hold the tube's time, and step the beam as it is then"))
        set_icon(self.pause, "pause")
        self.slow = SliderField(
            _("Slower"),
            "\N{MULTIPLICATION SIGN}",
            _("How many times slower than life the inputs run"),
            1.0,
            1e6,
            logarithmic=True,
        )
        self.moment = SliderField(_("Time"), "ms", _("The moment at which the beam is drawn"), 0.0, 1e6)
        row = QHBoxLayout(self.time)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(16)
        row.addWidget(self.pause)
        row.addWidget(self.slow, 1)
        row.addWidget(self.moment, 1)
        self.pause.clicked.connect(self.paused)
        self.slow.edited.connect(self.slowed)
        self.moment.edited.connect(self.moment_wanted)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where it is narrow, boxes and saving stand without their names, which they tell as tooltips."""
        super().resizeEvent(event)
        wide = event.size().width() >= _NARROW_PX
        for title in self._titles:
            title.setVisible(wide)
        style = Qt.ToolButtonStyle
        self.save.setToolButtonStyle(style.ToolButtonTextBesideIcon if wide else style.ToolButtonIconOnly)

    def show_gun(self, gun: Gun, tube: TubeSettings) -> None:
        """Show what is set."""
        self.bent_by.setCurrentIndex(int(gun.coils))
        self.phosphor.setCurrentIndex(max(self.phosphor.findData(gun.phosphor), 0))
        if gun.swings:
            self.pause.setChecked(tube.paused)
            self.slow.set_value(max(tube.slow_motion, 1.0))
            self.moment.reach(0.0, 1e3 * float(gun.period))
            self.moment.set_value(gun.moment)


def _phosphor_title(name: str) -> str:
    """A phosphor as everywhere, and whether its time is to be doubted."""
    doubtful = name != COLOUR_TUBE and Phosphor.named(name).uncertain
    return phosphor_title(name) + (_(" (uncertain)") if doubtful else "")
