"""What is drawn of a step is declared beside its algorithm: what shows and maps it knows no algorithm.

A slug may stand here only where something is *chosen*: what a new figure begins with, which text answers a
question or takes another's place. Each such place is listed. Nowhere may a slug be compared or matched, or a
variable of a text be read by its name.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from workbench.algorithms import catalogue

PACKAGE = Path(__file__).resolve().parents[2] / "workbench"
LAYERS = ("panels", "widgets", "rendering", "session")
FILES = sorted(path for layer in LAYERS for path in (PACKAGE / layer).rglob("*.py"))
SLUGS = {entry.slug for entry in catalogue.entries()}

CHOSEN = {
    # What a new figure begins with
    "panels/clip/window.py": {"midpoint_circle"},
    "panels/fill/tools.py": {"circle_fill", "ellipse_fill"},
    # Which text belongs to a kind of figure
    "rendering/clipping.py": {"clip_point"},
    "rendering/curve_runs.py": {"de_casteljau", "de_boor", "de_boor_rational"},
    # Which text answers a question, or prepares what another is compared on
    "rendering/inside.py": {"inside_outside"},
    "rendering/outline_fill.py": {"bresenham_line", "scan_line_fill"},
}


def name_of(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


def slugs_in(node: ast.AST) -> Iterator[str]:
    for each in ast.walk(node):
        if isinstance(each, ast.Constant) and each.value in SLUGS:
            yield each.value


def decisions(tree: ast.AST) -> Iterator[ast.AST]:
    """What asks which algorithm it is: comparisons, patterns of a match, and methods that test a text."""
    for node in ast.walk(tree):
        match node:
            case ast.Compare() | ast.MatchValue():
                yield node
            case ast.Call(func=ast.Attribute(attr="startswith" | "endswith")):
                yield node


def variables_read(tree: ast.AST) -> Iterator[str]:
    """The variables of a text that are read by name, from a moment, a recording or a call."""
    readers = {"variables", "after", "values_after", "stack", "variables_at", "stack_at"}
    for node in ast.walk(tree):
        match node:
            case ast.Subscript(value=owner, slice=ast.Constant(value=str(name))):
                pass
            case ast.Call(
                func=ast.Attribute(value=owner, attr="get"), args=[ast.Constant(value=str(name)), *_]
            ):
                pass
            case _:
                continue
        called = owner.func if isinstance(owner, ast.Call) else owner
        if (called.attr if isinstance(called, ast.Attribute) else getattr(called, "id", "")) in readers:
            yield name


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_no_algorithm_is_known_where_steps_are_drawn(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    assert set(slugs_in(tree)) <= CHOSEN.get(name_of(path), set())
    assert [slug for node in decisions(tree) for slug in slugs_in(node)] == []
    assert list(variables_read(tree)) == []


def test_every_place_that_is_excepted_is_there() -> None:
    for name, slugs in CHOSEN.items():
        (path,) = [path for path in FILES if name_of(path) == name]
        assert set(slugs_in(ast.parse(path.read_text(encoding="utf-8")))) == slugs


@pytest.mark.parametrize(
    "text",
    [
        'match run.entry.slug:\n    case "liang_barsky":\n        pass',
        'if slug == "liang_barsky":\n    pass',
        'if slug in ("de_boor", "liang_barsky"):\n    pass',
        'slug.startswith("liang_barsky")',
    ],
)
def test_the_rule_finds_a_decision(text: str) -> None:
    assert "liang_barsky" in [slug for node in decisions(ast.parse(text)) for slug in slugs_in(node)]


@pytest.mark.parametrize(
    "text",
    [
        'moment.variables["u1"]',
        'run.own_call().variables.get("u1", 0.0)',
        'recording.after(event)["u1"]',
        'variables_at(recording, event)["u1"]',
    ],
)
def test_the_rule_finds_a_variable(text: str) -> None:
    assert list(variables_read(ast.parse(text))) == ["u1"]
