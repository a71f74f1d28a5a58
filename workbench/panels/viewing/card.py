"""The side card of View: which view, its rectangles in numbers, how the window comes into the viewport."""

from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms.viewing import scale_factors
from workbench.algorithms.viewing.window_to_viewport_point import alike
from workbench.document.building import Edit
from workbench.document.errors import DocumentError
from workbench.document.model import (
    MODES,
    Rectangle,
    Sheet,
    View,
)
from workbench.document.view_edits import (
    add_view,
    remove_view,
    rename_view,
    reorder_view,
    set_clip,
    set_mode,
)
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.stage.extent import no_extent
from workbench.panels.viewing.gestures import change_of
from workbench.panels.viewing.painting_fields import PaintingFields
from workbench.panels.viewing.rectangle_fields import RectangleFields
from workbench.panels.viewing.rectangles import SIDES, Named, rectangles
from workbench.rendering.mapping import box
from workbench.rendering.subjects.window import in_view, view_of
from workbench.session.session import Session
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import tokens

NARROW_PX = 380


def view_name(sheet: Sheet, view: View) -> str:
    """What a view is called: by its name, or by its number in the order of painting."""
    return view.name or _("View {n}").format(n=sheet.views.index(view) + 1)


class ViewCard(QScrollArea):
    """Shows and edits the view that is worked on. ``said`` sends what is to be said in passing."""

    said = Signal(str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        body = QWidget()
        body.setObjectName("pageBody")
        self._column = QVBoxLayout(body)
        self._column.setContentsMargins(12, 8, 12, 8)
        self._column.setSpacing(6)
        self.setWidget(body)
        self._make_views()
        self.rectangles = {slug: RectangleFields(named) for slug, named in rectangles().items()}
        for slug, fields in self.rectangles.items():
            fields.changed.connect(partial(self._change, rectangles()[slug]))
            fields.ended.connect(self.session.end_merge)
        self._column.addWidget(self.rectangles["window"])
        self._column.addWidget(self.rectangles["viewport"])
        self.complaint = QLabel()
        self.complaint.setWordWrap(True)
        self.complaint.setProperty("role", "error")
        self.complaint.hide()
        self._complained_of: View | None = None
        self._named = ""
        self._column.addWidget(self.complaint)
        self._make_modes()
        self._make_clipping()
        self.painting = PaintingFields(session, self.apply)
        self._column.addWidget(self.painting)
        self._column.addStretch(1)

    # The parts

    def _make_views(self) -> None:
        row = QHBoxLayout()
        self.views = QComboBox()
        self.views.setEditable(True)
        self.views.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.views.setAccessibleName(_("View"))
        self.views.setToolTip(_("The current view: choose another, or type a new name for it"))
        self.views.activated.connect(self._choose)
        line = self.views.lineEdit()
        assert line is not None
        line.editingFinished.connect(self._rename)
        self.add = QPushButton(_("Add a view"))
        self.add.setAccessibleName(_("Add a view"))
        self.add.setToolTip(_("One more viewport on this device, with the same window"))
        set_icon(self.add, "plus")
        self.add.clicked.connect(self.add_view)
        self.more = QToolButton()
        set_icon(self.more, "dots-three")
        self.more.setAccessibleName(_("More about this view"))
        self.more.setToolTip(_("Remove this view, or paint it earlier or later"))
        self.more.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.more)
        self.earlier = menu.addAction(_("Paint it earlier"), partial(self._reorder, -1))
        self.later = menu.addAction(_("Paint it later, over the others"), partial(self._reorder, 1))
        self.remove = menu.addAction(_("Remove this view"), self.remove_view)
        self.more.setMenu(menu)
        row.addWidget(self.views, 1)
        row.addWidget(self.add)
        row.addWidget(self.more)
        self._column.addLayout(row)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Narrow, the sides of a rectangle stand in two rows, and buttons have no words."""
        super().resizeEvent(event)
        narrow = event.size().width() < NARROW_PX
        for fields in self.rectangles.values():
            fields.set_narrow(narrow)
        self.add.setText("" if narrow else _("Add a view"))
        down, across = QBoxLayout.Direction.TopToBottom, QBoxLayout.Direction.LeftToRight
        for row in (self._mode_row, self.painting.device_row):
            row.setDirection(down if narrow else across)

    def _make_modes(self) -> None:
        row = self._mode_row = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        row.setSpacing(12)
        buttons = QHBoxLayout()
        buttons.setSpacing(0)
        self.modes = QButtonGroup(self)
        words = (
            (_("Stretch"), _("Corners go to corners; the picture may be distorted")),
            (_("Fit"), _("The whole window is shown, in its own proportions")),
            (_("Fill"), _("The viewport is filled completely, in the window's proportions")),
        )
        for number, (title, tip) in enumerate(words):
            button = QPushButton(title)
            button.setCheckable(True)
            button.setProperty("low", True)
            button.setToolTip(tip)
            self.modes.addButton(button, number)
            buttons.addWidget(button)
        self.modes.idClicked.connect(self._set_mode)
        self.factors = QLabel()
        self.factors.setTextFormat(Qt.TextFormat.RichText)
        self.factors.setAccessibleName(_("Scale factors"))
        buttons.addStretch(1)
        row.addLayout(buttons)
        row.addWidget(self.factors, 1)
        self._column.addLayout(row)
        self.warning = QLabel()
        self.warning.setTextFormat(Qt.TextFormat.RichText)
        self.warning.setWordWrap(True)
        # Its room stays when it has nothing to say, so that nothing below it moves.
        self.warning.setMinimumHeight(2 * self.warning.fontMetrics().height())
        self._column.addWidget(self.warning)

    def _make_clipping(self) -> None:
        self.clips = QCheckBox(_("Clip to a separate window first"))
        self.clips.setToolTip(
            _("Figures are clipped to this rectangle first; without it the viewport cuts them off")
        )
        self.clips.clicked.connect(self._clip_or_not)
        self._column.addWidget(self.clips)
        self._column.addWidget(self.rectangles["clip"])

    # What is shown

    @property
    def view(self) -> View:
        """The view that is worked on."""
        return view_of(self.session.sheet, self.session.subject)

    def refresh(self, before: View | None) -> None:
        """Show the view; what differs from how it was ``before`` a drag is lit."""
        sheet, view = self.session.sheet, self.view
        if self._complained_of is not None and view != self._complained_of:
            self._complain("")  # it was put right elsewhere, as by a drag or by undo
        names = [view_name(sheet, each) for each in sheet.views]
        line = self.views.lineEdit()
        if names != [self.views.itemText(k) for k in range(self.views.count())]:
            self.views.clear()
            self.views.addItems(names)
        place = sheet.views.index(view)
        other, self._named = view.id != self._named, view.id
        if line is not None and (other or not (line.hasFocus() and line.isModified())):
            self.views.setCurrentIndex(place)
            line.setText(names[place])
        self.remove.setEnabled(len(names) > 1)
        self.earlier.setEnabled(place > 0)
        self.later.setEnabled(place < len(names) - 1)
        for slug, named in rectangles().items():
            rectangle, old = named.of(view), None if before is None else named.of(before)
            self.rectangles[slug].setVisible(rectangle is not None)
            if rectangle is not None:
                lit = frozenset(
                    side for side in SIDES if old and getattr(old, side) != getattr(rectangle, side)
                )
                self.rectangles[slug].show_rectangle(view.id, rectangle, lit)
        self.clips.setChecked(view.clip_world is not None)
        button = self.modes.button(MODES.index(view.mode))
        button.setChecked(True)
        self._show_factors(view, before)
        self.painting.refresh()

    def _show_factors(self, view: View, before: View | None) -> None:
        now = tokens()
        sx, sy = factors_of(view)
        old = (sx, sy) if before is None else factors_of(before)
        lines = []
        for name, value, was, over, under in (
            ("x", sx, old[0], *_sides(view, "x")),
            ("y", sy, old[1], *_sides(view, "y")),
        ):
            text = f"s<sub>{name}</sub> = "
            if view.mode == "stretch":
                text += f"{displayed(over)}/{displayed(under)} = "
            text += displayed(value)
            lines.append(f'<b style="color:{now.accent}">{text}</b>' if value != was else text)
        self.factors.setText(f'<span style="font-family:monospace">{"<br>".join(lines)}</span>')
        words = distortion(sx, sy)
        self.warning.setText(f'<span style="color:{now.warn}">⚠ {words}</span>' if words else "")

    # What is edited

    def apply(
        self, edit: Edit, name: str, merge: str = "", slug: str = "", asked: Rectangle | None = None
    ) -> bool:
        """Do an edit; False where it was refused, which is said under the fields; of those of ``slug`` the
        ones are edged then in which ``asked`` is another than the rectangle there."""
        try:
            self.session.apply(edit, name, merge)
        except DocumentError as problem:
            self._complain(problem.short, slug, asked)
            return False
        self._complain("")
        return True

    def _complain(self, sentence: str, slug: str = "", asked: Rectangle | None = None) -> None:
        self.complaint.setText(sentence)
        self.complaint.setVisible(bool(sentence))
        self._complained_of = self.view if sentence else None
        for name, fields in self.rectangles.items():
            fields.mark_wrong(asked if name == slug else None)

    def refuse(self, sentence: str) -> None:
        """Say what is wrong with a number that was given elsewhere."""
        self._complain(sentence)

    def _change(self, named: Named, rectangle: Rectangle, merge: str) -> None:
        sentence = no_extent(rectangle, named.slug == "viewport")
        if sentence:
            self._complain(sentence, named.slug, rectangle)
        else:
            edit = named.edit(self.view.id, rectangle)
            self.apply(edit, change_of(named), merge, named.slug, rectangle)

    def _set_mode(self, number: int) -> None:
        self.apply(set_mode(self.view.id, MODES[number]), _("Change how the window is shown"))

    def _clip_or_not(self, on: bool) -> None:
        clip = self.view.window_world if on else None
        self.apply(set_clip(self.view.id, clip), _("Change the clip window"))

    def _choose(self, index: int) -> None:
        sheet = self.session.sheet
        if 0 <= index < len(sheet.views):
            self.choose_view(sheet.views[index].id)

    def choose_view(self, view: str) -> None:
        """Work on another view."""
        self.session.update_state(subject=in_view(self.session.state.subject, view))

    def _rename(self) -> None:
        line = self.views.lineEdit()
        if line is None or not line.isModified():
            return
        name = line.text().strip()
        line.setModified(False)
        if name != view_name(self.session.sheet, self.view):
            self.apply(rename_view(self.view.id, name), _("Rename the view"))

    def add_view(self) -> None:
        """One more view, a copy of this one, its viewport beside the other where there is room."""
        sheet, view = self.session.sheet, self.view
        known = {each.id for each in sheet.views}
        added = replace(view, id="", name="", viewport_device=_beside(sheet, view))
        if self.apply(add_view(sheet.id, added), _("Add a view")):
            self.choose_view(next(each.id for each in self.session.sheet.views if each.id not in known))

    def remove_view(self) -> None:
        """Remove the view that is worked on."""
        self.apply(remove_view(self.view.id), _("Remove the view"))

    def _reorder(self, by: int) -> None:
        place = self.session.sheet.views.index(self.view) + by
        self.apply(reorder_view(self.view.id, place), _("Change order"))


def factors_of(view: View) -> tuple[float, float]:
    """s_x and s_y of a view."""
    return scale_factors(box(view.window_world), box(view.viewport_device), view.mode)  # type: ignore[arg-type]


def _sides(view: View, axis: str) -> tuple[float, float]:
    """The sides of viewport and window along x or y."""
    over, under = (
        getattr(each, f"{axis}max") - getattr(each, f"{axis}min")
        for each in (view.viewport_device, view.window_world)
    )
    return over, under


def distortion(sx: float, sy: float) -> str:
    """What the two scale factors do to shapes, as rich text; empty where they do nothing."""
    if alike(sx, sy):
        return ""
    low, high = sorted((sx, sy))
    ratio = high / low
    known = ((4 / 3, _("by a third")), (3 / 2, _("by a half")), (2.0, _("twofold")), (3.0, _("threefold")))
    much = next((words for value, words in known if abs(ratio - value) < 1e-9), "")
    if not much:
        much = _("{n} times").format(n=displayed(ratio))
    if sy > sx:
        text = _("Taller {much}: s<sub>y</sub> = {ratio} s<sub>x</sub>. Circles turn into ellipses.")
    else:
        text = _("Wider {much}: s<sub>x</sub> = {ratio} s<sub>y</sub>. Circles turn into ellipses.")
    return text.format(much=much, ratio=displayed(ratio))


def _beside(sheet: Sheet, view: View) -> Rectangle:
    """A viewport of the same size right of this one, left of it, or else where this one is, half as large."""
    own = view.viewport_device
    wide, high = own.xmax - own.xmin, own.ymax - own.ymin
    if own.xmax + wide <= sheet.width_px - 0.5:
        return replace(own, xmin=own.xmax, xmax=own.xmax + wide)
    if own.xmin - wide >= -0.5:
        return replace(own, xmin=own.xmin - wide, xmax=own.xmin)
    return Rectangle(own.xmin, own.ymin, own.xmin + wide / 2, own.ymin + high / 2)
