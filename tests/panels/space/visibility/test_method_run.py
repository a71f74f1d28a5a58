"""A method that keeps no depths, stepped on the page Visibility: its pixels, its gains and costs."""

import pytest
from msgspec.structs import replace

from tests.panels.by_hand import recorded, settle
from workbench.document.samples.examples import example
from workbench.document.subjects import Subject
from workbench.panels.space.visibility.depth_run import depth_run
from workbench.rendering.subjects.visibility import SURFACE_METHODS


def test_why_this_pixel_tells_what_the_painter_painted_there_and_over_what(qtbot, page, session):
    session.update_state(
        subject=Subject("visibility", entry="painter"), pixel=(23, 15), pixel_of="visibility"
    )
    recorded(qtbot, session)
    listed = [page.fragments.list.item(k).text() for k in range(page.fragments.list.count())]
    assert listed == [
        "Step 1: Triangle 1, painted.\nz = 0.5075, over the background.",
        "Step 2: Triangle 0, painted, and remains.\nz = 0.5200, over what is nearer, 0.5075.",
    ]
    assert "It was painted 2 times." in page.fragments.caption.text()
    page.fragments.list.itemClicked.emit(page.fragments.list.item(1))
    recorded(qtbot, session)
    assert session.run.number == 2
    assert page.fragments.list.currentRow() == 1
    assert page.derivation() is None  # which is that of the depth buffer


def test_why_this_pixel_tells_of_each_method_the_surface_that_it_shows(qtbot, page, session):
    shown_by = {"scan_line_surfaces": 0, "area_subdivision": 1, "ray_casting": 1}  # the first errs here
    for method, surface in shown_by.items():
        session.update_state(
            subject=Subject("visibility", entry=method), pixel=(28, 15), pixel_of="visibility"
        )
        recorded(qtbot, session)
        assert page.fragments.list.count() == 1
        assert f"Triangle {surface}, painted, and remains" in page.fragments.list.item(0).text()
    session.update_state(pixel=(0, 0), pixel_of="visibility")
    recorded(qtbot, session)
    assert page.fragments.list.count() == 0
    assert "No surface was painted there" in page.fragments.caption.text()


def test_asked_first_a_pixel_tells_only_of_steps_that_were_seen(qtbot, page, session):
    session.update_state(
        subject=Subject("visibility", entry="painter"), ask_first=True, pixel=(23, 15), pixel_of="visibility"
    )
    recorded(qtbot, session)
    assert page.fragments.list.count() == 0


def test_gains_and_costs_tell_of_the_method_that_is_stepped(qtbot, page, session):
    qtbot.addWidget(page.cost)
    page.cost.show()
    session.update_state(subject=Subject("visibility", entry="painter"))
    recorded(qtbot, session)
    qtbot.waitUntil(lambda: "Compares in" in page.cost.words.text(), timeout=20_000)
    words = page.cost.words.text()
    assert (
        "109 pixels show another surface than by ray casting: where the depths of surfaces overlap" in words
    )
    assert "2 surfaces; the depth buffer keeps 1,536 depths" in words
    assert "Drawn in the opposite order" not in words
    session.update_state(subject=Subject("visibility"))
    recorded(qtbot, session)
    qtbot.waitUntil(lambda: "Drawn in the opposite order" in page.cost.words.text(), timeout=20_000)


@pytest.mark.parametrize("method", SURFACE_METHODS)
@pytest.mark.parametrize(
    "before", [Subject("figure", ids=("f1",)), Subject("visibility", arguments={"columns": 96})]
)
def test_while_the_run_is_still_another_nothing_of_it_is_told(qtbot, page, session, before, method):
    line = example("line").document.sheets[0]
    scene = session.sheet
    session.apply(lambda document: replace(document, sheets=(replace(scene, figures=line.figures),)), "Both")
    session.update_state(subject=before, pixel=(23, 15), pixel_of="visibility")
    recorded(qtbot, session)
    session.run.go_to_number(session.run.total_steps)
    session.run.hold()
    session.update_state(subject=Subject("visibility", entry=method, arguments={"columns": 16}))
    settle()
    page.refresh()
    assert page.fragments.list.count() == 0
    told = page._told(depth_run(session))
    assert told.legend.startswith("0 ")
    session.run.go_on()
    settle()
    page.refresh()
    assert session.run.entry.slug == method
