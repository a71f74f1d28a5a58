"""Edges without hidden lines, as the tool of the page Projection shows them."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import settle, shown
from workbench.panels.space.projection_page import ProjectionPage
from workbench.rendering.scene import line_drawing as drawings
from workbench.rendering.scene.edge_picture import edge_picture


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    yield from shown(qtbot)


def edges_of(page: ProjectionPage) -> int:
    eye = page.eye
    return len(edge_picture(eye.scene, eye.device_size, eye.window_world, faces=False).seen)


def seen_in(page: ProjectionPage) -> int:
    picture = page.eye._picture
    assert picture is not None
    assert picture.pixels is None
    return len(picture.seen)


@pytest.mark.parametrize("at_once", [0, 50_000_000])
def test_hidden_lines_are_left_out_however_long_that_takes(
    qtbot: QtBot, page: ProjectionPage, monkeypatch: pytest.MonkeyPatch, at_once: int
) -> None:
    for limit in ("MOST_PAIRS_AT_ONCE", "MOST_PAIRS_PLAIN"):
        monkeypatch.setattr(drawings, limit, at_once)
    told: list[str] = []
    page.hover_text.connect(told.append)
    page.next_shows()
    assert (seen_in(page), told.pop()) == (edges_of(page), "All edges are shown, hidden ones too.")
    page.next_shows()
    assert told.pop() == "Edges are shown where no face hides them."
    settle(qtbot, page)
    seen = seen_in(page)
    assert 0 < seen < edges_of(page)
    page.glance("isometric")
    settle(qtbot, page)
    assert 0 < seen_in(page) < edges_of(page)
    page.next_shows()
    settle(qtbot, page)
    assert page.eye._picture is not None
    assert page.eye._picture.pixels is not None


def test_where_too_many_would_be_compared_all_are_shown_and_a_sentence_says_so(
    qtbot: QtBot, page: ProjectionPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    for limit in ("MOST_PAIRS_AT_ONCE", "MOST_PAIRS_PLAIN", "MOST_PAIRS"):
        monkeypatch.setattr(drawings, limit, 0)
    told: list[str] = []
    page.hover_text.connect(told.append)
    page.next_shows()
    page.next_shows()
    settle(qtbot, page)
    assert seen_in(page) == edges_of(page)
    assert any("too many to compare each with every other" in sentence for sentence in told)
