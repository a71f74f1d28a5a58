"""The card that floats over the canvas: the few parameters of what is selected, or of what is drawn next."""

from collections.abc import Sequence
from contextlib import suppress

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QLabel,
    QWidget,
)

from workbench.algorithms import catalogue
from workbench.document.addresses import declared_at, resolve
from workbench.document.building import with_sheet
from workbench.document.edits import Edit, set_algorithm, set_attribute, set_sheet_size
from workbench.document.errors import DocumentError
from workbench.document.fields import Number, numbers_of
from workbench.document.model import (
    AnyFigure,
    Circle,
    Curve,
    Document,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    SeedFill,
    Sheet,
    WorldPoint,
)
from workbench.language import _
from workbench.panels.stage.chain_notes import ChainNotes
from workbench.panels.stage.folding_card import FoldingCard, fill_choices
from workbench.panels.stage.tools import FigureTool
from workbench.panels.stage.transform_form import TransformForm
from workbench.rendering import REACH_PX, reach_of
from workbench.session.session import Session
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.layouts import take_widgets
from workbench.widgets.look.tips import tell_choice

_MOST_POINTS = 6


def kind_title(figure: AnyFigure) -> str:
    """What kind of figure it is."""
    titles = {
        Line: _("Line"),
        Polyline: _("Polyline"),
        Polygon: _("Polygon"),
        Circle: _("Circle"),
        Ellipse: _("Ellipse"),
        Curve: _("Curve"),
    }
    return titles.get(type(figure), _("Fill"))


def number_field(number: Number, meaning: str, step: float = 1.0) -> NumberField:
    """A field for ``number`` as it is declared; ``meaning`` is what a person calls it here."""
    return NumberField(
        number.label,
        number.unit,
        low=number.low,
        high=number.high,
        step=step,
        integer=number.whole,
        meaning=meaning,
    )


def parameters(sheet: Sheet, figure: AnyFigure) -> list[tuple[str, str, str]]:
    """Address, label and meaning of each number of a figure that the card shows."""
    place = f"{sheet.id}/{figure.id}"
    centred = isinstance(figure, Circle | Ellipse)
    listed = []
    for k, point in enumerate(figure.points_world[:_MOST_POINTS]):
        mark = "c" if centred else "s" if isinstance(figure, SeedFill) else str(k)
        who = _("centre") if centred else _("seed") if mark == "s" else _("point {k}").format(k=k)
        for name, number in numbers_of(WorldPoint).items():
            meaning = _("{name} of the {who}").format(name=number.label, who=who)
            listed.append((f"{place}/{point.id}/{name}", f"{number.symbol}_{mark}", meaning))
    for name, number in numbers_of(type(figure)).items():
        if number.unit == "world":
            listed.append((f"{place}/{name}", number.symbol, number.label.capitalize()))
    return listed


def algorithm_choices(figure: AnyFigure | type[AnyFigure]) -> list[tuple[str, str]]:
    """Slug and title of every algorithm that can draw this kind of figure."""
    return [(slug, _(catalogue.get(slug).title)) for slug in figure.algorithms]


