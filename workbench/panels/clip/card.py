"""The card of the Clip panel: the window's sides, the clippers, what became of the lines."""

from collections.abc import Sequence

from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QPushButton, QWidget

from workbench.algorithms import catalogue
from workbench.document.edits import set_clip, set_clipper
from workbench.document.fields import numbers_of
from workbench.document.model import LINE_CLIPPERS, POLYGON_CLIPPERS, AnyFigure, Polygon, Rectangle
from workbench.language import _, ngettext
from workbench.panels.clip.scene import Fate, degenerate_count, tally
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.extent import no_extent
from workbench.panels.stage.folding_card import fill_choices
from workbench.panels.stage.tools import FigureTool
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.tokens import tokens

_SIDES = ("xmin", "xmax", "ymin", "ymax")


class ClipCard(ParameterCard):
    """Shows and edits the clip window, the clippers, and the numbers of what is selected."""

    offers_algorithms = False
    window_wanted = Signal()

    def more_rows(self) -> list[QWidget]:
        """The window, the clippers, the codes, and the outcome."""
        self.sides: dict[str, NumberField] = {}
        self.window_fields = QWidget()
        grid = QGridLayout(self.window_fields)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(4)
        for k, name in enumerate(_SIDES):
            label = numbers_of(Rectangle)[name].symbol
            field = NumberField(label, "px", meaning=_("{side} of the clip window").format(side=label))
            field.edited.connect(lambda value, side=name: self._set_side(side, value))
            field.scrubbed.connect(lambda value, side=name: self._set_side(side, value, "scrub"))
            field.scrub_ended.connect(self._session.end_merge)
            self.sides[name] = field
            grid.addWidget(field, k // 2, k % 2)
        self.complaint = QLabel()
        self.complaint.setWordWrap(True)
        self.complaint.setProperty("role", "error")
        self.complaint.hide()
        grid.addWidget(self.complaint, 2, 0, 1, 2)
        self.clipper = ChoiceBox()
        self.clipper.setAccessibleName(_("Clipping algorithm"))
        self.clipper.activated.connect(self._choose_clipper)
        self.codes = QCheckBox(_("Region codes"))
        self.codes.setChecked(True)
        self.codes.setToolTip(_("The nine regions and the ends with their codes: top, bottom, right, left"))
        self.outcome = QLabel()
        self.outcome.setWordWrap(True)
        self.missing = QLabel(_("This sheet has no clip window yet. Drag one on the canvas."))
        self.missing.setWordWrap(True)
        self.add = QPushButton(_("Add a window"))
        self.add.setToolTip(_("Put a clip window over the middle of the sheet"))
        self.add.clicked.connect(self.window_wanted)
        return [self.window_fields, self.missing, self.add, self.clipper, self.codes, self.outcome]

    def refresh(self, tool: FigureTool | None, figures: Sequence[AnyFigure], summary: str) -> None:
        """Show what is selected, or what ``tool`` draws next, and the window."""
        for field in self.sides.values():
            field.belong_to(self._session.sheet.id)
        super().refresh(tool, figures, summary)
        for field in self._size or ():
            field.hide()
        if not figures and tool is None:
            self.title.setText(_("Clip window"))
        sheet = self._session.sheet
        there = sheet.first_view.clip_world is not None
        for widget in (self.window_fields, self.clipper, self.codes):
            widget.setVisible(there)
        for widget in (self.missing, self.add):
            widget.setVisible(not there)
        if sheet.first_view.clip_world is not None:
            for name, field in self.sides.items():
                field.set_value(round(getattr(sheet.first_view.clip_world, name), 6))
            if not no_extent(sheet.first_view.clip_world) and not any(
                field.field.isModified() for field in self.sides.values()
            ):
                self.complaint.hide()
        active = figures[0] if figures else self._session.frames.figure
        if there:
            self._fill_clippers(tool.kind if tool is not None and not figures else type(active))
        self._tell(active)
        self._fit()

    def _fill_clippers(self, kind: type) -> None:
        """The clippers of lines, or of polygons; points have but one."""
        sheet = self._session.sheet
        polygons = issubclass(kind, Polygon)
        slugs = POLYGON_CLIPPERS if polygons else LINE_CLIPPERS
        choices = [(slug, _(catalogue.get(slug).title)) for slug in slugs]
        fill_choices(
            self.clipper, choices, sheet.polygons_clipped_with if polygons else sheet.lines_clipped_with
        )
        tip = _("The algorithm that clips polygons") if polygons else _("The algorithm that clips lines")
        self.clipper.setToolTip(tip)

    def _tell(self, active: AnyFigure | None) -> None:
        now = tokens()
        sheet = self._session.frames.sheet
        counted = tally(sheet)
        marks: dict[Fate, tuple[str, str, str]] = {
            "accepted": ("data3", "━━", _("{n} inside, accepted")),
            "clipped": ("data1", "━ ╌", _("{n} clipped")),
            "rejected": ("data4", "┈┈", _("{n} outside, rejected")),
        }
        lines = [
            f'<span style="color:{ink_of(now, ink)}">{mark}</span>&nbsp; {text.format(n=counted[fate])}'
            for fate, (ink, mark, text) in marks.items()
            if counted[fate]
        ]
        if edges := degenerate_count(sheet, active):
            said = ngettext(
                "{n} degenerate edge: the polygon is concave, and its parts are joined along the window.",
                "{n} degenerate edges: the polygon is concave, and its parts are joined along the window.",
                edges,
            )
            lines.append(f'<span style="color:{now.error}">▪┈▪</span>&nbsp; {said.format(n=edges)}')
        self.outcome.setText("<br>".join(lines))
        self.outcome.setVisible(bool(lines))

    def _set_side(self, side: str, value: float, merge: str = "") -> None:
        sheet = self._session.sheet
        window = sheet.first_view.clip_world
        if window is None:
            return
        wanted = replace(window, **{side: value})
        sentence = no_extent(wanted)
        if not sentence:
            name = _("Change the clip window")
            sentence = self.apply(set_clip(sheet.first_view.id, wanted), name, merge and f"{merge} {side}")
        self.complaint.setText(sentence)
        self.complaint.setVisible(bool(sentence))
        self.sides[side].field.setAccessibleDescription(sentence)
        if sentence:
            self.sides[side].field.setModified(True)
        self._fit()

    def _choose_clipper(self, index: int) -> None:
        slug = self.clipper.itemData(index)
        session = self._session
        slugs = [self.clipper.itemData(k) for k in range(self.clipper.count())]
        self.apply(set_clipper(session.sheet.id, slug), _("Choose the clipper"))
        if session.state.compare == slug:
            session.update_state(compare=next(other for other in slugs if other != slug))
