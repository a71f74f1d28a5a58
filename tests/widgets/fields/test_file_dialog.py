"""The dialogs for files show a folder without opening what is in it."""

import ctypes
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QFileInfo, Qt, QTimer
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QApplication, QFileDialog, QFileSystemModel, QWidget
from pytestqt.qtbot import QtBot

from workbench.exchange.written import formats
from workbench.widgets.fields.file_dialog import FileDialog, NamedIcons, ask_for_file
from workbench.widgets.fields.save_dialog import SaveDialog

OPENED, MOVED_ON = 0x20, os.O_NONBLOCK


@pytest.fixture
def owner(qtbot: QtBot) -> Iterator[QWidget]:
    """Outlives the dialogs over it."""
    owner = QWidget()
    qtbot.addWidget(owner)
    yield owner
    QApplication.processEvents()


def watched(paths: list[Path]) -> int:
    """A descriptor that has something to read once one of these is opened."""
    system = ctypes.CDLL(None, use_errno=True)
    descriptor: int = system.inotify_init1(MOVED_ON)
    for path in paths:
        assert system.inotify_add_watch(descriptor, os.fsencode(path), OPENED) > 0
    return descriptor


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="counts what is opened with inotify")
@pytest.mark.parametrize("saves", [False, True])
def test_no_file_is_opened(qtbot: QtBot, owner: QWidget, tmp_path: Path, saves: bool) -> None:
    paths = [tmp_path / name for name in ("kmsg", "picture.gwb", "noise.txt")]
    for path in paths:
        path.write_bytes(b"\x89PNG\r\n\x1a\n")
    dialog: FileDialog
    if saves:
        dialog = SaveDialog(owner, "", tmp_path / "new.gwb", formats("document"), lambda *_: None)
    else:
        dialog = FileDialog(owner, "", tmp_path)
    dialog.setNameFilters(["All files (*)"])
    descriptor = watched(paths)
    dialog.show()
    model = dialog.findChild(QFileSystemModel)
    assert model is not None

    def icons() -> list[object]:
        folder = model.index(str(tmp_path))
        rows = [model.index(row, 0, folder) for row in range(model.rowCount(folder))]
        return [model.data(row, Qt.ItemDataRole.DecorationRole) for row in rows]

    qtbot.waitUntil(lambda: len(icons()) == len(paths) and all(isinstance(icon, QIcon) for icon in icons()))
    with pytest.raises(BlockingIOError):
        os.read(descriptor, 4096)
    os.close(descriptor)
    dialog.reject()


def test_what_has_no_ending_is_told_by_nothing_else(qapp: QApplication, tmp_path: Path) -> None:
    (tmp_path / "scan").write_bytes(b"\x89PNG\r\n\x1a\n")
    os.mkfifo(tmp_path / "pipe")
    icons = NamedIcons()
    kinds = [icons.type(QFileInfo(str(tmp_path / name))) for name in ("scan", "pipe", "scan.PNG", "")]
    assert kinds == ["File", "File", "png file", "Folder"]
    plain, pipe, folder = (
        icons.icon(QFileInfo(str(path))) for path in (tmp_path / "scan", tmp_path / "pipe", tmp_path)
    )
    assert not pipe.isNull()
    assert pipe.cacheKey() == plain.cacheKey() != folder.cacheKey()


def test_a_file_that_is_chosen_is_given_back(owner: QWidget, tmp_path: Path) -> None:
    (tmp_path / "points.txt").write_text("1 2\n")
    kinds: list[str] = []

    def choose() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QFileDialog)
        kinds.extend(dialog.nameFilters())
        dialog.selectFile("points.txt")
        dialog.accept()

    QTimer.singleShot(0, choose)
    assert ask_for_file(owner, "Open", tmp_path) == tmp_path / "points.txt"
    assert all(f"*{ending}" in kinds[0] for ending in (".gwb", ".svg", ".csv", ".txt", ".obj"))
    QTimer.singleShot(0, lambda: QApplication.activeModalWidget().close())
    assert ask_for_file(owner, "Open", tmp_path) is None
