"""Hearn and Baker's VRP, VPN and PRP stand beside the eye, and their z can be chosen."""

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import settle, shown
from workbench.document.scene.viewing import view_matrix
from workbench.exchange.formulas.terms import Matrix
from workbench.panels.space.projection_page import ProjectionPage


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    for page in shown(qtbot):
        page.resize(1100, 700)
        page.card.set_open(True)
        settle(qtbot, page)
        yield page


def matrices(page: ProjectionPage) -> list[np.ndarray]:
    terms = [term for term in page.strip.row.terms if isinstance(term, Matrix)]
    return [np.array([[cell.value for cell in row] for row in term.cells], float) for term in terms]


def test_z_towards_the_eye_changes_both_factors_and_not_their_product(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    whole, plane, view = matrices(page)
    assert np.allclose(view, view_matrix(page.looking.camera))
    page.card.towards_eye.setFocus()
    qtbot.keyClick(page.card.towards_eye, Qt.Key.Key_Space)
    settle(qtbot, page)
    book_whole, book_plane, book_view = matrices(page)
    assert np.array_equal(book_whole, whole)
    assert np.allclose(book_plane @ book_view, whole)
    assert np.allclose(book_view[2, :3], -view[2, :3])
    assert np.allclose(book_plane[3], (0, 0, -1 / 3, 2.5))
    qtbot.keyClick(page.card.towards_eye, Qt.Key.Key_Space)
    settle(qtbot, page)
    assert np.array_equal(matrices(page)[1], plane)
    command = next(each for each in page.commands() if each.objectName() == "space.z_towards_eye")
    command.trigger()  # where the card has no room
    settle(qtbot, page)
    assert np.array_equal(matrices(page)[1], book_plane)
    assert command.isChecked() == page.card.towards_eye.isChecked() is True


def test_the_names_follow_the_camera(qtbot: QtBot, page: ProjectionPage) -> None:
    assert page.card.book.text().splitlines() == [
        "VRP = look at, (0, 1.6, 0)",
        "VPN towards the eye, (0.6, 0, 0.8)",
        "PRP = eye, (0, 0, 7.5) from VRP",
        "View plane at z = 4.5",
    ]
    page.choose("cavalier")
    settle(qtbot, page)
    assert "PRP at infinity, along (0.707, 0.707, 1)" in page.card.book.text()
