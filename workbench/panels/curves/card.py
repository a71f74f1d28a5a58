"""The card of the Curves panel: kind, degree, knots and shape of a curve, kinds beside it, chosen points."""

from collections.abc import Callable, Sequence
from html import escape

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QStandardItemModel
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QLabel, QMenu, QToolButton, QWidget

from workbench.algorithms import catalogue
from workbench.algorithms.curves import counting
from workbench.document.curves.edits import (
    set_beside,
    set_curve_closed,
    set_degree,
    set_knot_rule,
    set_spline,
)
from workbench.document.curves.pieces import ends_steer, fault_of, goes_round, may_be_closed, pieces_of
from workbench.document.edits import Edit, both, set_attributes
from workbench.document.fields import Number, numbers_of
from workbench.document.model import (
    B_SPLINES,
    CONTINUITY_SIGNS,
    ENDS,
    JOINTS,
    KNOT_RULES,
    NEIGHBOUR_SPLINES,
    SPLINES,
    AnyFigure,
    Curve,
    CurvePoint,
    Sheet,
)
from workbench.language import _, ngettext
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.freehand import FreehandTool
from workbench.panels.curves.names import (
    is_handle,
    look_of,
    mark_of,
    point_name,
    spline_title,
)
from workbench.panels.curves.pen import PenTool
from workbench.panels.curves.shape import has_tangent
from workbench.panels.stage.card import ParameterCard, number_field
from workbench.panels.stage.folding_card import fill_choices
from workbench.panels.stage.tools import FigureTool
from workbench.rendering.curve_runs import construction_fault, construction_of, constructions_of
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import tokens

_MOST_CHOSEN = 2
_EDITS: dict[str, Callable[..., Edit]] = {
    "spline": set_spline,
    "beside": set_beside,
    "degree": set_degree,
    "closed": set_curve_closed,
    "knot_rule": set_knot_rule,
}

Value = bool | int | float | str | tuple[str, ...]


