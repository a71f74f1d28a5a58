"""The import contracts of pyproject.toml hold, and each of them bites."""

import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CONTRACTS = [
    contract["name"]
    for contract in tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
]

OFFENCES = {
    "A package imports only from lower levels": ("workbench/geometry/offence.py", "import workbench.engine"),
    "Qt appears from session upwards only": ("workbench/cli/offence.py", "from PySide6 import QtCore"),
    "Only engine.compiled knows numba": ("workbench/panels/offence.py", "import numba"),
    "Algorithms stand on NumPy and the standard library": (
        "workbench/algorithms/lines/offence.py",
        "import msgspec",
    ),
    "The wings do not know one another, and stand on what they share": (
        "workbench/panels/fill/offence.py",
        "import workbench.panels.clip.panel",
    ),
}


def lint(folder: Path) -> subprocess.CompletedProcess[str]:
    """Judge the contracts of the tree in ``folder``, as the tool does on a command line."""
    command = "from importlinter.cli import lint_imports_command as run; run(['--no-cache', '--no-logo'])"
    environment = {**os.environ, "PYTHONPATH": str(folder), "COLUMNS": "200"}
    return subprocess.run(
        [sys.executable, "-c", command],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
    )


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("tree")
    shutil.copy(ROOT / "pyproject.toml", folder)
    shutil.copytree(ROOT / "workbench", folder / "workbench", ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def test_contracts_hold(tree: Path) -> None:
    judged = lint(tree)
    assert judged.returncode == 0, judged.stdout + judged.stderr
    assert f"{len(CONTRACTS)} kept, 0 broken" in judged.stdout


@pytest.mark.parametrize("contract", CONTRACTS)
def test_contract_bites(tree: Path, contract: str) -> None:
    path, line = OFFENCES[contract]
    (tree / path).write_text(line + "\n")
    try:
        judged = lint(tree)
    finally:
        (tree / path).unlink()
    assert judged.returncode != 0
    assert f"{contract} BROKEN" in judged.stdout
    assert path.removesuffix(".py").replace("/", ".") in judged.stdout
