"""The card over the picture: which projection the scene is seen by, and the numbers of its camera."""

from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from workbench.document.fields import Number, numbers_of
from workbench.document.scene.looking import kind_of, kinds
from workbench.document.scene.model import Camera, Point3D
from workbench.document.scene.view_reference import view_reference
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.looking import Looking
from workbench.panels.space.strokes import short
from workbench.widgets.fields.number_field import NumberField, complaint_label
from workbench.widgets.look.icons import set_icon

_WIDTH_PX, _FOLDED_PX = 330, 240
_FOR = {
    "perspective": ("distance",),
    "oblique": ("oblique_alpha", "oblique_phi"),
    "cavalier": ("oblique_phi",),
    "cabinet": ("oblique_phi",),
    "axonometric": ("angle_y", "angle_x"),
}
_STEPS = {"distance": 0.1, "near": 0.1, "far": 1.0}


def families() -> dict[str, str]:
    """What the families of projections are called."""
    return {
        "orthographic": _("Orthographic"),
        "axonometric": _("Axonometric"),
        "oblique": _("Oblique"),
        "perspective": _("Perspective"),
        "general": _("General"),
    }


class CameraCard(QFrame):
    """Shows and edits the camera that the scene is seen by; an edit keeps what was only looked at.

    ``said`` sends what is wrong, ``chosen`` the slug of a projection that was chosen here;
    ``refitted`` follows another size, ``turned_over`` that z is to be seen the other way.
    """

    said = Signal(str)
    chosen = Signal(str)
    refitted = Signal()
    turned_over = Signal()

    def __init__(self, looking: Looking, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self._looking = looking
        self.kind = QComboBox()
        self.kind.setAccessibleName(_("Projection"))
        self.kind.setToolTip(_("How the scene is projected onto the view plane"))
        self._fill()
        self.kind.activated.connect(lambda index: self.chosen.emit(self.kind.itemData(index)))
        self._body = QWidget()
        self._fold = QToolButton()
        self._fold.setFixedSize(22, 22)
        self._fold.clicked.connect(lambda: self.set_open(self._body.isHidden()))
        head = self._head = QHBoxLayout()
        head.setSpacing(4)
        head.addWidget(self.kind, 1)
        head.addWidget(self._fold)
        self.fields: dict[str, NumberField] = {}
        self._complaint = complaint_label()
        self._camera: Camera | None = None
        grid = QGridLayout(self._body)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(4)
        numbers = numbers_of(Camera)
        names = ("distance", "oblique_alpha", "oblique_phi", "angle_y", "angle_x")
        for row, name in enumerate(names):
            grid.addWidget(self._field(name, numbers[name]), row, 0, 1, 3)
        points = (("eye", _("eye"), "e"), ("look_at", _("look at"), "a"), ("up", _("up"), "u"))
        for row, (name, title, symbol) in enumerate(points, len(names)):
            for column, axis in enumerate("xyz"):
                number = numbers_of(Point3D)[axis]
                meaning = _("{axis} of {point}").format(axis=axis, point=title)
                field = self._field(f"{name}.{axis}", number, f"{symbol}_{axis}", meaning)
                grid.addWidget(field, row, column)
        below = len(names) + len(points)
        grid.addWidget(self._field("near", numbers["near"], _("near")), below, 0)
        grid.addWidget(self._field("far", numbers["far"], _("far")), below, 1)
        grid.addWidget(self._complaint, below + 1, 0, 1, 3)
        self.book = QLabel()
        self.book.setProperty("role", "muted")
        self.book.setToolTip(_("What Hearn and Baker call it"))
        self.book.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        grid.addWidget(self.book, below + 2, 0, 1, 3)
        self.towards_eye = QCheckBox(_("z towards the eye, as in the book"))
        self.towards_eye.setToolTip(_("V begins at VRP and z points to the eye; P makes up for it, M stays"))
        self.towards_eye.toggled.connect(self._turn_over)
        grid.addWidget(self.towards_eye, below + 3, 0, 1, 3)
        self.note = QLabel()
        self.note.setProperty("role", "muted")
        self.keep = QPushButton(_("Keep this view"))
        self.keep.setToolTip(
            _("Write where you are looking from into the document, which keeps its own view until then")
        )
        self.keep.clicked.connect(lambda: self.said.emit(looking.keep()))
        self.back = QPushButton(_("Back to the track"))
        self.back.setToolTip(_("See the scene through its own moving camera again"))
        self.back.clicked.connect(lambda: self.said.emit(looking.look(None)))
        column_ = QVBoxLayout(self)
        column_.setContentsMargins(8, 6, 6, 6)
        column_.setSpacing(4)
        column_.addLayout(head)
        column_.addWidget(self._body)
        self._foot = foot = QHBoxLayout()
        foot.setSpacing(8)
        foot.addWidget(self.note, 1)
        foot.addWidget(self.back)
        foot.addWidget(self.keep)
        column_.addLayout(foot)
        self.set_open(False)

    def _fill(self) -> None:
        model = self.kind.model()
        family = ""
        for kind in kinds():
            if kind.family != family:
                family = kind.family
                self.kind.addItem(families()[family])
                assert isinstance(model, QStandardItemModel)
                model.item(self.kind.count() - 1).setEnabled(False)
            self.kind.addItem(kind.title, kind.slug)

    def _field(self, name: str, number: Number, label: str = "", meaning: str = "") -> NumberField:
        field = NumberField(
            label or number.symbol or number.label,
            "" if number.unit == "world" else number.unit,
            low=number.low,
            high=number.high,
            step=_STEPS.get(name, 1.0 if number.unit == "°" else 0.1),
            meaning=meaning or number.label,
            complaint=self._complaint,
        )
        field.edited.connect(partial(self._set, name, ""))
        field.scrubbed.connect(partial(self._set, name, f"camera {name}"))
        field.scrub_ended.connect(self._looking.session.end_merge)
        self.fields[name] = field
        return field

    def _set(self, name: str, merge: str, value: float) -> None:
        camera = self._looking.camera
        head, _dot, axis = name.partition(".")
        if axis:
            changed = replace(camera, **{head: replace(getattr(camera, head), **{axis: value})})
        else:
            changed = replace(camera, **{head: value})
        if refusal := self._looking.change(changed, _("Change the camera"), merge):
            self.fields[name].refuse(refusal, self._value(camera, name))

    def _turn_over(self, on: bool) -> None:
        self._looking.z_towards_eye = on
        self.turned_over.emit()

    @staticmethod
    def _value(camera: Camera, name: str) -> float:
        value: object = camera
        for part in name.split("."):
            value = getattr(value, part)
        assert isinstance(value, float | int)
        return round(float(value), 6)

    def set_open(self, opened: bool) -> None:
        """Show all numbers, or only the projection."""
        self._body.setVisible(opened)
        set_icon(self._fold, "caret-up" if opened else "caret-down", "muted")
        words = _("Fold this card") if opened else _("Show the numbers of the camera")
        self._fold.setToolTip(words)
        self._fold.setAccessibleName(words)
        self._fit()

    def show_camera(self, camera: Camera, around: bool) -> None:
        """Show a camera; ``around``: whether it is only that of whoever looks around."""
        try:
            kind = kind_of(camera)
        except ValueError:
            kind = camera.projection
        self.kind.setCurrentIndex(max(self.kind.findData(kind), 0))
        shown = _FOR.get(camera.projection, ())
        if camera != self._camera:
            self._camera = camera
            for field in self.fields.values():
                field.complain("")
        owner = self._looking.session.sheet.id, camera.projection
        for name, field in self.fields.items():
            field.belong_to(owner)
            field.set_value(self._value(camera, name))
            if name in ("distance", "oblique_alpha", "oblique_phi", "angle_y", "angle_x"):
                field.setVisible(name in shown)
        self.book.setText(_book_words(camera))
        back = around and self._looking.tracked
        self.note.setText(_("Looking around") if around else "")
        self.note.setVisible(around and not back)
        self.back.setVisible(back)
        self.keep.setVisible(around)
        self._fit()

    def event(self, event: QEvent) -> bool:
        """As large as what it holds."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self._fit()
        return done

    def _fit(self) -> None:
        layout = self.layout()
        if layout is not None:
            margins = layout.contentsMargins()  # beside the longest name, and what stands below
            room = max(row.sizeHint().width() for row in (self._head, self._foot))
            width = _FOLDED_PX if self._body.isHidden() else _WIDTH_PX
            width = max(width, room + margins.left() + margins.right())
            wraps = layout.hasHeightForWidth()
            height = layout.totalHeightForWidth(width) if wraps else layout.totalSizeHint().height()
            if (width, height) != (self.width(), self.height()):
                self.resize(width, height)
                self.refitted.emit()
            self.raise_()


def _book_words(camera: Camera) -> str:
    """VRP, VPN and PRP, a line each; nothing where the camera sees nothing."""
    try:
        book = view_reference(camera)
    except ValueError:
        return ""
    named = {name: _triple(getattr(book, name)[:3]) for name in ("vrp", "vpn", "prp")}
    far = _("PRP at infinity, along {prp}") if book.prp[3] == 0.0 else _("PRP = eye, {prp} from VRP")
    lines = [
        _("VRP = look at, {vrp}").format(**named),
        _("VPN towards the eye, {vpn}").format(**named),
        far.format(**named),
    ]
    if book.plane is not None:
        lines.append(_("View plane at z = {z}").format(z=short(book.plane)))
    return "\n".join(lines)


def _triple(values: Array) -> str:
    return "({})".format(", ".join(short(value) for value in values.tolist()))
