"""What can be run: each kind of subject gives the calls that the picture is made of, under its own entry."""

import ast
import pkgutil
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.document import DocumentError
from workbench.document.edits import set_algorithm, set_clipper
from workbench.document.model import Curve, Sheet
from workbench.document.samples.examples import example, examples
from workbench.document.subjects import Subject
from workbench.engine.containers import same
from workbench.rendering import clipper_calls, figure_calls, subjects
from workbench.rendering.comparing import figure_pixels
from workbench.rendering.curve_runs import curve_calls
from workbench.rendering.outline_fill import outline_fill
from workbench.rendering.subjects.registry import (
    calls_of,
    checked,
    compared,
    comparing,
    kind_of,
    known,
    own_entry,
    rivals,
)

PACKAGE = Path(__file__).resolve().parents[2] / "workbench"
KINDS = sorted({module.name for module in pkgutil.iter_modules(subjects.__path__)} - {"registry"})
# What is run of them is set on the tube, or is what the sheet draws, whatever figure is active
OF_A_TUBE = {"colour_model", "comparison", "flicker", "gun", "random_scan", "raster"}
SHEETS = [sheet for one in examples() for sheet in one.document.sheets]


def same_calls(ours: list, theirs: list) -> bool:
    """Whether both run the same entries on equal arguments."""
    return len(ours) == len(theirs) and all(
        one.entry is other.entry
        and one.recursion_limit == other.recursion_limit
        and all(map(same, one.arguments, other.arguments))
        for one, other in zip(ours, theirs, strict=True)
    )


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_is_registered_by_the_module_of_its_name(kind: str) -> None:
    assert known(kind)
    how = kind_of(Subject(kind))
    assert how.title
    assert all(map(catalogue.known, how.entries))
    assert not how.compared_as or known(how.compared_as)
    assert kind in OF_A_TUBE or calls_of(SHEETS[0], Subject(kind)) == []
    assert kind in OF_A_TUBE or calls_of(SHEETS[0], Subject(kind, ("nobody",))) == []


def test_what_nobody_has_registered_is_not_known() -> None:
    for kind in ("registry", "os", "..comparing", ""):
        assert not known(kind)
        with pytest.raises(LookupError):
            kind_of(Subject(kind))


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: sheet.name)
def test_calls_are_those_of_the_pipeline(sheet: Sheet) -> None:
    for figure in sheet.figures[-3:]:
        assert same_calls(calls_of(sheet, Subject("figure", (figure.id,))), figure_calls(sheet, figure))
        assert same_calls(calls_of(sheet, Subject("clipper", (figure.id,))), clipper_calls(sheet, figure))
        at_u = Subject("curve", (figure.id,), arguments={"u": 0.3})
        expected = (
            curve_calls(sheet, figure, "", 0.3) if isinstance(figure, Curve) else figure_calls(sheet, figure)
        )
        assert same_calls(calls_of(sheet, at_u), expected)


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: sheet.name)
@pytest.mark.parametrize("kind", KINDS)
def test_every_choice_can_be_run_and_the_first_is_what_runs(kind: str, sheet: Sheet) -> None:
    for figure in sheet.figures[-2:]:
        subject = Subject(kind, (figure.id,))
        choices = kind_of(subject).choices(sheet, subject)
        calls = calls_of(sheet, subject)
        assert len(set(choices)) == len(choices)
        if calls:
            assert calls[0].entry.slug in choices[:1] or len({call.entry.slug for call in calls}) > 1
        for slug in choices if calls else ():
            assert calls_of(sheet, replace(subject, entry=slug)), slug


def test_an_entry_of_another_kind_of_figure_runs_nothing() -> None:
    sheet = example("line").document.sheets[0]
    (line,) = sheet.figures
    assert calls_of(sheet, Subject("figure", (line.id,), "midpoint_circle")) == []
    assert calls_of(sheet, Subject("clipper", (line.id,), "sutherland_hodgman")) == []


