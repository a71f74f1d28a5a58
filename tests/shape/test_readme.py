"""The README's tree is the tree there is: no package is left out, and none that is gone is named."""

import re
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).resolve().parents[2]
_FOLDER = re.compile(r"^    (?P<indent> *)(?P<name>[a-z_]+)/ +(?P<purpose>\S.*)?$")
_STEP = 2


def purposes() -> dict[str, str]:
    """The purpose of each folder in the README's tree, by its path."""
    above: list[str] = []
    said: dict[str, str] = {}
    lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    for line in lines[lines.index("    workbench/") :]:
        if not line:
            break
        folder = _FOLDER.match(line + " ")
        assert folder is not None, line
        above = [*above[: len(folder["indent"]) // _STEP], folder["name"]]
        said["/".join(above)] = folder["purpose"] or ""
    return said


def test_every_package_is_named_with_its_purpose() -> None:
    packages = {path.parent.relative_to(ROOT).as_posix() for path in ROOT.glob("workbench/**/__init__.py")}
    assert packages <= set(purposes())


def test_every_folder_named_is_there_and_says_what_it_is_for() -> None:
    for folder, purpose in purposes().items():
        assert (ROOT / PurePosixPath(folder)).is_dir(), folder
        assert purpose or folder == "workbench", folder
