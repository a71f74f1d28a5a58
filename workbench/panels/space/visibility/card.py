"""The card of the Visibility page: size of the picture, bits for a depth, what is shown, near and far."""

from functools import partial
from html import escape

from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QGridLayout, QLabel, QToolButton

from workbench.algorithms import catalogue
from workbench.document.errors import DocumentError
from workbench.document.fields import numbers_of
from workbench.document.scene.edits import set_camera
from workbench.document.scene.model import Camera
from workbench.document.subjects import Argument
from workbench.language import _, ngettext
from workbench.panels.space.visibility.back_face_run import BackFaceRun
from workbench.panels.space.visibility.depth_run import DepthRun
from workbench.panels.space.visibility.line_run import LineRun
from workbench.panels.space.visibility.octree_fields import OctreeFields
from workbench.panels.space.visibility.picture import Shown, surface_colours
from workbench.panels.space.visibility.solid_run import SolidRun
from workbench.panels.space.visibility.surface_run import SurfaceRun
from workbench.panels.stage.card import number_field
from workbench.panels.stage.folding_card import FoldingCard, fill_choices
from workbench.rendering.subjects.visibility import (
    NOT_ROUNDED,
    USUAL_COLUMNS,
    backwards,
    depth_bits,
    method_of,
    scene_size,
    size_of,
)
from workbench.session.session import Session
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.look.tokens import tokens

WIDTH_PX = 212
COLUMNS = (24, 36, USUAL_COLUMNS, 64, 96)
BITS = (NOT_ROUNDED, 32, 24, 16, 12, 10, 8, 6, 5, 4)
_MOST_NAMED = 5


