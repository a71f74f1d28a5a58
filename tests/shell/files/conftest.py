"""The file that a person names."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog

from workbench.widgets.fields.save_dialog import SaveDialog


@pytest.fixture
def chosen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file that a person names whenever they are asked for one."""
    path = tmp_path / "my lines.gwb"
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_args: (str(path), ""))
    monkeypatch.setattr(SaveDialog, "open", lambda dialog: dialog._then(path, dialog.file_format))
    return path
