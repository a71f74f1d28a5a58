"""What cannot be is said where it is tried, and nothing is lost."""

import msgspec
import pytest
from PySide6.QtCore import Qt

from tests.panels.animate.test_animate import frame_place, key_place
from tests.panels.by_hand import LEFT, settle
from workbench.document.edits import remove_figures
from workbench.document.errors import DocumentError
from workbench.document.motion import edits
from workbench.document.motion.evaluation import Floats
from workbench.document.motion.groups import Group
from workbench.document.motion.model import MAX_FRAMES, Track
from workbench.document.motion.tracks import motion_of
from workbench.document.state import SessionState
from workbench.document.storage.files import Stored, decode, encode
from workbench.panels.animate.panel import AnimatePanel


@pytest.fixture
def said(panel: AnimatePanel) -> list[str]:
    sentences: list[str] = []
    panel.hover_text.connect(sentences.append)
    return sentences


@pytest.mark.parametrize(
    ("field", "text", "sentence"),
    [
        ("rate", "0", "The rate is 0.0; give a number between 0.1 and 240."),
        ("rate", "inf", "The rate is inf; give a finite number."),
        ("rate", "", "“” is not a number; type one such as 24."),
        ("length", "-1", "The last frame cannot be -1; give a whole number from 0 to 999999."),
        ("length", "1000000", "The last frame cannot be 1000000; give a whole number from 0 to 999999."),
        ("length", "2.5", "The last frame cannot be 2.5; give a whole number from 0 to 999999."),
        ("frame", "-3", "A frame is a whole number from 0; type one."),
    ],
)
def test_what_is_typed_wrong_is_said_and_changes_nothing(
    qtbot, panel: AnimatePanel, said: list[str], field: str, text: str, sentence: str
) -> None:
    before = panel.session.document
    entry = getattr(panel.transport, field)
    shown = entry.text()
    entry.setFocus()
    entry.clear()
    qtbot.keyClicks(entry, text)
    qtbot.keyClick(entry, Qt.Key.Key_Return)
    if not text:  # an entry without words counts as changed, too
        assert entry.text() == shown
    settle()
    assert sentence in said
    assert panel.session.document is before
    assert entry.text() == shown


def test_keys_scaled_onto_one_frame_are_refused_and_all_stay(
    qtbot, panel: AnimatePanel, said: list[str]
) -> None:
    before = panel.session.document
    row = panel.timeline.shown.tracks[2]
    panel.pages.axis.choose([key.id for key in row.keys[1:4]])  # frames 14, 16 and 18
    start, end = key_place(panel, 2, 3), frame_place(panel, 2, 14)
    qtbot.mousePress(panel.timeline, LEFT, Qt.KeyboardModifier.ControlModifier, start)
    qtbot.mouseMove(panel.timeline, end)
    qtbot.mouseRelease(panel.timeline, LEFT, Qt.KeyboardModifier.ControlModifier, end)
    settle()
    assert any("would land on the same frame; scale them less" in sentence for sentence in said)
    assert panel.session.document == before


def test_a_handle_beside_the_curve_never_runs_back_in_time(
    qtbot, panel: AnimatePanel, said: list[str]
) -> None:
    curve = panel.between.curve
    curve.resize(200, 180)
    assert curve.handles is not None
    qtbot.mousePress(curve, LEFT, pos=curve.place(*curve.handles[:2]).toPoint())
    qtbot.mouseMove(curve, curve.place(-0.4, 0.5).toPoint())
    qtbot.mouseRelease(curve, LEFT, pos=curve.place(-0.4, 0.5).toPoint())
    settle()
    assert motion_of(panel.session.sheet).tracks[0].keys[0].x1 == 0.0
    assert any("would go back in time" in sentence for sentence in said)


def _file(panel: AnimatePanel, old: bytes, new: bytes) -> bytes:
    content = msgspec.json.format(encode(Stored(panel.session.document, SessionState())), indent=-1)
    assert content.count(old) >= 1
    return content.replace(old, new, 1)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b'"frame":16', b'"frame":0', "not after 0, the key before it"),
        (b'"easing":"ease_in"', b'"easing":"bezier","x1":1.5', "between 0 and 1"),
        (b'"easing":"ease_in"', b'"easing":"bezier","x2":-0.5', "between 0 and 1"),
        (b'"frames":59', b'"frames":1000001', "between 1 and 1000000"),
        (b'"rate":24.0', b'"rate":0', "between 0.1 and 240"),
    ],
)
def test_a_file_with_it_is_refused_in_words(panel: AnimatePanel, old: bytes, new: bytes, words: str) -> None:
    with pytest.raises(DocumentError, match=words):
        decode(_file(panel, old, new))


def test_a_key_on_what_was_removed_is_said(panel: AnimatePanel, said: list[str]) -> None:
    session = panel.session
    target, before = panel.timeline.shown.tracks[0].target, motion_of(session.sheet).tracks
    session.apply(remove_figures([session.sheet.figures[-1].id]), "elsewhere")
    panel.timeline.key_wanted.emit(target, 12)
    settle()
    assert any("This cannot be keyed" in sentence for sentence in said)
    assert motion_of(session.sheet).tracks == ()
    session.undo_stack.undo()
    settle()
    assert motion_of(session.sheet).tracks == before


def test_a_million_frames_are_shown_and_the_speed_is_evened_without_looking_at_each(
    qtbot, panel: AnimatePanel, monkeypatch: pytest.MonkeyPatch
) -> None:
    looked: list[int] = []
    whole = edits.values_along

    def watched(track: Track, frames: Floats, group: Group) -> Floats:
        looked.append(len(frames))
        return whole(track, frames, group)

    monkeypatch.setattr(edits, "values_along", watched)
    panel.transport.length.setText(str(MAX_FRAMES - 1))
    panel.transport.length.setModified(True)
    panel.transport.length.editingFinished.emit()
    settle()
    track = panel.timeline.shown.tracks[0]
    panel.pages.axis.choose([track.keys[-1].id])
    panel.keys.drag(MAX_FRAMES)
    panel.keys.drop()
    settle()
    assert motion_of(panel.session.sheet).tracks[0].keys[-1].frame == 58  # there is no frame 1000058
    panel.keys.drag(MAX_FRAMES - 59)
    panel.keys.drop()
    settle()
    panel.keys.even_speed(track.target)
    settle()
    keys = motion_of(panel.session.sheet).tracks[0].keys
    assert (keys[0].frame, keys[-1].frame) == (0, MAX_FRAMES - 1)
    assert len({key.frame for key in keys}) == 6
    assert looked
    assert max(looked) < 20_100
    assert not panel.grab().isNull()