class CurveCard(ParameterCard):
    """Shows and edits the selected curve, or with none selected what the pen draws next."""

    offers_comparison = False

    def __init__(self, focus: CurveFocus, canvas: CanvasSurface) -> None:
        self.focus = focus
        self._pen: PenTool | None = None
        self._freehand: FreehandTool | None = None
        super().__init__(focus.session, canvas)
        body = self._body.layout()
        assert body is not None
        body.setSpacing(6)
        body.removeWidget(self.algorithm)
        body.addWidget(self.algorithm)
        self.algorithm.setToolTip(_("The line algorithm that draws the chords of the curve"))

    def more_rows(self) -> list[QWidget]:
        """Kind, degree and closed, knots, ends, shape, joint; kinds beside; countings; what is missing."""
        self.spline = self._choice(_("Kind of curve"), [(name, spline_title(name)) for name in SPLINES])
        self.spline.activated.connect(lambda: self._put("spline", self.spline.currentData()))
        numbers = numbers_of(Curve)
        self.degree = number_field(numbers["degree"], _("Degree of the B-spline"))
        self.degree.edited.connect(lambda value: self._put("degree", int(value)))
        self.degree.scrubbed.connect(lambda value: self._put("degree", int(value), "scrub"))
        self.degree.scrub_ended.connect(self._session.end_merge)
        self.closed = QCheckBox(_("Closed"))
        self.closed.setToolTip(_("The curve comes back to where it began"))
        self.closed.clicked.connect(lambda on: self._put("closed", bool(on)))
        rules = zip(KNOT_RULES, (_("Knots open uniform"), _("Knots uniform"), _("Knots free")), strict=True)
        self.rule = self._choice(_("Knots"), list(rules))
        self.rule.setToolTip(_("Open uniform reaches the end points; free knots are dragged on their bar"))
        self.rule.activated.connect(lambda: self._put("knot_rule", self.rule.currentData()))
        ends = zip(ENDS, (_("Through the end points"), _("End points only guide")), strict=True)
        self.ends = self._choice(_("Ends"), list(ends))
        self.ends.activated.connect(lambda: self._put("ends", self.ends.currentData()))
        signs = (_("c as in Hearn and Baker"), _("c as in the paper of 1984"))
        self.sign = self._choice(
            _("Whose sign the continuity has: Hearn and Baker's is the opposite of the original paper's"),
            list(zip(CONTINUITY_SIGNS, signs, strict=True)),
        )
        self.sign.activated.connect(lambda: self._put("continuity_sign", self.sign.currentData()))
        shapes = ("tension", "continuity", "bias", "alpha")
        self.shape = {name: self._shape_field(name, numbers[name]) for name in shapes}
        joints = zip(JOINTS, (_("Corner"), _("Smooth"), _("Symmetric")), strict=True)
        self.joint = self._choice(_("Joint at the point"), list(joints))
        self.joint.setToolTip(_("How the two handles of the chosen points depend on each other"))
        self.joint.activated.connect(lambda: self.joint_chosen(self.joint.currentData()))
        self.joint_chosen: Callable[[str], object] = lambda _joint: None
        self.beside = QToolButton()
        self.beside.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.beside.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.beside.setAccessibleName(_("Other kinds of curve over the same points"))
        self.beside.setToolTip(_("Other kinds of curve over the same points"))
        self.beside.setMenu(self._beside_menu())
        self.legend = self._words("")
        self.count = self._words("muted")
        self.fault = self._words("warn")
        self.steps = QComboBox()
        self.steps.setAccessibleName(_("What is stepped"))
        self.steps.setToolTip(_("The algorithm that is stepped and shown as source"))
        self.steps.activated.connect(self._choose_steps)
        self.tolerance = number_field(numbers["tolerance_px"], _("Tolerance"), 0.05)
        self.tolerance.edited.connect(self._put_tolerance)
        self.tolerance.scrubbed.connect(lambda value: self._put_tolerance(value, "scrub"))
        self.tolerance.scrub_ended.connect(self._session.end_merge)
        first = QWidget()
        row = QHBoxLayout(first)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        self.degree.field.setFixedWidth(36)
        row.addWidget(self.degree)
        row.addWidget(self.closed)
        row.addStretch(1)
        row.addWidget(self.beside)
        kinds: list[QWidget] = [self.spline, first, self.rule, self.ends, *self.shape.values(), self.sign]
        kinds.append(self.joint)
        return [*kinds, self.legend, self.count, self.fault, self.steps, self.tolerance]

    def _choice(self, name: str, choices: Sequence[tuple[str, str]]) -> QComboBox:
        box = QComboBox()
        box.setAccessibleName(name)
        box.setToolTip(name)
        for value, title in choices:
            box.addItem(title, value)
        return box

    def _words(self, role: str) -> QLabel:
        label = QLabel()
        label.setWordWrap(True)
        label.setTextFormat(Qt.TextFormat.RichText)
        if role:
            label.setProperty("role", role)
        return label

    def _shape_field(self, name: str, number: Number) -> NumberField:
        meanings = {"alpha": _("Alpha: 0 uniform, 0.5 centripetal, 1 chordal")}
        field = number_field(number, meanings.get(name, number.label.capitalize()), 0.05)
        field.edited.connect(lambda value: self._put(name, value))
        field.scrubbed.connect(lambda value: self._put(name, value, "scrub"))
        field.scrub_ended.connect(self._session.end_merge)
        return field

    def _beside_menu(self) -> QMenu:
        menu = QMenu(self)
        self._kinds: dict[str, QAction] = {}
        for name in SPLINES:
            action = menu.addAction(f"{mark_of(name)}  {spline_title(name)}")
            action.setCheckable(True)
            action.triggered.connect(self._put_beside)
            self._kinds[name] = action
        return menu

    def _put_beside(self) -> None:
        self._put("beside", tuple(name for name, action in self._kinds.items() if action.isChecked()))

    # What is shown

    def numbers(self, sheet: Sheet, figure: AnyFigure) -> list[tuple[str, str, str]]:
        """Coordinates, weights and tangents of the chosen points; of no other figure more than usual."""
        if not isinstance(figure, Curve):
            return super().numbers(sheet, figure)
        listed = []
        for k in self.focus.numbers(figure)[:_MOST_CHOSEN]:
            place, name = f"{sheet.id}/{figure.id}/{figure.points_world[k].id}", point_name(figure, k)
            meanings = {"x": _("x of the {who}"), "y": _("y of the {who}")}
            if figure.spline == "nurbs":
                meanings["weight"] = _("Weight of {who}")
            if has_tangent(figure, k):
                meanings |= {"tangent_x": _("Tangent of {who}, x"), "tangent_y": _("Tangent of {who}, y")}
            for attribute, meaning in meanings.items():
                label = f"{numbers_of(CurvePoint)[attribute].symbol}_{name[1:]}"
                listed.append((f"{place}/{attribute}", label, meaning.format(who=name)))
        return listed

    def refresh(self, tool: FigureTool | None, figures: Sequence[AnyFigure], summary: str) -> None:
        """Show the one curve that is selected, or what the pen draws next."""
        self._pen = tool if isinstance(tool, PenTool) else None
        self._freehand = tool if isinstance(tool, FreehandTool) and not figures else None
        one = figures[0] if len(figures) == 1 else None
        curve = one if isinstance(one, Curve) else None
        self._offer_free_knots(curve is not None)
        model = curve or (self._pen.model if self._pen is not None and not figures else None)
        for field in (self.degree, self.tolerance, *self.shape.values()):
            field.belong_to(curve.id if curve is not None else "")
        first: tuple[QWidget, ...] = (
            self.spline,
            self.degree,
            self.closed,
            self.rule,
            self.ends,
            self.beside,
        )
        for widget in first:
            widget.setVisible(model is not None)
        # What is there is shown below: hidden and shown again, the card would be laid out twice
        absent: list[QWidget] = [] if model is not None else [*self.shape.values(), self.sign]
        if curve is None:
            absent += [self.joint, self.legend, self.count, self.fault, self.steps]
        for widget in absent:
            widget.setVisible(False)
        flattened = curve is not None and "tolerance" in _stepped(curve, self._session.state.subject.entry)
        self.tolerance.setVisible(flattened or self._freehand is not None)
        if self._freehand is not None:
            self.tolerance.set_value(self._freehand.tolerance)
        elif curve is not None:
            self.tolerance.set_value(curve.tolerance_px)
        if model is not None:
            self._show_model(model)
        if curve is not None:
            self._show_curve(curve)
        super().refresh(tool, figures, "")
        if curve is not None and not curve.name:
            self.title.setText(spline_title(curve.spline))
        elif self._pen is not None and not figures:
            self.title.setText(_("New curve"))

    def _show_model(self, model: Curve) -> None:
        self.spline.setCurrentIndex(self.spline.findData(model.spline))
        with_degree = model.spline in B_SPLINES
        self.degree.setVisible(with_degree)
        self.degree.set_value(model.degree)
        self.closed.setChecked(goes_round(model))
        self.closed.setEnabled(may_be_closed(model))
        self.rule.setVisible(with_degree)
        self.rule.setCurrentIndex(self.rule.findData(model.knot_rule))
        self.ends.setVisible(model.spline in NEIGHBOUR_SPLINES and not model.closed)
        self.ends.setCurrentIndex(self.ends.findData(model.ends))
        shaped_by = {
            "cardinal": ("tension",),
            "catmull_rom": ("alpha",),
            "kochanek_bartels": ("tension", "continuity", "bias"),
        }.get(model.spline, ())
        for name, field in self.shape.items():
            field.setVisible(name in shaped_by)
            field.set_value(getattr(model, name))
        self.sign.setVisible("continuity" in shaped_by)
        self.sign.setCurrentIndex(self.sign.findData(model.continuity_sign))
        for name, action in self._kinds.items():
            action.setChecked(name in model.beside)
            action.setVisible(name != model.spline)
        number = sum(name != model.spline for name in model.beside)
        self.beside.setText(str(number) if number else "")
        set_icon(self.beside, "stack")

    def _offer_free_knots(self, offered: bool) -> None:
        """Knots are freed of a curve that has some: what the pen draws next has none."""
        items = self.rule.model()
        assert isinstance(items, QStandardItemModel)
        items.item(KNOT_RULES.index("free")).setEnabled(offered)

    def _show_curve(self, curve: Curve) -> None:
        kinds = [name for name in curve.beside if name != curve.spline]
        now = tokens()
        lines = []
        for name in kinds:
            ink = ink_of(now, look_of(name)[0])
            fault = fault_of(curve, name)
            said = f": {escape(fault)}" if fault else ""
            lines.append(f'<span style="color:{ink}">{mark_of(name)}</span> {spline_title(name)}{said}')
        self.legend.setText("<br>".join(lines))
        self.legend.setVisible(bool(lines))
        self.count.setText(countings(curve))
        self.count.setVisible(True)
        texts = [(slug, _(catalogue.get(slug).title)) for slug in constructions_of(curve)]
        fill_choices(self.steps, texts, construction_of(curve, self._session.state.subject.entry))
        fault = fault_of(curve) or ("" if texts else construction_fault(curve, construction_of(curve)))
        self.fault.setText(f"\N{WARNING SIGN} {escape(fault)}")
        self.fault.setVisible(bool(fault))
        chosen = [k for k in self.focus.numbers(curve) if not is_handle(curve, k)]
        joined = curve.spline == "bezier_path" and bool(chosen)
        self.joint.setVisible(joined)
        if joined:
            self.joint.setCurrentIndex(self.joint.findData(curve.points_world[chosen[0]].joint))

    # What is set

    def _choose_steps(self) -> None:
        """Step another text; that of the curve's own kind goes with its kind."""
        self._session.choose(self.steps.currentData())

    def _put_tolerance(self, value: float, merge: str = "") -> None:
        """How far the chords of a curve, or the fit of a freehand line, may be off."""
        if self._freehand is not None:
            self._freehand.tolerance = value
        else:
            self._put("tolerance_px", value, merge)

    def _put(self, attribute: str, value: Value, merge: str = "") -> None:
        """Set an attribute of the selected curves, or of what is drawn next."""
        sheet, chosen = self._session.frames.sheet, set(self._session.state.selection)
        curves = [f for f in sheet.figures if f.id in chosen and isinstance(f, Curve)]
        if not curves:
            if self._pen is not None:
                self._pen.model = replace(self._pen.model, **{attribute: value})
                self.algorithm_chosen.emit(self._pen.algorithm)
            return
        edit = edit_of(sheet, curves, attribute, value)
        if refusal := self.apply(edit, _("Change curve"), merge and f"{merge} {attribute}"):
            self.fault.setText(f"\N{WARNING SIGN} {escape(refusal)}")
            self.fault.setVisible(True)


