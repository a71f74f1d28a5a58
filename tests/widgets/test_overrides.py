"""Whatever an override raises is told, and the process goes on."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

RAISING = """
import sys
import numpy as np
from PySide6.QtCore import QAbstractListModel, QTimer
from PySide6.QtWidgets import QApplication, QListView, QWidget
import workbench.widgets

class Mixed:
    def {event}(self, *arguments):
        {fault}

class Widget(Mixed, QWidget):
    pass

class Model(QAbstractListModel):
    def rowCount(self, parent):
        return 2
    def data(self, index, role):
        {fault}

sys.excepthook = lambda kind, error, trace: print(kind.__name__, error)
application = QApplication([])
widget, view, model = Widget(), QListView(), Model()
view.setModel(model)
for each in (widget, view):
    QTimer.singleShot(0, each.show)
QTimer.singleShot(200, application.quit)
application.exec()
print("it goes on")
"""


@pytest.mark.parametrize(
    ("event", "fault", "told"),
    [
        ("showEvent", "np.zeros((3, 2))[:, 2]", "IndexError"),
        ("event", "int('one')", "ValueError"),
        ("paintEvent", "len(5)", "TypeError"),
        ("resizeEvent", "raise KeyError(3)", "KeyError"),
    ],
)
@pytest.mark.xdist_group("processes")
def test_a_fault_in_an_override_is_told_and_ends_nothing(event: str, fault: str, told: str) -> None:
    ended = subprocess.run(
        [sys.executable, "-c", RAISING.format(event=event, fault=fault)],
        cwd=ROOT, capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    assert ended.returncode == 0
    assert ended.stdout.splitlines()[-1] == "it goes on"
    assert f"{told} " in ended.stdout


def test_an_override_takes_what_it_took(qtbot) -> None:
    from PySide6.QtWidgets import QDialog, QPushButton

    import workbench.widgets  # noqa: F401

    class Asked(QDialog):
        """Has an override that is a slot as well, connected to a signal that sends more than it takes."""

        def accept(self) -> None:
            super().accept()

    dialog, button = Asked(), QPushButton()
    qtbot.addWidget(dialog)
    qtbot.addWidget(button)
    button.clicked.connect(dialog.accept)
    button.click()
    assert dialog.result() == QDialog.DialogCode.Accepted


def test_a_base_that_knows_nothing_of_qt_takes_nothing_from_those_before_it(qtbot) -> None:
    from PySide6.QtWidgets import QWidget

    import workbench.widgets  # noqa: F401

    class Plain:
        def sizeHint(self) -> str:
            return "plain"

    class Middle(QWidget):
        def sizeHint(self) -> str:  # type: ignore[override]
            return "middle"

    class Last(Middle, Plain):
        pass

    class Mixed(Plain, QWidget):
        pass

    for kind, said in ((Last, "middle"), (Mixed, "plain")):
        widget = kind()
        qtbot.addWidget(widget)
        assert widget.sizeHint() == said


@pytest.mark.skipif(sys.version_info >= (3, 12), reason="what is raised is an exception there")
def test_every_override_of_the_program_is_guarded() -> None:
    import importlib
    import inspect
    import pkgutil
    from types import FunctionType

    from PySide6.QtCore import QObject

    import workbench
    from workbench.widgets.overrides import MARK

    for module in pkgutil.walk_packages(workbench.__path__, "workbench."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    kinds = [QObject]
    for kind in kinds:
        kinds += kind.__subclasses__()
    own = [kind for kind in kinds if kind.__module__.startswith("workbench.")]
    assert len(own) > 100
    for kind in own:
        bases = (base for base in kind.__mro__ if base.__module__.startswith("PySide6."))
        for name in {name for base in bases for name in vars(base) if not name.startswith("__")}:
            method = inspect.getattr_static(kind, name)
            owner = next(base for base in kind.__mro__ if name in vars(base))
            if isinstance(method, FunctionType) and not owner.__module__.startswith("PySide6."):
                assert hasattr(method, MARK), f"{kind.__qualname__}.{name}"
