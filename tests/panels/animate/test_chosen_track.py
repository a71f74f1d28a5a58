"""Which track of a sheet is chosen, shown and stepped, when sheets and figures come and go."""

from tests.panels.by_hand import settle
from workbench.document.edits import add_sheet
from workbench.document.model import Line
from workbench.document.samples.examples import example
from workbench.panels.animate.panel import AnimatePanel


def target_of(panel: AnimatePanel, row: int) -> str:
    return panel.timeline.shown.tracks[row].target


def test_on_a_sheet_shown_again_the_step_is_that_of_its_frame(panel: AnimatePanel) -> None:
    session = panel.session
    ball = session.sheet.id
    session.frames.show(34)
    settle()
    aimed_at = session.state.subject, session.state.step
    assert aimed_at[1] == 7
    session.apply(add_sheet(example("animate-pendulum").document.sheets[0]), "Open example")
    session.show_sheet(next(sheet.id for sheet in session.document.sheets if sheet.id != ball))
    settle()
    session.show_sheet(ball)
    settle()
    assert session.frames.number == 34
    assert (session.state.subject, session.state.step) == aimed_at


def test_a_pasted_figure_has_a_name_of_its_own_in_the_timeline_and_its_track_is_chosen(
    panel: AnimatePanel,
) -> None:
    session = panel.session
    panel.timeline.track_chosen.emit(target_of(panel, 0))
    settle()
    assert panel.copy()
    assert panel.paste()
    settle()
    labels = [row.label for row in panel.timeline.shown.tracks]
    assert len(set(labels)) == len(labels)
    assert (labels[0], labels[5]) == ("Ball, y", "Ball 2, y")
    assert panel.timeline.shown.chosen == target_of(panel, 5)
    panel.timeline.track_chosen.emit(target_of(panel, 1))
    settle()
    assert panel.timeline.shown.chosen == target_of(panel, 1)
    still = next(figure.id for figure in session.sheet.figures if isinstance(figure, Line))
    session.update_state(active=still, selection=(still,))
    settle()
    assert panel.timeline.shown.chosen == target_of(panel, 1)
