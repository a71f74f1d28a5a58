"""What may be imported without Qt and without the compiler, proved in a fresh process."""

import subprocess
import sys

import pytest

HEAVY = ("PySide6", "numba", "pyqtgraph", "shiboken6", "llvmlite")


def loaded_after(code: str) -> set[str]:
    """The heavy packages that a fresh process has loaded after running ``code``."""
    told = subprocess.run(
        [sys.executable, "-c", f"{code}\nimport sys; print(*[m for m in {HEAVY} if m in sys.modules])"],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    return set(told.stdout.splitlines()[-1].split())


@pytest.mark.parametrize(
    "code",
    [
        "import workbench.algorithms, workbench.algorithms.catalogue",
        "import workbench.__main__",
        "from workbench.cli import main; main(['list'])",
        "from workbench.cli import main; main(['trace', 'bresenham_line', '0', '0', '3', '1'])",
        "import workbench.document, workbench.rendering, workbench.exchange.tables",
    ],
)
def test_without_qt_and_compiler(code: str) -> None:
    assert loaded_after(code) == set()


def test_the_question_can_be_answered_with_yes() -> None:
    assert loaded_after("import PySide6.QtCore") == {"PySide6", "shiboken6"}
