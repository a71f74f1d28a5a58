"""A storage tube on the page Random scan: written, kept, erased as a whole, at any size."""

import pytest
from PySide6.QtCore import QPoint
from pytestqt.qtbot import QtBot

from tests.panels.display.test_vector_page import give, settle, typed
from workbench.panels.display.vector.list_model import X
from workbench.panels.display.vector.page import VectorPage
from workbench.session.session import Session
from workbench.widgets.look.comfort import comfort


@pytest.fixture
def page(vector_page: VectorPage) -> VectorPage:
    return vector_page


def test_a_storage_tube_keeps_what_was_written(page: VectorPage, session: Session, qtbot: QtBot) -> None:
    give(page, storage=True)
    qtbot.waitUntil(lambda: page.storage.tube is not None)
    settle(page)
    tube = page.storage.tube
    assert tube is not None
    assert tube.stored.any()
    assert "no flicker" in page.storage_bar.note.text()
    assert page.bar.phosphor.currentData() == "P1"
    assert not page.bar.phosphor.isEnabled()
    assert session.state.tube.phosphor == "P31"  # for the tube that is refreshed
    assert "64 · 40 / 9600 = 0.267 s" in page.sums.text()
    stored = tube.stored.copy()
    typed(page, 1, X, "30")
    assert page.storage.tube is not tube or (tube.stored | ~stored).all()
    assert page.storage.differs
    assert "cannot erase a part" in page.storage_bar.note.text()
    page.storage_bar.part.click()
    assert "cannot erase one stroke" in page.storage_bar.note.text()
    assert comfort.calm
    page.storage_bar.erase.click()
    assert page.storage_bar.warning.isVisible()
    assert not page.storage.erasing, "it is asked first"
    page.storage_bar.dark.click()
    assert page.storage.erasing
    qtbot.waitUntil(lambda: not page.storage.erasing, timeout=4000)
    tube = page.storage.tube
    assert not tube.stored.any()
    qtbot.waitUntil(lambda: "not written yet" in page.storage_bar.note.text())
    page.storage_bar.write.click()
    assert tube.stored.any()


def test_an_erasure_ends_though_the_tube_becomes_another_size(page: VectorPage, qtbot: QtBot) -> None:
    give(page, storage=True)
    bar = page.storage_bar
    qtbot.waitUntil(lambda: page.storage.tube is not None and bar.write.isVisible())
    settle(page)
    bar.erase.click()
    bar.dark.click()
    before = page.storage.tube
    page.resize(page.width() + 120, page.height() + 60)
    qtbot.waitUntil(lambda: page.storage.tube is not before)
    assert page.storage.erasing, "neither does it end at once"
    assert not bar.write.isEnabled()
    qtbot.waitUntil(bar.write.isEnabled, timeout=6000)
    assert not page.storage.erasing
    bar.write.click()
    tube = page.storage.tube
    assert tube is not None
    assert tube.stored.any()


def test_the_question_before_a_flash_takes_no_room_from_the_list(page: VectorPage, qtbot: QtBot) -> None:
    give(page, storage=True)
    bar = page.storage_bar
    qtbot.waitUntil(bar.erase.isVisible)
    narrow = page.minimumSizeHint().width()
    bar.erase.click()
    qtbot.waitUntil(bar.warning.isVisible)
    assert page.minimumSizeHint().width() == narrow
    for part in (bar.warning, bar.flash, bar.dark):
        assert part.width() >= part.sizeHint().width()
    bar.dark.click()


def test_the_buttons_of_a_storage_tube_stay_where_they_are_when_its_note_is_longer(
    page: VectorPage, qtbot: QtBot
) -> None:
    give(page, storage=True)
    bar = page.storage_bar
    qtbot.waitUntil(bar.erase.isVisible)
    qtbot.waitUntil(lambda: "no flicker" in bar.note.text())
    places = []
    for text in ("One line.", "Several lines of it. " * 20):
        bar.note.setText(text)
        qtbot.wait(60)
        places.append(bar.erase.mapTo(page, QPoint()))
    assert places[0] == places[1]
