"""No panel or widget waits in a loop of its own: what it asks for may go while the program runs on."""

import ast
from pathlib import Path

import workbench

ROOT = Path(workbench.__file__).parent
HOLDING = {"exec", "getColor", "getText", "getInt", "getDouble", "getItem", "getFont", "question", "warning"}
DIALOGS = {"QColorDialog", "QInputDialog", "QFontDialog", "QMessageBox"}


def holds(call: ast.Call) -> bool:
    """Whether a call runs a loop until somebody has answered."""
    function = call.func
    if not isinstance(function, ast.Attribute) or function.attr not in HOLDING:
        return False
    return function.attr == "exec" or (isinstance(function.value, ast.Name) and function.value.id in DIALOGS)


def test_only_where_a_file_is_named_is_an_answer_waited_for() -> None:
    waiting = {
        str(path.relative_to(ROOT))
        for folder in ("panels", "widgets", "session")
        for path in (ROOT / folder).rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.Call) and holds(node)
    }
    assert waiting == {"widgets/fields/file_dialog.py", "widgets/fields/save_dialog.py"}
