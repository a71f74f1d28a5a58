"""What the dialect refuses, with the line and what to write instead; and that the rest passes."""

import ast
import re
import textwrap

import pytest

from workbench.engine.dialect import refusals


def check(body: str) -> list[tuple[int, str]]:
    tree = ast.parse("def f(a, b, l):\n" + textwrap.indent(textwrap.dedent(body), "    ")).body[0]
    assert isinstance(tree, ast.FunctionDef)
    return [(one.line, one.sentence) for one in refusals(tree)]


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("x = a ** 2", "x \\* x"),
        ("x **= 3", "x \\* x"),
        ("x = a @ b", "loop"),
        ("l.sort(key=abs)", "whole tuples"),
        ("l = sorted(l, key=abs)", "whole tuples"),
        ("i = np.argsort(l)", "mergesort"),
        ("x = min(v for v in l)", "write a list"),
        ("x = sum(l)", "loop"),
        ("x = any(l)", "loop"),
        ("for x in reversed(l): pass", "range"),
        ("if (x := a): pass", "line of its own"),
        ("x, *y = l", "unpack"),
        ("del l[1:]", "pop"),
        ("p = p._replace(x=1)", "build it again"),
        ("d = {1: [2]}", "list"),
        ("k = []", "k: list\\[int\\] = \\[\\]"),
        ("x = np.dot(a, b)", "loop"),
        ("x = np.linalg.norm(a)", "loop"),
        ("f = lambda: 1", "function of its own"),
        ("x = yield a", ""),
        ("x = yield a", "line of its own"),
        ("try:\n    pass\nexcept ValueError:\n    pass", "before it happens"),
        ("print(a)", "yield"),
        ("r = math.hypot(a, b)", "sqrt\\(x \\* x \\+ y \\* y\\)"),
        ("r = hypot(a, b)", "last bit"),
        ("r = np.hypot(a, b)", "last bit"),
        ("r = math.dist(a, b)", "last bit"),
    ],
)
def test_refused(line: str, words: str) -> None:
    found = check("y = 1\n" + line)
    assert found
    assert found[0][0] == 3
    assert re.search(words, found[0][1])


@pytest.mark.parametrize(
    "line",
    [
        "x = a * a",
        "x = a ** 0.25",
        "r = math.sqrt(a * a + b * b)",
        "x = 2 ** a",
        "k = []\nk.append(1)",
        "k: list[int] = []",
        "i = np.argsort(l, kind='mergesort')",
        "l.sort()",
        "x = [v * 2 for v in l if v > 0]",
        "while l:\n    l.pop()\nelse:\n    a = 1",
        "x: int = round(a)",
        "yield a, b",
        "if a < b < 3:\n    raise ValueError('too near')",
        "match a:\n    case 1:\n        b = 2",
    ],
)
def test_allowed(line: str) -> None:
    assert check(line) == []
