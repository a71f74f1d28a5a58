"""The card of the Fill panel: beside the numbers the rules, the colours, the limit of recursion, and what is
wrong with a seed, said in place.
"""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QLabel, QWidget

from workbench.algorithms import catalogue
from workbench.algorithms.entry import CALLS
from workbench.document.edits import set_attributes
from workbench.document.fields import numbers_of
from workbench.document.model import AnyFigure, Polygon, SeedFill
from workbench.language import _
from workbench.panels.fill.tools import SeedTool, seed_problem, stops_at_boundary
from workbench.panels.stage.card import ParameterCard, number_field
from workbench.panels.stage.gesture import snapped
from workbench.panels.stage.picture import themed
from workbench.panels.stage.tools import FigureTool
from workbench.rendering import figure_map
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.swatches import Swatches
from workbench.widgets.look.tokens import tokens


class FillCard(ParameterCard):
    """``heat_changed``: how often each pixel was tested is to be shown, or no more."""

    heat_changed = Signal(bool)

    def more_rows(self) -> list[QWidget]:
        """Rules of a polygon, colours, recursion limit, heat map, and what is wrong."""
        self.extent = ChoiceBox()
        self.extent.setAccessibleName(_("Which boundary pixels belong to it"))
        self.extent.setToolTip(
            _("Half-open: areas side by side neither overlap nor leave a gap. Closed: boundary included.")
        )
        self.extent.addItem(_("Half-open"), False)
        self.extent.addItem(_("Closed, with its boundary"), True)
        self.extent.activated.connect(lambda: self._put("closed_interior", self.extent.currentData()))
        self.interior = ChoiceBox()
        self.interior.setAccessibleName(_("What is inside"))
        self.interior.setToolTip(_("How crossings decide what is inside"))
        self.interior.addItem(_("Inside: even-odd"), False)
        self.interior.addItem(_("Inside: nonzero winding"), True)
        self.interior.activated.connect(lambda: self._put("nonzero", self.interior.currentData()))
        self.colours = Swatches(_("Colour"))
        self.colours.chosen.connect(lambda index: self._put("colour", index))
        self.boundary = Swatches(_("Boundary"))
        self.boundary.chosen.connect(lambda index: self._put("boundary", index))
        self.limit = number_field(numbers_of(SeedFill)["recursion_limit"], _("Recursion limit"), 10)
        self.limit.edited.connect(lambda value: self._put("recursion_limit", int(value)))
        self.limit.scrubbed.connect(lambda value: self._put("recursion_limit", int(value), "scrub"))
        self.limit.scrub_ended.connect(self._session.end_merge)
        self.heat = QCheckBox()
        self.say_heat(0)
        self.heat.setToolTip(_("Colours and numbers each pixel by how often it has been tested so far"))
        self.heat.toggled.connect(self.heat_changed)
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setProperty("role", "error")
        self.verdict = QLabel()
        self.verdict.setWordWrap(True)
        self.verdict.hide()
        self._tool: FigureTool | None = None
        rules: list[QWidget] = [self.extent, self.interior, self.colours, self.boundary, self.limit]
        return [*rules, self.heat, self.verdict, self.note]

    def refresh(self, tool: FigureTool | None, figures: Sequence[AnyFigure], summary: str) -> None:
        """Show ``figures``, or with none selected what ``tool`` draws next and the sheet's size."""
        self._tool = tool
        sheet = self._session.sheet
        polygons = [f for f in figures if isinstance(f, Polygon)]
        fills = [f for f in figures if isinstance(f, SeedFill)]
        seed = tool if isinstance(tool, SeedTool) and not figures else None
        for box, name in ((self.extent, "closed_interior"), (self.interior, "nonzero")):
            box.setVisible(bool(polygons) and len(polygons) == len(figures))
            if polygons:
                box.setCurrentIndex(int(getattr(polygons[0], name)))
        colour = figures[0].colour if figures else getattr(tool, "colour", None)
        self.colours.setVisible(colour is not None)
        shown = self._palette()
        if colour is not None:
            self.colours.show_colours(shown, colour, sheet.background)
        kind: SeedFill | SeedTool | None = fills[0] if len(fills) == 1 == len(figures) else seed
        slug = kind.drawn_with if isinstance(kind, SeedFill) else kind.algorithm if kind is not None else ""
        entry = catalogue.get(slug) if slug else None
        self.limit.belong_to(fills[0].id if kind in fills else "")
        self.boundary.setVisible(entry is not None and stops_at_boundary(entry.slug))
        self.limit.setVisible(entry is not None and entry.stack == CALLS)
        if kind is not None:
            self.boundary.show_colours(shown, kind.boundary, sheet.background)
            self.limit.set_value(kind.recursion_limit)
        self.heat.setVisible(isinstance(self._session.active_figure, SeedFill) and not summary)
        self._say(self._problem(fills[0]) if len(fills) == 1 == len(figures) else "")
        super().refresh(tool, figures, summary)

    def _palette(self) -> tuple[int, ...]:
        """The sheet's colours as the theme shows them."""
        return themed(self._session.sheet, tokens()).palette

    def _problem(self, fill: SeedFill) -> str:
        sheet = self._session.sheet
        seed = snapped(*figure_map(sheet, fill).point(fill.points_world[0].x, fill.points_world[0].y))
        place = sheet.place_of(fill.id)
        return seed_problem(self._session, seed, fill.drawn_with, fill.colour, fill.boundary, place)

    def say_verdict(self, sentence: str) -> None:
        """What the inside-outside test found."""
        self.verdict.setText(sentence)
        self.verdict.setVisible(bool(sentence))

    def say_heat(self, passed: int) -> None:
        """What is counted: all tests, or those after so many steps, which are not recorded."""
        text = _("Tests after step {n:,}") if passed else _("Tests of each pixel")
        self.heat.setText(text.format(n=passed))

    def say_overflow(self, sentence: str) -> None:
        """What is said of a run that came to no end; nothing takes the place of what is wrong with a seed."""
        if sentence:
            self._say(sentence)

    def _say(self, sentence: str) -> None:
        self.note.setText(sentence)
        self.note.setVisible(bool(sentence))

    def _put(self, attribute: str, value: bool | int, merge: str = "") -> None:
        """Set an attribute of what is selected, or of what is drawn next."""
        sheet = self._session.sheet
        chosen = set(self._session.state.selection)
        figures = [f for f in sheet.figures if f.id in chosen and hasattr(f, attribute)]
        if not figures:
            if self._tool is not None and hasattr(self._tool, attribute):
                setattr(self._tool, attribute, value)
                self.algorithm_chosen.emit(self._tool.algorithm)
            return
        edit = set_attributes({f"{sheet.id}/{figure.id}/{attribute}": value for figure in figures})
        if refusal := self.apply(edit, _("Change value"), merge and f"{merge} {attribute}"):
            self._say(refusal)
