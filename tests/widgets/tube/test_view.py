"""The tube as a widget: still when nothing changes, moving when asked, flickering only when asked."""

from collections.abc import Iterator
from fractions import Fraction
from threading import Event, current_thread, main_thread

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from workbench.display import vector_beam as beam_module
from workbench.display.raster_beam import RasterBeam
from workbench.display.setup import TubeSetup, mm_of, raster_tube
from workbench.display.tube import Tube
from workbench.display.vector_beam import VectorBeam
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.tokens import DARK, LIGHT, theme
from workbench.widgets.tube import live_tube
from workbench.widgets.tube import view as view_module
from workbench.widgets.tube.view import TubeView


@pytest.fixture(autouse=True)
def _as_it_was() -> Iterator[None]:
    yield
    comfort.set_calm(True)
    theme.use(LIGHT)


def image(column: int = 8) -> np.ndarray:
    made = np.zeros((12, 16), dtype=np.uint32)
    made[:, column] = 0xFFFFFF
    return made


@pytest.fixture
def raster(qtbot: QtBot) -> TubeView:
    view = TubeView("raster")
    qtbot.addWidget(view)
    view.resize(300, 260)
    view.set_image(image())
    with qtbot.waitExposed(view):
        view.show()
    return view


def brightness(view: TubeView) -> np.ndarray:
    picture = view.grab().toImage()
    glass = view._glass.toAlignedRect()
    middle = glass.center().y() + 7
    return np.array([picture.pixelColor(x, middle).lightness() for x in range(glass.left(), glass.right())])


def test_a_calm_picture_comes_to_rest(qtbot: QtBot, raster: TubeView) -> None:
    qtbot.waitUntil(lambda: not raster.running, timeout=4000)
    driver = raster.driver
    assert driver is not None
    assert driver.steady
    assert raster.averaged
    assert brightness(raster).max() > 100


def test_a_new_picture_shows_and_comes_to_rest_again(qtbot: QtBot, raster: TubeView) -> None:
    before = int(brightness(raster).argmax())
    raster.set_image(image(3))
    assert raster.running
    qtbot.waitUntil(lambda: not raster.running, timeout=4000)
    assert int(brightness(raster).argmax()) < before - 20


def test_a_paused_or_hidden_tube_does_not_run(qtbot: QtBot, raster: TubeView) -> None:
    raster.set_slow_motion(1000.0)
    assert raster.running
    raster.set_paused(True)
    assert not raster.running
    raster.set_paused(False)
    assert raster.running
    raster.hide()
    assert not raster.running


def test_slow_motion_moves_the_beam_by_the_slowed_time(qtbot: QtBot, raster: TubeView) -> None:
    raster.set_slow_motion(1000.0)
    assert not raster.averaged
    before = raster.seconds()
    qtbot.waitUntil(lambda: raster.seconds() > before, timeout=4000)
    raster.set_paused(True)
    after = raster.seconds()
    assert isinstance(after, Fraction)
    assert 0 < after - before < Fraction(5, 1000)


def test_flicker_is_shown_only_when_asked_for(raster: TubeView) -> None:
    raster.set_slow_motion(6.0)
    assert raster.averaged  # ten pictures a second would flash
    comfort.set_calm(False)
    assert not raster.averaged
    comfort.set_calm(True)
    raster.set_slow_motion(30.0)
    assert not raster.averaged


def test_a_step_moves_on_exactly(raster: TubeView) -> None:
    raster.set_paused(True)
    assert raster.driver is not None
    before = raster.seconds()
    raster.step(Fraction(1, 1_000_003))
    assert raster.seconds() - before == Fraction(1, 1_000_003)


def light_at(view: TubeView, x: int, y: int) -> float:
    """Luminance in the last step where the middle of a pixel of the picture lies."""
    assert view.driver is not None
    (columns, rows), (width, height) = view.driver.tube.size_px, view.face_mm
    x_mm, y_mm = mm_of(x, y, (16, 12))
    return float(view.driver.lights[0][int(y_mm / height * rows), int(x_mm / width * columns)])


def test_a_click_probes_the_pixel_under_it(qtbot: QtBot, raster: TubeView) -> None:
    place = raster.position(5.0, 9.0)
    with qtbot.waitSignal(raster.probed) as caught:
        qtbot.mouseClick(raster, Qt.MouseButton.LeftButton, pos=place.toPoint())
    assert caught.args == [5, 9]
    QTest.keyClick(raster, Qt.Key.Key_Up)
    QTest.keyClick(raster, Qt.Key.Key_Left)
    assert raster.probe == (4, 10)
    qtbot.mouseClick(raster, Qt.MouseButton.LeftButton, pos=QPoint(1, 1))
    assert raster.probe == (4, 10)
    assert light_at(raster, 8, 6) > 0.3
    assert light_at(raster, 1, 6) < 0.05


def test_the_setup_can_be_changed_and_a_wrong_one_is_refused(raster: TubeView) -> None:
    raster.set_setup(TubeSetup("P22", 85.0))
    assert raster.refresh_hz == pytest.approx(85.0)
    assert raster.driver is not None
    assert len(raster.driver.tube.guns) == 3
    with pytest.raises(LookupError):
        raster.set_setup(TubeSetup("P999"))
    assert raster.setup.phosphor == "P22"


def test_the_vector_tube_slows_down_with_a_long_list(qtbot: QtBot) -> None:
    view = TubeView("vector")
    qtbot.addWidget(view)
    view.resize(300, 260)
    view.set_setup(TubeSetup(vector_display="atari-dvg"))
    view.set_strokes([(1.0, 1.0, 14.0, 10.0, 0xFFFFFF)], (16, 12))
    view.show()
    qtbot.waitUntil(lambda: view.is_current)
    assert view.refresh_hz == pytest.approx(60.0)
    view.set_strokes([(1.0, 1.0, 14.0, 10.0, 0xFFFFFF)] * 80, (16, 12))
    assert view.refresh_hz < 30.0


