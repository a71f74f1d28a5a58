"""What an algorithm can do and what is drawn of its steps is declared beside it: nothing else knows it.

Outside the catalogue a slug may stand only where one is *chosen*: what new figures begin with, what an
example or a tour shows, which text answers a question. Each such place is listed. Nowhere may slugs be
listed, compared or matched, and what shows a step reads no variable of a text by its name.
"""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

from workbench.algorithms import catalogue

PACKAGE = Path(__file__).resolve().parents[2] / "workbench"
LAYERS = ("panels", "widgets", "rendering", "session")
FILES = sorted(path for path in PACKAGE.rglob("*.py") if PACKAGE / "algorithms" not in path.parents)
DRAWING = [path for path in FILES if path.relative_to(PACKAGE).parts[0] in LAYERS]
SLUGS = {entry.slug for entry in catalogue.entries()}

CHOSEN = {
    # What new figures and sheets begin with
    "document/model.py": {
        "boundary_fill_4",
        "bresenham_line",
        "cohen_sutherland",
        "midpoint_circle",
        "midpoint_ellipse",
        "scan_line_exact",
        "sutherland_hodgman",
    },
    # What an example, and the tour through all of them, shows
    "document/samples/animate.py": {"ellipse_fill"},
    "document/samples/clip.py": {"midpoint_circle"},
    "document/samples/curves.py": {"bresenham_line"},
    "document/samples/examples.py": {
        "bresenham_line",
        "dda_line",
        "midpoint_circle",
        "midpoint_ellipse",
        "midpoint_line",
    },
    "document/samples/figures.py": {"boundary_fill_4", "bresenham_line", "scan_line_exact"},
    "document/samples/viewing.py": {"midpoint_circle"},
    "document/samples/fill.py": {
        "boundary_fill_4",
        "boundary_fill_8",
        "boundary_fill_recursive",
        "midpoint_circle",
        "midpoint_ellipse",
        "scan_line_crossings",
    },
    "document/samples/visibility.py": {"octree_of_solid"},
    "shell/tour.py": {
        "boundary_fill_4",
        "bresenham_line",
        "dda_line",
        "dda_line_fixed",
        "liang_barsky",
    },
    "shell/tour_space.py": {"depth_buffer"},
    # What older files call by another name
    "document/storage/exact_fills.py": {"scan_line_exact", "scan_line_fill"},
    # What a command does unless it is told otherwise
    "cli/commands.py": {"depth_buffer"},
    # Which text answers a question
    "rendering/inside.py": {"inside_outside"},
    "rendering/subjects/chain.py": {"matrix_product", "transform_point"},
    "rendering/subjects/window.py": {"window_to_viewport_point"},
}


def name_of(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


def slugs_in(node: ast.AST) -> Iterator[str]:
    for each in ast.walk(node):
        if isinstance(each, ast.Constant) and each.value in SLUGS:
            yield each.value


def lists(tree: ast.AST) -> Iterator[ast.AST]:
    """What holds several slugs of its own: which these are is for their entries to say."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Tuple | ast.List | ast.Set | ast.Dict):
            items = [*node.keys, *node.values] if isinstance(node, ast.Dict) else node.elts
            if sum(isinstance(item, ast.Constant) and item.value in SLUGS for item in items) > 1:
                yield node


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


class Known(NamedTuple):
    """What a file knows of algorithms: the slugs in it, those it decides by or lists, variables it reads."""

    slugs: frozenset[str]
    decided: list[str]
    listed: list[str]
    variables: list[str]


@cache
def known(path: Path) -> Known:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    slugs = frozenset(slugs_in(tree))
    if not slugs:
        return Known(slugs, [], [], list(variables_read(tree)))
    decided = [slug for node in decisions(tree) for slug in slugs_in(node)]
    listed = [slug for node in lists(tree) for slug in slugs_in(node)]
    return Known(slugs, decided, listed, list(variables_read(tree)))


def test_an_algorithm_is_named_only_where_one_is_chosen() -> None:
    named = {name_of(path): known(path).slugs for path in FILES}
    assert {name: slugs for name, slugs in named.items() if not slugs <= CHOSEN.get(name, set())} == {}


def test_nothing_is_decided_by_which_algorithm_it_is() -> None:
    assert [(name_of(path), known(path).decided) for path in FILES if known(path).decided] == []


def test_algorithms_are_listed_by_their_entries_only() -> None:
    elsewhere = [path for path in FILES if "samples" not in path.parts]  # an example may show several
    assert [(name_of(path), known(path).listed) for path in elsewhere if known(path).listed] == []


def test_no_variable_of_a_text_is_known_where_steps_are_drawn() -> None:
    assert [(name_of(path), known(path).variables) for path in DRAWING if known(path).variables] == []


def test_every_place_that_is_excepted_is_there() -> None:
    for name, slugs in CHOSEN.items():
        (path,) = [path for path in FILES if name_of(path) == name]
        assert known(path).slugs == slugs


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
        'CLIPPERS = ("liang_barsky", "cohen_sutherland")',
        'CLIPPERS = {"liang_barsky": 1, "cohen_sutherland": 2}',
    ],
)
def test_the_rule_finds_a_list(text: str) -> None:
    assert ["liang_barsky" in slugs_in(node) for node in lists(ast.parse(text))] == [True]


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