class ParameterCard(FoldingCard):
    """Shows and edits the selection of a session; ``algorithm_chosen`` is for what is drawn next."""

    side_by_side_changed = Signal(bool)
    algorithm_chosen = Signal(str)
    offers_algorithms = True
    offers_comparison = True

    def __init__(self, session: Session, canvas: CanvasSurface) -> None:
        super().__init__(canvas)
        self._session = session
        self._shown: tuple[object, ...] = ()
        self._fields: dict[str, NumberField] = {}
        self._size: tuple[NumberField, NumberField] | None = None
        self.algorithm = ChoiceBox()
        self.algorithm.setAccessibleName(_("Algorithm"))
        self.algorithm.setToolTip(_("The algorithm that draws it"))
        tell_choice(self.algorithm)
        self.algorithm.activated.connect(self._choose_algorithm)
        self.compare = ChoiceBox()
        self.compare.setAccessibleName(_("Compare with"))
        self.compare.setToolTip(_("A second algorithm on the same input"))
        tell_choice(self.compare)
        self.compare.activated.connect(self._choose_compare)
        self.side_by_side = QCheckBox(_("Side by side"))
        self.side_by_side.setToolTip(_("Two pictures side by side instead of one on top of the other"))
        self.side_by_side.toggled.connect(self.side_by_side_changed)
        self.summary = QLabel()
        self.summary.setTextFormat(Qt.TextFormat.RichText)
        self.summary.setWordWrap(True)
        self.trouble = QLabel()
        self.trouble.setWordWrap(True)
        self.trouble.setProperty("role", "warn")
        self.chain = ChainNotes()
        self.form = TransformForm()
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(12)
        self._grid.setVerticalSpacing(4)
        self.body.addWidget(self.algorithm)
        self.body.addLayout(self._grid)
        for widget in (self.form, self.chain, self.trouble, *self.more_rows()):
            self.body.addWidget(widget)
        for widget in (self.compare, self.side_by_side, self.summary):
            self.body.addWidget(widget)

    def more_rows(self) -> list[QWidget]:
        """What a panel adds under the numbers."""
        return []

    def numbers(self, sheet: Sheet, figure: AnyFigure) -> list[tuple[str, str, str]]:
        """Address, label and meaning of each number of the one figure that is selected."""
        return parameters(sheet, figure)

    def refresh(self, tool: FigureTool | None, figures: Sequence[AnyFigure], summary: str) -> None:
        """Show ``figures``, or with none selected what ``tool`` draws next and the sheet's size."""
        session = self._session
        sheet, state = session.sheet, session.state
        kinds = {type(figure) for figure in figures}
        one = figures[0] if len(figures) == 1 else None
        new_kind = tool.kind if tool is not None and not figures else None
        # While the box is there its own numbers take the place of those of the points.
        numbers = tuple(self.numbers(sheet, one)) if one and self.form.isHidden() else ()
        shape = (sheet.id, tuple(f.id for f in figures), numbers, new_kind, state.compare, bool(summary))
        if shape != self._shown:
            self._shown = shape
            self._rebuild(sheet, figures, numbers)
        if one is not None:
            self.title.setText(one.name or kind_title(one))
        elif figures:
            self.title.setText(_title_of_several(figures, sheet))
        else:
            new = _("New {what}").format(what=tool.title.lower()) if tool is not None else _("Sheet")
            self.title.setText(new)
        common = next(iter(kinds)) if len(kinds) == 1 else new_kind
        now = figures[0].drawn_with if figures else (tool.algorithm if tool is not None else "")
        offered = common is not None and self.offers_algorithms
        fill_choices(self.algorithm, algorithm_choices(common) if offered and common else [], now)
        compares = one is not None and self.offers_algorithms and self.offers_comparison
        others = [c for c in algorithm_choices(one) if c[0] != one.drawn_with] if compares and one else []
        fill_choices(
            self.compare,
            [("", _("Compare with nothing"))]
            + [(slug, _("Compare with {title}").format(title=title)) for slug, title in others]
            if others
            else [],
            state.compare,
        )
        self.chain.refresh(figures)
        self._say_trouble(sheet, figures)
        compared = bool(summary) and bool(others)
        self.side_by_side.setVisible(compared)
        self.summary.setVisible(compared)
        self.summary.setText(summary)
        document = self._document
        for address, field in self._fields.items():
            field.set_value(_number(document, address))
        if self._size is not None:
            self._size[0].set_value(sheet.width_px)
            self._size[1].set_value(sheet.height_px)
        self._fit()

    def _say_trouble(self, sheet: Sheet, figures: Sequence[AnyFigure]) -> None:
        """What is not drawn, and why."""
        far = [(reach, figure) for figure in figures if (reach := reach_of(sheet, figure)) > REACH_PX]
        unknown = next((figure for figure in figures if figure.algorithm != figure.drawn_with), None)
        self.trouble.setVisible(bool(far) or unknown is not None)
        if unknown is not None:
            sentence = _(
                "\N{WARNING SIGN} This {what} asks for “{slug}”, an algorithm that this version lacks. "
                "“{title}” draws it until you choose another; the file keeps the name."
            )
            title = _(catalogue.get(unknown.drawn_with).title)
            self.trouble.setText(
                sentence.format(what=kind_title(unknown).lower(), slug=unknown.algorithm, title=title)
            )
        if far:
            reach, figure = max(far, key=lambda each: each[0])
            sentence = _(
                "\N{WARNING SIGN} This {what} is not drawn: it reaches {reach:,.0f} pixels, and {most:,} is "
                "the most. Make it smaller, or bring it nearer."
            )
            self.trouble.setText(sentence.format(what=kind_title(figure).lower(), reach=reach, most=REACH_PX))

    def _rebuild(
        self, sheet: Sheet, figures: Sequence[AnyFigure], numbers: Sequence[tuple[str, str, str]]
    ) -> None:
        for widget in take_widgets(self._grid):
            widget.blockSignals(True)  # what was typed of a figure that is gone is for no other
            widget.hide()
            widget.deleteLater()
        self._fields, self._size = {}, None
        view = sheet.first_view
        pixels = view.window_world == view.viewport_device
        for k, (address, label, meaning) in enumerate(numbers):
            number = declared_at(self._session.document, address).kind
            unit = ("px" if pixels else "") if number.unit == "world" else number.unit
            field = NumberField(label, unit, meaning=meaning)
            field.edited.connect(lambda value, a=address: self._set(a, value))
            field.scrubbed.connect(lambda value, a=address: self._set(a, value, "scrub"))
            field.scrub_ended.connect(self._session.end_merge)
            self._fields[address] = field
            self._grid.addWidget(field, k // 2, k % 2)
        if not figures:
            declared = numbers_of(Sheet)
            self._size = (
                number_field(declared["width_px"], _("Width of the sheet")),
                number_field(declared["height_px"], _("Height of the sheet")),
            )
            for k, field in enumerate(self._size):
                field.edited.connect(lambda _value: self._set_size())
                field.scrubbed.connect(lambda _value: self._set_size("scrub"))
                field.scrub_ended.connect(self._session.end_merge)
                self._grid.addWidget(field, k, 0, 1, 2)

    @property
    def _document(self) -> Document:
        """With the sheet as it is in the frame that is shown."""
        return with_sheet(self._session.document, self._session.frames.sheet)

    def apply(self, edit: Edit, name: str, merge: str = "") -> str:
        """Do an edit; the sentence that says why it was refused, or an empty one."""
        try:
            self._session.apply(edit, name, merge)
        except DocumentError as problem:
            return problem.short
        return ""

    def _set(self, address: str, value: float, merge: str = "") -> None:
        refusal = self.apply(set_attribute(address, value), _("Change value"), merge and f"{merge} {address}")
        if refusal and address in self._fields:
            with suppress(DocumentError):  # the figure has gone, and its field is about to
                self._fields[address].refuse(refusal, _number(self._document, address))

    def _set_size(self, merge: str = "") -> None:
        assert self._size is not None
        width, height = (int(field.value()) for field in self._size)
        edit = set_sheet_size(self._session.sheet.id, width, height)
        if refusal := self.apply(edit, _("Change sheet size"), merge and f"{merge} size"):
            self._size[0].refuse(refusal, self._session.sheet.width_px)

    def _choose_algorithm(self, index: int) -> None:
        slug = self.algorithm.itemData(index)
        selection = self._session.state.selection
        if not selection:
            self.algorithm_chosen.emit(slug)
        elif refusal := self.apply(set_algorithm(selection, slug), _("Change algorithm")):
            # What is selected is another kind since the list was opened.
            self.trouble.setText(f"\N{WARNING SIGN} {refusal}")
            self.trouble.show()
        elif self._session.state.compare == slug:
            self._session.update_state(compare="")

    def _choose_compare(self, index: int) -> None:
        self._session.update_state(compare=self.compare.itemData(index))


def _number(document: Document, address: str) -> float:
    return round(float(resolve(document, address)), 6)


def _title_of_several(figures: Sequence[AnyFigure], sheet: Sheet) -> str:
    """How many they are, and whether they are one whole group."""
    groups = {figure.group for figure in figures}
    one_group = len(groups) == 1 and groups != {0}
    if one_group and len(sheet.together([figures[0].id])) == len(figures):
        return _("Group of {n} figures").format(n=len(figures))
    return _("{n} figures").format(n=len(figures))
