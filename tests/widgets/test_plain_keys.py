"""A key with Ctrl or Alt is not the plain one: what does not know it leaves it to what stands around it."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from workbench.panels.space.scene_view import SceneView
from workbench.panels.transform.space_view import SpaceView
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.colour.solid_view import SolidView
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.timeline.curve_editor import CurveEditor
from workbench.widgets.timeline.easing_curve import EasingCurve
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.frames_view import FramesView
from workbench.widgets.timeline.key_editor import KeyEditor
from workbench.widgets.tube.gun_view import GunView
from workbench.widgets.tube.view import TubeView

NONE = Qt.KeyboardModifier.NoModifier
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
ALT, META = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.MetaModifier


MAKERS: dict[str, tuple[Callable[[], QWidget], str]] = {
    "scene": (SceneView, "5+-"),
    "frames": (lambda: FramesView(FrameAxis()), "CF[]+- "),
    "keys": (lambda: KeyEditor(FrameAxis(), ()), "CF[]+-"),
    "curve": (lambda: CurveEditor(FrameAxis(), ()), "HCF[]+-"),
    "easing": (EasingCurve, "\x16"),
    "canvas": (PixelCanvas, "C+-"),
    "solid": (lambda: SolidView("rgb"), "\x14"),
    "turning": (SpaceView, "\x14"),
    "tube": (lambda: TubeView("raster"), "\x14"),
    "gun": (GunView, "\x14"),
}
KEYS = {
    "+": Qt.Key.Key_Plus,
    "-": Qt.Key.Key_Minus,
    "[": Qt.Key.Key_BracketLeft,
    "]": Qt.Key.Key_BracketRight,
    " ": Qt.Key.Key_Space,
    "\x14": Qt.Key.Key_Right,
    "\x16": Qt.Key.Key_PageUp,
}


def takes(widget: QWidget, letter: str, held: Qt.KeyboardModifier) -> bool:
    key = KEYS.get(letter) or Qt.Key(ord(letter))
    text = "" if letter < " " or held & CTRL else letter
    event = QKeyEvent(QEvent.Type.KeyPress, key, held, text)
    QApplication.sendEvent(widget, event)
    return event.isAccepted()


@pytest.mark.parametrize("held", [CTRL, ALT, CTRL | SHIFT, ALT | SHIFT, META])
@pytest.mark.parametrize("name", list(MAKERS))
def test_a_plain_key_is_taken_and_the_same_with_another_held_is_left(
    qtbot: QtBot, name: str, held: Qt.KeyboardModifier
) -> None:
    make, letters = MAKERS[name]
    widget = make()
    qtbot.addWidget(widget)
    widget.resize(300, 200)
    for letter in letters:
        assert takes(widget, letter, NONE), letter
        assert not takes(widget, letter, held), letter


@pytest.mark.parametrize(
    ("held", "typed", "plain"),
    [
        (NONE, "[", True),
        (SHIFT, "+", True),
        (CTRL | ALT, "[", True),  # AltGr on Windows
        (CTRL | ALT, "\x06", False),
        (CTRL | ALT, "", False),
        (CTRL, "1", False),
        (ALT, "k", False),
    ],
)
def test_what_alt_gr_types_is_plain(held: Qt.KeyboardModifier, typed: str, plain: bool) -> None:
    assert is_plain(QKeyEvent(QEvent.Type.KeyPress, Qt.Key.Key_unknown, held, typed)) is plain
