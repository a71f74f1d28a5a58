"""What was typed for one thing is not given to another that a command shows in its place before Enter."""

from collections.abc import Callable
from typing import Any, NamedTuple

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.panels.by_hand import begin_number, keep_until_the_end, settle
from workbench.document.edits import add_figures
from workbench.document.model import AnyFigure, Curve, CurvePoint, Document, Line, SeedFill, WorldPoint
from workbench.document.samples.examples import blank_sheet, example
from workbench.document.sheet_edits import add_sheet
from workbench.document.transforms.links import Rotate, Translate
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.panels.space.panel import SpacePanel
from workbench.panels.transform.panel import TransformPanel
from workbench.panels.viewing.panel import ViewingPanel
from workbench.session.session import Session

PLACES = ((8.0, 8.0), (20.0, 30.0), (40.0, 12.0), (50.0, 30.0), (58.0, 9.0))


def two_of(figure: AnyFigure) -> Document:
    return add_figures("s1", (figure, figure))(blank_sheet(64, 48))


def two_sheets(slug: str) -> Document:
    document = example(slug).document
    return add_sheet(replace(document.sheets[0], id="", name="Another"))(document)


LINE = Line("", (WorldPoint("", 8, 8), WorldPoint("", 40, 20)), "bresenham_line", 1)
TURNED = replace(LINE, transforms=(Rotate("", angle=30.0),))
CURVE = Curve(
    "", tuple(CurvePoint("", *at) for at in PLACES), "bresenham_line", 1, spline="b_spline", degree=2
)
TENSE = replace(CURVE, spline="cardinal")
SEED = SeedFill("", (WorldPoint("", 30, 30),), "boundary_fill_4", 2, boundary=1)


# What is chosen in place of the first


def other_figure(session: Session) -> None:
    other = session.sheet.figures[1].id
    session.update_state(active=other, selection=(other,))


def other_sheet(session: Session) -> None:
    session.show_sheet(session.document.sheets[1].id)


def other_view(session: Session) -> None:
    subject, view = session.subject, session.sheet.views[1].id
    session.update_state(subject=replace(subject, arguments={**subject.arguments, "view": view}))


# Where something is typed


def with_box(panel: Any) -> Any:
    panel.choose_tool("select")
    panel.toggle_box()
    settle()
    return panel.card.form.fields


def first(fields: dict[str, Any]) -> Any:
    return next(iter(fields.values()))


def with_card(panel: Any) -> Any:
    card = panel.page_of("space").card
    card.set_open(True)
    return card


def matrix_cell(*rows: Any) -> QLineEdit:
    """The line over the first number of these rows that can be typed."""
    row, place = next((row, place) for row in rows for place in row.places if row.editable(place))
    row.edit(place)
    editor: QLineEdit = row.editor
    return editor


class Case(NamedTuple):
    """A panel over a document, the line that is typed into, what is chosen then, and what is typed."""

    panel: type
    document: Document
    line: Callable[[Any], QLineEdit]
    choose: Callable[[Session], None]
    text: str = "3"


HOUSE = two_sheets("space-house")
VIEWS = example("view-house").document
CASES = {
    "recursion limit": Case(
        FillPanel, two_of(SEED), lambda panel: panel.card.limit.field, other_figure, "300"
    ),
    "degree": Case(CurvesPanel, two_of(CURVE), lambda panel: panel.card.degree.field, other_figure),
    "tension": Case(
        CurvesPanel, two_of(TENSE), lambda panel: panel.card.shape["tension"].field, other_figure, "0.5"
    ),
    "coordinate": Case(DrawPanel, two_of(LINE), lambda panel: first(panel.card._fields).field, other_figure),
    "box": Case(DrawPanel, two_of(LINE), lambda panel: with_box(panel)["angle"].field, other_figure),
    "link": Case(
        TransformPanel, two_of(TURNED), lambda panel: panel.chain.cards[0].fields["angle"].field, other_figure
    ),
    "matrix of a chain": Case(
        TransformPanel,
        two_of(replace(LINE, transforms=(Translate("", tx=1.0),))),
        lambda panel: matrix_cell(*panel.matrices.views),
        other_figure,
    ),
    "clip window": Case(
        ClipPanel, two_sheets("clip"), lambda panel: panel.card.sides["xmin"].field, other_sheet
    ),
    "window": Case(
        ViewingPanel, VIEWS, lambda panel: panel.card.rectangles["window"].fields["xmin"].field, other_view
    ),
    "name of a view": Case(
        ViewingPanel, VIEWS, lambda panel: panel.card.views.lineEdit(), other_view, "Typed"
    ),
    "point": Case(ViewingPanel, VIEWS, lambda panel: panel.point.fields["x_v"].field, other_view),
    "device": Case(
        ViewingPanel,
        two_sheets("view-numbers"),
        lambda panel: panel.card.painting.sizes[0].field,
        other_sheet,
    ),
    "matrix of a view": Case(
        ViewingPanel, VIEWS, lambda panel: matrix_cell(panel.matrices.numbers), other_view
    ),
    "camera": Case(SpacePanel, HOUSE, lambda panel: with_card(panel).fields["eye.x"].field, other_sheet),
    "matrix of a camera": Case(
        SpacePanel, HOUSE, lambda panel: matrix_cell(panel.page_of("space").strip.row), other_sheet
    ),
    "correspondence": Case(
        AnimatePanel, two_sheets("animate-letter"), lambda panel: panel.morph.shift.field, other_sheet
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_was_typed_is_given_to_nothing_else(qtbot: QtBot, name: str) -> None:
    case = CASES[name]
    session = Session(document=case.document)
    panel = case.panel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(1000, 640)
    panel.show()
    qtbot.waitExposed(panel)
    figures = session.sheet.figures
    if case.choose is other_figure:
        session.update_state(active=figures[0].id, selection=(figures[0].id,))
    settle()
    line = case.line(panel)
    window = line.window()
    if window is not panel:
        qtbot.addWidget(window)
        window.resize(420, 600)
        window.show()
    settle()
    begin_number(qtbot, line, case.text)
    assert line.isModified()
    before = session.document
    case.choose(session)
    positions = session.state.positions
    session.flush()
    settle()
    if isValid(line) and line.hasFocus():
        qtbot.keyClick(line, Qt.Key.Key_Return)
    settle()
    unchanged = session.document == before
    assert unchanged
    assert session.state.positions == positions
    session.close()