def test_another_algorithm_is_chosen_in_the_document_or_in_the_subject() -> None:
    document = example("clip").document
    sheet = document.sheets[0]
    line = sheet.figures[0].id
    edits = {
        "figure": (set_algorithm(line, "dda_line"), "dda_line"),
        "clipper": (set_clipper(sheet.id, "liang_barsky"), "liang_barsky"),
    }
    for kind, (edit, slug) in edits.items():
        subject = Subject(kind, (line,))
        chosen = kind_of(subject).choose(sheet, subject, slug)
        assert chosen is not None
        assert chosen(document) == edit(document) != document
    curves = example("curve-bezier").document.sheets[0]
    construction = Subject("curve", (curves.figures[-1].id,))
    assert kind_of(construction).choose(curves, construction, "flatten_bezier") is None


def test_a_polygon_can_be_compared_with_a_fill_of_its_outline() -> None:
    sheet = example("triangle").document.sheets[0]
    subject = Subject("figure", (sheet.figures[0].id,))
    assert own_entry(sheet, subject) == "scan_line_crossings"
    assert "boundary_fill_4" in rivals(sheet, subject)
    filled = outline_fill(sheet, sheet.figures[0], "boundary_fill_4")
    under = replace(subject, entry="boundary_fill_4")
    assert same_calls(calls_of(sheet, under), [filled.call])
    painted = {tuple(cell) for cell in comparing(under).painted(sheet, under).tolist()}
    assert painted > {tuple(cell) for cell in filled.outline.tolist()}
    assert np.array_equal(comparing(under).before(sheet, under), filled.outline)


def test_of_a_construction_the_drawing_of_its_curve_is_compared() -> None:
    sheet = example("curve-bezier").document.sheets[0]
    curve = sheet.figures[-1]
    subject = Subject("curve", (curve.id,), "flatten_bezier", {"u": 0.2})
    drawn = compared(subject)
    assert drawn == Subject("figure", (curve.id,))
    assert own_entry(sheet, subject) == curve.drawn_with
    assert np.array_equal(comparing(drawn).painted(sheet, drawn), figure_pixels(sheet, curve))


@pytest.mark.parametrize(
    ("subject", "said"),
    [
        (Subject("flea circus"), "This version of the program cannot step “flea circus”."),
        (Subject("curve", entry="dda_line"), "choose one of hermite_blend"),
        (Subject("curve", arguments={"u": 1.5}), "between 0 and 1"),
        (Subject("curve", arguments={"u": True}), "finite number"),
        (Subject("figure", arguments={"u": 0.5}), "u = 0.5 cannot be given here."),
    ],
)
def test_what_cannot_be_run_is_refused(subject: Subject, said: str) -> None:
    with pytest.raises(DocumentError) as refusal:
        checked(subject)
    assert said in str(refusal.value)


def decisions_on_kinds(tree: ast.AST) -> list[int]:
    """The lines that ask what kind a subject is: comparisons, and what a match looks at."""
    asking = [node for node in ast.walk(tree) if isinstance(node, ast.Compare)]
    asking += [node.subject for node in ast.walk(tree) if isinstance(node, ast.Match)]
    lines = []
    for node in asking:
        named = {each.attr for each in ast.walk(node) if isinstance(each, ast.Attribute)}
        owners = {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
        texts = {each.value for each in ast.walk(node) if isinstance(each, ast.Constant)}
        if "kind" in named and ("subject" in named | owners or texts & set(KINDS)):
            lines.append(node.lineno)
    return lines


@pytest.mark.parametrize("layer", ["rendering", "session", "widgets", "panels", "shell", "exchange"])
def test_nobody_else_decides_by_the_kind_of_a_subject(layer: str) -> None:
    files = [path for path in (PACKAGE / layer).rglob("*.py") if path.parent.name != "subjects"]
    decided = {path.name: decisions_on_kinds(ast.parse(path.read_text("utf-8"))) for path in files}
    assert {name: lines for name, lines in decided.items() if lines} == {}


def test_the_rule_finds_a_decision() -> None:
    assert decisions_on_kinds(ast.parse('if session.subject.kind == "curve":\n    pass')) == [1]
    assert decisions_on_kinds(ast.parse('match subject.kind:\n    case "clipper":\n        pass')) == [1]
    assert decisions_on_kinds(ast.parse("if tool.kind is Line or subject.ids:\n    pass")) == []