def edit_of(sheet: Sheet, curves: Sequence[Curve], attribute: str, value: Value) -> Edit:
    """The edit that sets an attribute of several curves."""
    if attribute in _EDITS:
        return both(*(_EDITS[attribute](curve.id, value) for curve in curves))
    return set_attributes({f"{sheet.id}/{curve.id}/{attribute}": value for curve in curves})


def countings(curve: Curve) -> str:
    """Points, degree, order and knots as the course counts them, and as most books do."""
    points = len(curve.points_world)
    if curve.spline in B_SPLINES:
        around = points + curve.degree if curve.closed else points
        try:
            found = counting(around, curve.degree)
            pieces = len(np.unique(pieces_of(curve).knots)) - 1
        except ValueError:
            return ""
        course = _("n + 1 = {points}, d = {d}, n + d + 1 = {knots} knots")
        usual = ngettext(
            "{points} points, degree {degree}, {pieces} piece",
            "{points} points, degree {degree}, {pieces} pieces",
            pieces,
        )
        return (
            course.format(points=found.points, d=found.d, knots=found.knots)
            + "<br>"
            + usual.format(points=found.points, degree=found.degree, pieces=pieces)
        )
    if curve.spline == "bezier":
        degree = points if curve.closed else points - 1
        return _("n + 1 = {points} points, degree n = {degree}").format(points=points, degree=degree)
    if curve.spline == "bezier_path":
        pieces = points // 3 if curve.closed else (points - 1) // 3
        text = ngettext(
            "{points} points and handles, {pieces} cubic piece",
            "{points} points and handles, {pieces} cubic pieces",
            pieces,
        )
        return text.format(points=points, pieces=pieces)
    pieces = points if goes_round(curve) else points - 1
    if ends_steer(curve):
        pieces = max(points - 3, 0)
    text = ngettext(
        "n + 1 = {points} points, {pieces} cubic piece",
        "n + 1 = {points} points, {pieces} cubic pieces",
        pieces,
    )
    return text.format(points=points, pieces=pieces)


def _stepped(curve: Curve, slug: str) -> tuple[str, ...]:
    """The names of what the stepped text of a curve takes."""
    return catalogue.get(construction_of(curve, slug)).parameter_names
