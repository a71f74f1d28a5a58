"""The window asks every panel the same, and mypy holds every one of them to it."""

import ast
import inspect

import pytest
from PySide6.QtWidgets import QApplication, QMenu

from workbench.document.samples.examples import example_document
from workbench.panels.panel import Panel
from workbench.session.session import Session
from workbench.shell import workspaces as module
from workbench.shell.workspaces import panel_class, panel_of, workspaces

NAMES = sorted({name for workspace in workspaces() for name in workspace.panels})
ASKED = [name for name in vars(Panel) if not name.startswith("_")]


def test_mypy_is_given_every_panel_that_a_workspace_has() -> None:
    source = ast.parse(inspect.getsource(module))
    (listed,) = (
        node.value
        for node in ast.walk(source)
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.target) == "PANELS"
    )
    assert isinstance(listed, ast.Tuple)
    given = {each.id for each in listed.elts if isinstance(each, ast.Name)}
    assert given == {name.partition(":")[2] for name in NAMES}


@pytest.mark.parametrize("name", NAMES)
def test_a_panel_answers_all_that_it_is_asked(qapp: object, name: str) -> None:
    session = Session(document=example_document())
    panel = panel_class(name)(session)
    given = {"point_at": (None,), "show_page": ("",), "offer_export": (QMenu(),)}
    for asked in sorted(set(ASKED) - {"show_example"}):  # after which the sheet is another
        answer = getattr(panel, asked)
        if inspect.isfunction(vars(Panel)[asked]):
            answer = answer(*given.get(asked, ()))
        assert asked not in ("copy", "paste") or isinstance(answer, bool)
    QApplication.clipboard().clear()
    assert panel.center is not None
    assert len({dock for dock, *_rest in panel.docks()}) == len(panel.docks())
    assert (panel.step_bar is not None) == (panel.pointing is not None) == name.endswith("InspectorPanel")
    assert len(panel.said()) == 2
    assert all(isinstance(title, str) for title, _table in panel.tables())
    assert list(panel.points()) == []
    panel.point_at((1, 2))
    assert panel_of([panel], type(panel)) is panel
    with pytest.raises(LookupError, match="no int here"):
        panel_of([panel], int)
    panel.show_example()
    assert (panel.example_wanted is not None) == name.endswith("InspectorPanel")
    for widget in (panel.center, *(dock for _name, _title, dock, _area in panel.docks())):
        widget.deleteLater()
    session.close()
