"""Variables and structures share their room, and where that is low they are tabs."""

import pytest
from pytestqt.qtbot import QtBot

from tests.widgets.stepping.test_stepping import follow
from workbench.algorithms import catalogue
from workbench.session.run import Run
from workbench.widgets.tables.structure_table import StructureTable
from workbench.widgets.tables.values import Values
from workbench.widgets.tables.variable_table import VariableTable


@pytest.fixture
def views(qtbot: QtBot) -> tuple[Run, VariableTable, StructureTable, Values]:
    run = Run()
    variables, structures = VariableTable(run), StructureTable(run)
    values = Values(variables, structures)
    qtbot.addWidget(values)
    values.show()
    return run, variables, structures, values


def test_in_a_low_room_they_are_tabs_with_the_structures_in_front(
    views: tuple[Run, VariableTable, StructureTable, Values], qtbot: QtBot
) -> None:
    run, variables, structures, values = views
    follow(qtbot, run, "scan_line_fill", *catalogue.get("scan_line_fill").example)
    values.resize(300, 500)
    assert (variables.isVisible(), structures.isVisible(), values.tabs.isVisible()) == (True, True, False)
    values.resize(300, 190)
    assert (variables.isVisible(), structures.isVisible(), values.tabs.isVisible()) == (False, True, True)
    values.show_variables()
    assert (variables.isVisible(), structures.isVisible()) == (True, False)
    values.resize(300, 500)
    assert (variables.isVisible(), structures.isVisible(), values.tabs.isVisible()) == (True, True, False)


def test_without_structures_there_are_only_variables(
    views: tuple[Run, VariableTable, StructureTable, Values], qtbot: QtBot
) -> None:
    run, variables, structures, values = views
    values.resize(300, 120)
    for slug, some in (("bresenham_line", False), ("boundary_fill_4", True), ("bresenham_line", False)):
        follow(qtbot, run, slug, *catalogue.get(slug).example)
        assert (structures.isVisible(), values.tabs.isVisible()) == (some, some)
        assert variables.isVisible() != some