class VisibilityCard(FoldingCard):
    """``shown_changed``: something else of the run is to be shown."""

    shown_changed = Signal()

    def __init__(self, session: Session, canvas: CanvasSurface) -> None:
        super().__init__(canvas, WIDTH_PX)
        self._session = session
        self.shown: Shown = "colour"
        self.title.setText(_("Visibility"))
        self.method, self.size_box, self.bits = ChoiceBox(), ChoiceBox(), ChoiceBox()
        for box, name, tip in (
            (self.method, _("Method"), _("How hidden surfaces are found")),
            (
                self.size_box,
                _("Size of the picture"),
                _("How many pixels the picture has"),
            ),
            (self.bits, _("Bits for a depth"), _("How many bits the depth buffer has for a pixel")),
        ):
            box.setAccessibleName(name)
            box.setToolTip(tip)
            tell_choice(box)
            self.body.addWidget(box)
        self.method.activated.connect(lambda k: session.choose(self.method.itemData(k)))
        self.size_box.activated.connect(lambda k: self._give("columns", self.size_box.itemData(k)))
        self.bits.activated.connect(lambda k: self._give("bits", self.bits.itemData(k)))
        self._add_shown()
        self.backwards = QCheckBox(_("Last surface first"))
        self.backwards.setToolTip(_("Draw the surfaces in the opposite order: does the picture change?"))
        self.backwards.clicked.connect(lambda on: self._give("backwards", on))
        self.body.addWidget(self.backwards)
        self.octree = OctreeFields(self._give)
        self.body.addWidget(self.octree)
        self.planes: dict[str, NumberField] = {}
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        for column, (name, label) in enumerate((("near", "z_near"), ("far", "z_far"))):
            number = numbers_of(Camera)[name]
            field = number_field(replace(number, label=label, unit=""), number.label.capitalize())
            field.edited.connect(partial(self._set_plane, name))
            field.scrubbed.connect(partial(self._set_plane, name, merge="scrub"))
            field.scrub_ended.connect(session.end_merge)
            self.planes[name] = field
            grid.addWidget(field, 0, column)
        self.body.addLayout(grid)
        self.legend = QLabel()
        self.legend.setWordWrap(True)
        self.body.addWidget(self.legend)

    def _add_shown(self) -> None:
        self.buttons = QButtonGroup(self)
        grid = QGridLayout()
        grid.setSpacing(4)
        each: tuple[tuple[Shown, str, str], ...] = (
            ("colour", _("Colour"), _("The frame buffer")),
            ("depth", _("Depth"), _("The depth buffer: light is near, dark is far")),
            ("tests", _("Tests"), _("How often each pixel was compared")),
            (
                "writes",
                _("Overdraw"),
                _("How often each pixel was written; once would be enough"),
            ),
        )
        for k, (shown, title, tip) in enumerate(each):
            button = QToolButton()
            button.setText(title)
            button.setCheckable(True)
            button.setChecked(shown == self.shown)
            button.setToolTip(tip)
            button.setAccessibleName(title)
            button.setSizePolicy(self.size_box.sizePolicy())
            button.clicked.connect(partial(self._show, shown))
            self.buttons.addButton(button, k)
            grid.addWidget(button, k // 2, k % 2)
        self.body.addLayout(grid)

    def _show(self, shown: Shown, _checked: bool = True) -> None:
        self.shown = shown
        self.shown_changed.emit()

    def refresh(
        self,
        run: DepthRun | None,
        fighting: int,
        told: BackFaceRun | SurfaceRun | LineRun | SolidRun | None,
    ) -> None:
        """Show what is set, and what the colours mean; ``fighting`` pixels show the wrong surface now.

        ``told`` is how far a method has come that keeps no depths, where one is stepped.
        """
        session = self._session
        scene = session.sheet.scene
        self.setVisible(scene is not None)
        if scene is None:
            return
        subject = session.subject
        slugs = session.choices_of()
        titles = [(slug, _(catalogue.get(slug).title)) for slug in slugs]
        fill_choices(self.method, titles, method_of(session.sheet, subject))
        for widget in (self.backwards, *self.buttons.buttons()):
            widget.setVisible(told is None)
        self.octree.refresh(session.sheet, subject)
        sizes = [size_of(session.sheet, columns) for columns in COLUMNS]
        choices = [(columns, f"{columns} × {rows} px") for columns, rows in sizes]
        columns = scene_size(session.sheet, subject)[0]
        if columns not in COLUMNS:
            choices.insert(0, (columns, _("{columns} px wide").format(columns=columns)))
        fill_choices(self.size_box, choices, columns)
        roundings = [(n, _("{n} bits for z").format(n=n) if n else _("z not rounded")) for n in BITS]
        bits = depth_bits(subject)
        if bits not in BITS:
            roundings.insert(0, (bits, _("{n} bits for z").format(n=bits)))
        fill_choices(self.bits, roundings, bits)
        self.bits.setVisible(told is None)
        self.backwards.setChecked(backwards(subject))
        for name, field in self.planes.items():
            field.belong_to(session.sheet.id)
            field.set_value(round(getattr(scene.camera, name), 6))
        if told is not None:
            self.legend.setText(told.legend)
        else:
            self.legend.setText("" if run is None else self._legend(run, fighting))
        self.legend.setVisible(bool(self.legend.text()))
        self._fit()

    def _legend(self, run: DepthRun, fighting: int) -> str:
        now = tokens()
        lines = []
        if self.shown == "colour":
            lines = _names(run)
            lines.append(
                f'<span style="color:{now.muted}">▢</span> {_("empty, z = {z:g}").format(z=run.farthest)}'
            )
        elif self.shown == "depth":
            lines = [_("Light is near, dark is far.")]
        elif run.reached:
            counts = run.so_far.tests(run.size) if self.shown == "tests" else run.so_far.writes(run.size)
            n, most = int(counts.sum()), int(counts.max())
            text = (
                ngettext("{n} comparison", "{n} comparisons", n)
                if self.shown == "tests"
                else ngettext("{n} write", "{n} writes", n)
            )
            lines = [_("{count}, at most {most} at a pixel.").format(count=text.format(n=n), most=most)]
        if fighting:
            said = ngettext(
                "{n} pixel shows the wrong surface.",
                "{n} pixels show the wrong surface.",
                fighting,
            )
            lines.append(f'<span style="color:{now.error}">✗</span> {said.format(n=fighting)}')
        return "<br>".join(lines)

    def _give(self, name: str, value: Argument) -> None:
        """Give the subject an argument; its run goes on from its start where its steps are others."""
        session = self._session
        subject = session.state.subject
        step = {} if name == "bits" else {"step": 0}
        session.update_state(subject=replace(subject, arguments={**subject.arguments, name: value}), **step)

    def _set_plane(self, name: str, value: float, merge: str = "") -> None:
        sheet = self._session.sheet
        if sheet.scene is None:
            return
        try:
            camera = replace(sheet.scene.camera, **{name: value})
            title = _("Move the near plane") if name == "near" else _("Move the far plane")
            self._session.apply(set_camera(sheet.id, camera), title, merge and f"{merge} {name}")
        except DocumentError as problem:
            self.planes[name].refuse(problem.short, getattr(sheet.scene.camera, name))


def _names(run: DepthRun) -> list[str]:
    """The objects with a colour of theirs, that which is drawn now marked."""
    colours, number = surface_colours(run, tokens()), run.now
    drawn = None if number is None else run.device.objects[run.fragments.surface[number]]
    first_of = {int(thing): k for k, thing in reversed(list(enumerate(run.device.objects.tolist())))}
    lines = []
    for thing, triangle in sorted(first_of.items())[:_MOST_NAMED]:
        mark = "◤" if thing == drawn else "■"
        name = escape(run.object_name(triangle))
        said = _("{name}, now").format(name=name) if thing == drawn else name
        lines.append(f'<span style="color:#{int(colours[triangle]):06X}">{mark}</span> {said}')
    if len(first_of) > _MOST_NAMED:
        lines.append(_("and {n} more").format(n=len(first_of) - _MOST_NAMED))
    return lines
