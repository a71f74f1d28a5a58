"""A picture that is opened, recovered or chosen among the sheets is shown where it can be seen."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import Example, example_document, examples
from workbench.document.storage.files import Stored, save
from workbench.session.recovery import Recoverable
from workbench.session.session import Session
from workbench.shell.opening import place_for
from workbench.shell.start import make_window

from .conftest import leave


@pytest.mark.parametrize("example", examples(), ids=lambda each: each.slug)
def test_a_sheet_is_shown_where_something_of_it_is_seen(example: Example) -> None:
    sheet = example.document.sheets[0]
    place = place_for(sheet)
    assert (place == "animate") == (example.workspace == "animate")
    assert (place == "space") == (sheet.scene is not None and sheet.motion is None)
    assert sheet.figures or place != "draw"


def test_a_scene_is_shown_in_space_again_wherever_it_comes_from(qtbot: QtBot, tmp_path: Path) -> None:
    window = make_window()
    window.show()
    window.attach(Session(window, example_document()))
    window.open_example("space-house")
    assert window.place == "space"
    stored = Stored(window.session.document, window.session.state)
    path = tmp_path / "house.gwb"
    save(window.session.document, path)
    for come in (
        lambda: window.files.show_sheet(window.session.sheet.id),
        lambda: window.files.open_path(path),
        lambda: window.files._recovering._recovered(
            Recoverable(tmp_path / "lost", None, "house", 0.0), stored
        ),
    ):
        window.go("home")
        come()
        qtbot.waitUntil(lambda: window.place == "space", timeout=20_000)
    leave(window)
