"""Modules come beside the interface: what lies below Qt on a thread, what is of Qt in slices on this one.

PySide looks an object's class up without the interpreter's lock, in a table that grows with each class that
is made. One that an import makes on another thread ends the program now and then: none may be made there.
"""

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

if TYPE_CHECKING:
    from workbench.engine.background import Thread

BELOW_QT = (
    "numpy",
    "workbench.document.samples.examples",
    "workbench.rendering.scene.line_drawing",
    "workbench.rendering.why_steps",
    "workbench.rendering.work",
    "workbench.exchange.written",
    "workbench.display.driver",
)
"""What takes long of that which every workspace stands on."""

OF_QT = (
    "workbench.session.session",
    "workbench.shell.home_examples",
    "qtpy.QtCore",
    "qtpy.QtGui",
    "qtpy.QtWidgets",
    "qtawesome",
)
"""What takes long on this thread; each is less than a tenth of a second."""


def import_beside(parent: QObject, then: Callable[[], object]) -> "Thread":
    """Import on a thread what may be imported there, and do ``then`` on this one."""
    from workbench.session.answers import Answers

    answers = Answers(parent)
    answers.arrived.connect(lambda _imported: then())
    return answers.ask(_import_below_qt, "imports")


def _import_below_qt() -> bool:
    for _module in import_each(BELOW_QT):
        pass
    with suppress(Exception):
        import_module("workbench.display.setup").TubeSetup().check()  # reads the tables of phosphors
    return True


def import_each(modules: Iterable[str]) -> Iterator[None]:
    """Import these in their order, one in each step; a failure is said where the module is needed."""
    for module in modules:
        if module not in sys.modules:
            with suppress(Exception):
                import_module(module)
            yield
