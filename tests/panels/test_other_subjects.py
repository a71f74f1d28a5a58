"""A panel that is still seen while the subject of another workspace is stepped takes nothing amiss."""

import inspect

import pytest

from tests.panels.by_hand import keep_until_the_end, settle
from tests.panels.test_panel import NAMES, panel_class
from workbench.document.samples.examples import examples
from workbench.session.session import Session

ENDS = {each.workspace: each.slug for each in (*examples(), *reversed(examples()))}
TELLING = dict.fromkeys(
    (*ENDS.values(), *{each.workspace: each.slug for each in examples()}.values(), "triangle")
)


@pytest.mark.parametrize("name", [each for each in NAMES if "shared" not in each])
def test_a_panel_is_refreshed_under_the_subject_of_every_workspace(qtbot, name: str) -> None:
    session = Session()
    session.open_example("line")
    panel = panel_class(name)(session)
    keep_until_the_end(qtbot, panel.center)
    keep_until_the_end(qtbot, panel)
    panel.center.resize(900, 560)
    panel.center.show()
    refresh = next(
        (getattr(panel, each) for each in ("refresh", "refresh_soon") if hasattr(panel, each)), None
    )
    for slug in TELLING:
        session.open_example(slug)
        settle()
        session.run.go_to_number(3)
        if refresh is not None and not inspect.signature(refresh).parameters:
            refresh()
        settle()
    session.close()