@pytest.mark.parametrize("tokens", [LIGHT, DARK])
def test_the_cabinet_is_dark_in_both_themes(raster: TubeView, tokens) -> None:
    theme.use(tokens)
    picture = raster.grab().toImage()
    corner = raster._case.center().toPoint().x(), int(raster._case.top()) + 5
    assert picture.pixelColor(*corner).lightness() < 70


def test_it_has_words_for_those_who_do_not_see_it(raster: TubeView) -> None:
    assert raster.accessibleName()
    assert raster.toolTip()
    assert raster.focusPolicy() == Qt.FocusPolicy.StrongFocus


def test_what_was_blurred_is_drawn_anew_once_the_text_is_there(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    ready: list[bool] = []
    for module in (beam_module, view_module):
        monkeypatch.setattr(module, "strokes_ready", lambda: bool(ready))
    tube = TubeView("vector")
    qtbot.addWidget(tube)
    tube.resize(300, 240)
    tube.set_strokes([(2.0, row / 4, 60.0, row / 4, 0xFFFFFF) for row in range(160)], (64, 48))
    tube.show()
    qtbot.waitUntil(lambda: tube.is_current)
    assert tube.driver is not None
    blurred = tube.driver.beam
    assert isinstance(blurred, VectorBeam)
    blurred.energy_per_frame()
    assert blurred.blurred
    ready.append(True)
    qtbot.waitUntil(lambda: tube.driver is not None and tube.driver.beam is not blurred)
    sharp = tube.driver.beam
    assert isinstance(sharp, VectorBeam)
    assert not sharp.blurred
    qtbot.waitUntil(lambda: not tube._sharpening.isActive())


def counted(monkeypatch: pytest.MonkeyPatch) -> list[TubeSetup]:
    """The setups that tubes are made with from now on, in their order."""
    made: list[TubeSetup] = []

    def make(image: np.ndarray, size: tuple[int, int], setup: TubeSetup) -> object:
        made.append(setup)
        return raster_tube(image, size, setup)

    monkeypatch.setattr(view_module, "raster_tube", make)
    return made


def test_a_tube_is_made_once_when_it_comes_in_sight_whatever_it_was_given_before(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = counted(monkeypatch)
    view = TubeView("raster")
    qtbot.addWidget(view)
    view.resize(300, 260)
    view.shown.connect(lambda: view.set_setup(TubeSetup("P1")))
    view.shown.connect(lambda: view.set_image(image()))
    view.set_setup(TubeSetup("P4"))
    assert made == []
    with qtbot.waitExposed(view):
        view.show()
    qtbot.waitUntil(lambda: view.is_current)
    assert made == [TubeSetup("P1")]
    view.hide()
    view.set_setup(TubeSetup("P31"))
    assert len(made) == 1
    view.show()
    qtbot.waitUntil(lambda: view.is_current)
    assert len(made) == 2


def test_the_tube_of_a_large_picture_is_made_on_a_thread_and_only_the_last_is_shown(
    qtbot: QtBot, raster: TubeView, monkeypatch: pytest.MonkeyPatch
) -> None:
    made, threads, may_go = [], [], Event()

    def make(image: np.ndarray, size: tuple[int, int], setup: TubeSetup) -> object:
        threads.append(current_thread())
        made.append(image)
        may_go.wait(10.0)
        return raster_tube(image, size, setup)

    monkeypatch.setattr(view_module, "raster_tube", make)
    first, second, last = (np.full((330, 330), level, np.uint32) for level in (0xFF, 0xFF00, 0xFFFFFF))
    before = raster.driver
    for each in (first, second, last):
        raster.set_image(each)
    assert not raster.is_current
    assert raster.driver is before
    assert not raster.running  # the one before stands still
    may_go.set()
    qtbot.waitUntil(lambda: raster.is_current)
    assert [each is last for each in made] == [False, True]
    assert main_thread() not in threads
    assert raster.driver is not before
    assert light_at(raster, 8, 6) > 0.9


def test_a_large_picture_that_cannot_be_made_leaves_the_tube_as_it_was(
    qtbot: QtBot, raster: TubeView, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[str] = []
    monkeypatch.setattr(live_tube, "report", lambda: told.append("said"))
    monkeypatch.setattr(view_module, "raster_tube", lambda *_arguments: 1 // 0)
    before = raster.driver
    raster.set_image(np.zeros((330, 330), np.uint32))
    qtbot.waitUntil(lambda: raster.is_current)
    assert told == ["said"]
    assert raster.driver is before


def test_the_beam_in_a_large_picture_is_found_on_a_thread_as_it_comes_in_slow_motion(
    qtbot: QtBot, raster: TubeView, monkeypatch: pytest.MonkeyPatch
) -> None:
    raster.set_image(np.full((330, 330), 0xFFFFFF, np.uint32))
    qtbot.waitUntil(lambda: raster.is_current)
    assert raster.averaged
    threads, settle = [], RasterBeam.settle

    def watched(beam: RasterBeam, tube: Tube) -> None:
        threads.append(current_thread())
        settle(beam, tube)

    monkeypatch.setattr(RasterBeam, "settle", watched)
    raster.set_slow_motion(1000.0)
    qtbot.waitUntil(lambda: bool(threads) and raster.is_current)
    qtbot.wait(100)  # it runs on, and is not made again
    assert len(threads) == 1
    assert threads[0] is not main_thread()
    assert raster.standing is not None
    assert not raster.standing.averages
