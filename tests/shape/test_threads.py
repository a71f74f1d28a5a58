"""Threads are begun in few places, and those that an interface begins know nothing of Qt.

A thread that emits a signal of an object which is being destroyed, or which lets go of the last reference to
one, ends the process.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[2] / "workbench"
BEGUN = ("Thread", "QThread", "QThreadPool", "QRunnable", "ThreadPoolExecutor", "start_new_thread")
ANSWERS = "workbench.session.answers"
TEXTS = {path.relative_to(PACKAGE).as_posix(): path.read_text() for path in PACKAGE.rglob("*.py")}
# Only where one of these words stands: every process that runs tests parses them
TREES = {
    name: ast.parse(text) for name, text in TEXTS.items() if any(word in text for word in (*BEGUN, ANSWERS))
}
MAY_BEGIN = {
    "cli/waiting.py",
    "engine/recorder.py",
    "rendering/triangles.py",
    "session/answers.py",
    "session/recovery.py",
}


def called(node: ast.AST) -> str:
    """The last name of what a call calls."""
    match node:
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)):
            return name
    return ""


def knows_qt(tree: ast.AST) -> bool:
    return any(isinstance(node, ast.ImportFrom) and "PySide6" in str(node.module) for node in ast.walk(tree))


def test_threads_are_begun_in_few_places() -> None:
    begin = {name for name, tree in TREES.items() if {called(node) for node in ast.walk(tree)} & {*BEGUN}}
    assert begin == MAY_BEGIN
    assert [name for name in sorted(begin) if knows_qt(TREES[name])] == ["session/answers.py"]


def works(tree: ast.Module) -> Iterator[ast.expr]:
    """What is given to ``Answers.ask`` in a module."""
    if not any(getattr(node, "module", "") == ANSWERS for node in ast.walk(tree)):
        return
    for function in ast.walk(tree):
        if isinstance(function, ast.FunctionDef):
            named = {
                target.id: node.value
                for node in ast.walk(function)
                if isinstance(node, ast.Assign)
                for target in node.targets
                if isinstance(target, ast.Name)
            }
            for node in ast.walk(function):
                if (
                    isinstance(node, ast.Call)
                    and called(node) == "ask"
                    and len(node.args) + len(node.keywords) > 1
                ):
                    work = node.args[0]
                    yield named.get(work.id, work) if isinstance(work, ast.Name) else work


def trouble(tree: ast.Module, work: ast.expr) -> str:
    """Why a work may not be done on a thread, "" when it may."""
    given: list[ast.expr] = []
    if isinstance(work, ast.Call) and called(work) == "partial":
        work, *given = work.args
    if any(isinstance(each, ast.Name) and each.id == "self" for each in given):
        return "the thread is given self"
    plain = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    for kind in tree.body:
        if isinstance(kind, ast.ClassDef) and not kind.bases:
            plain |= {node.name: node for node in kind.body if isinstance(node, ast.FunctionDef)}
    match work:
        case ast.Name(id=name) | ast.Attribute(value=ast.Attribute(), attr=name) if name in plain:
            emits = any(called(node) == "emit" for node in ast.walk(plain[name]))
            return f"{name} emits" if emits else ""
    return f"{ast.unparse(work)} is no function of the module, nor of a class that is none of Qt"


@pytest.mark.parametrize("name", [name for name, tree in TREES.items() if list(works(tree))])
def test_what_an_interface_begins_knows_nothing_of_qt(name: str) -> None:
    assert [trouble(TREES[name], work) for work in works(TREES[name]) if trouble(TREES[name], work)] == []


def test_nobody_is_left_out() -> None:
    users = {name for name, tree in TREES.items() if list(works(tree))}
    asking = {name for name, tree in TREES.items() if ANSWERS in ast.dump(tree)}
    assert users == asking
    assert len(users) >= 12


@pytest.mark.parametrize(
    ("work", "said"),
    [
        ("self._work", "is no function"),
        ("partial(plain, self)", "given self"),
        ("lambda: self.done.emit(1)", "is no function"),
        ("tells", "tells emits"),
        ("self._panel.slot", "is no function"),
        ("partial(plain, self.number)", ""),
        ("self._job.work", ""),
    ],
)
def test_the_rule_bites(work: str, said: str) -> None:
    tree = ast.parse(
        "def plain(*given): pass\n"
        "def tells(signal): signal.emit()\n"
        "class Panel(QObject):\n    def slot(self): pass\n"
        "class Job:\n    def work(self): pass\n"
    )
    told = trouble(tree, ast.parse(work, mode="eval").body)
    assert said in told
    assert bool(said) == bool(told)
