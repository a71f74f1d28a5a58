"""The file that a person names."""

from pathlib import Path

import pytest

from workbench.widgets.fields.save_dialog import SaveDialog


@pytest.fixture
def chosen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file that a person names whenever they are asked for one."""
    path = tmp_path / "my lines.gwb"
    monkeypatch.setattr("workbench.shell.files.ask_for_file", lambda *_args: path)
    monkeypatch.setattr(SaveDialog, "open", lambda dialog: dialog._then(path, dialog.file_format))
    return path
