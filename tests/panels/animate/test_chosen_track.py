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


def test_at_a_new_key_panel_hand_table_and_page_are_of_the_same_two_keys(panel: AnimatePanel) -> None:
    session = panel.session
    target = next(row.target for row in panel.timeline.shown.tracks if row.label == "Ball, y")
    panel.timeline.track_chosen.emit(target)
    session.frames.show(34)
    settle()
    assert "frame 28 to 40" in panel.between.title.text()
    panel.timeline.key_wanted.emit(target, 34)
    settle()
    settle()
    run = session.run
    assert run.steps is not None
    rows = [run.steps[number].row for number in range(1, len(run.steps) + 1)]
    assert (rows[0][1], rows[-1][1]) == (28, 34)
    assert "frame 28 to 34" in panel.between.title.text()
    assert panel.between.key is not None
    assert panel.between.key.frame == 28
    session.frames.show(35)
    settle()
    session.frames.show(34)  # come to from the other side, it begins the next two
    settle()
    rows = [run.steps[number].row for number in range(1, len(run.steps) + 1)]
    assert (rows[0][1], rows[-1][1]) == (34, 40)
    assert "frame 34 to 40" in panel.between.title.text()


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
