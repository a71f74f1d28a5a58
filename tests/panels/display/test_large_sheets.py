"""The pages of Display show a sheet of many figures without painting it on the thread of the interface."""

import threading
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace
from numpy.typing import NDArray
from pytestqt.qtbot import QtBot

from tests.panels.display.conftest import put_on_screen
from workbench.document.model import Document, Sheet
from workbench.document.samples.examples import blank_sheet
from workbench.document.samples.figures import line
from workbench.document.subjects import Subject
from workbench.panels.display.colour.page import MASK, PENETRATION, ColourPage
from workbench.panels.display.comparison import page as comparison_page
from workbench.panels.display.comparison.page import ComparisonPage
from workbench.panels.display.flicker.page import FlickerPage
from workbench.panels.display.raster.page import RasterPage
from workbench.panels.display.tubes_page import TubesPage
from workbench.panels.display.vector.page import VectorPage
from workbench.rendering import frame_buffer, raster
from workbench.rendering.subjects import random_scan
from workbench.session.session import Session

COUNT = 400


def document_of(count: int) -> Document:
    begun = blank_sheet(64, 48)
    rng = np.random.default_rng(count)
    places = rng.integers(2, 46, (count, 4)).tolist()
    figures = tuple(
        replace(line((a, b), (c, d)), id=f"f{3 * k + 1}") for k, (a, b, c, d) in enumerate(places)
    )
    return replace(begun, sheets=(replace(begun.sheets[0], figures=figures),))


def colour_part(part: str) -> Subject:
    usual = ColourPage.usual
    return replace(usual, arguments={**usual.arguments, "part": part})


PAGES: dict[str, tuple[Any, str, Subject]] = {
    "tubes": (TubesPage, "display", TubesPage.usual),
    "raster": (RasterPage, "raster", RasterPage.usual),
    "vector": (VectorPage, "vector", VectorPage.usual),
    "comparison": (ComparisonPage, "comparison", ComparisonPage.usual),
    "flicker": (FlickerPage, "flicker", FlickerPage.usual),
    "mask": (ColourPage, "colour", colour_part(MASK)),
    "penetration": (ColourPage, "colour", colour_part(PENETRATION)),
}


def shows(name: str, page: Any, image: NDArray[np.uint32]) -> bool:
    """Whether the tubes of a page show the picture, or all of its strokes."""
    images = {
        "tubes": lambda: page.raster._image,
        "raster": lambda: page.tube._image,
        "comparison": lambda: page.raster._image,
        "flicker": lambda: page.image,
        "mask": lambda: page.masked.whole.image,
    }
    strokes = {
        "tubes": lambda: page.vector._strokes,
        "vector": lambda: page.tube._strokes,
        "comparison": lambda: page.vector._strokes,
        "penetration": lambda: page.penetration.tube._strokes,
    }
    there = [name not in images or np.array_equal(images[name](), image)]
    there.append(name not in strokes or len(strokes[name]()) == COUNT)
    return all(there)


@pytest.fixture
def painted(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, int, bool]]:
    """What was painted or listed: how many figures, and whether on the thread of the interface."""
    told: list[tuple[str, int, bool]] = []

    def watch(module: str, name: str) -> None:
        real = getattr(import_module(f"workbench.rendering.{module}"), name)

        def noted(sheet: Sheet, *rest: object) -> object:
            here = threading.current_thread() is threading.main_thread()
            told.append((name, len(sheet.figures), here))
            return real(sheet, *rest)

        monkeypatch.setattr(import_module(f"workbench.rendering.{module}"), name, noted)

    watch("raster", "_paint")
    watch("display_list", "_in_one_view")
    return told


@pytest.mark.parametrize("name", list(PAGES))
def test_a_page_shows_many_figures_that_are_painted_elsewhere(
    qtbot: QtBot, session: Session, painted: list[tuple[str, int, bool]], name: str
) -> None:
    kind, slug, usual = PAGES[name]
    session.new(document_of(COUNT))
    session.flush()
    image = frame_buffer(session.sheet)
    raster._composite.cache_clear()
    painted.clear()
    page = kind(session)
    put_on_screen(qtbot, page, 900, 600)
    session.visit(slug, usual)
    session.flush()
    qtbot.waitUntil(lambda: shows(name, page, image), timeout=20_000)
    qtbot.waitUntil(lambda: not session.ahead.busy, timeout=20_000)
    large = [here for _name, count, here in painted if count > 300]
    assert large
    assert not any(large)


@pytest.mark.parametrize("slug", ["raster", "vector", "comparison"])
def test_the_run_of_many_figures_comes_when_it_can_and_steps(
    qtbot: QtBot, session: Session, painted: list[tuple[str, int, bool]], slug: str
) -> None:
    kind, _slug, usual = PAGES[slug]
    page = kind(session)
    put_on_screen(qtbot, page, 900, 600)
    session.visit(slug, usual)
    session.flush()
    before = session.run.calls
    assert before
    session.new(document_of(COUNT))
    session.visit(slug, usual)
    session.flush()
    qtbot.waitUntil(lambda: session.run.calls != () and session.run.calls is not before, timeout=20_000)
    qtbot.waitUntil(lambda: session.run.number == 0 and session.run.last_position > 0, timeout=20_000)
    session.run.forward()
    assert session.run.number == 1
    assert not any(here for _name, count, here in painted if count > 300)


def test_the_list_that_was_made_elsewhere_is_the_one_that_is_shown(
    qtbot: QtBot, session: Session, painted: list[tuple[str, int, bool]]
) -> None:
    """Also once the last few lists have been forgotten by what makes them."""
    session.new(document_of(COUNT))
    page = VectorPage(session)
    put_on_screen(qtbot, page, 900, 600)
    session.visit("vector", VectorPage.usual)
    session.flush()
    qtbot.waitUntil(lambda: len(page.tube._strokes) == COUNT and not session.ahead.busy, timeout=20_000)
    program = page._run.program
    for remembered in (random_scan._strokes, random_scan._program):
        remembered.cache_clear()
    painted.clear()
    page.refresh()
    assert page._run.program is program
    assert painted == []


def test_the_magnifying_glass_over_many_figures_is_filled_elsewhere(
    qtbot: QtBot, session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    threads: list[threading.Thread] = []
    magnified = comparison_page.magnified_vector

    def noted(*given: Any) -> Any:
        threads.append(threading.current_thread())
        return magnified(*given)

    monkeypatch.setattr(comparison_page, "magnified_vector", noted)
    session.new(document_of(COUNT))
    page = ComparisonPage(session)
    put_on_screen(qtbot, page, 900, 600)
    session.visit("comparison", ComparisonPage.usual)
    qtbot.waitUntil(lambda: bool(threads) and not session.ahead.busy, timeout=20_000)
    assert all(lens.isVisible() for lens in page.lenses)
    assert threading.main_thread() not in threads
