"""A picture comes back from its file as it was, and what is wrong in one is refused by its name."""

import base64
import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from msgspec.structs import replace

from tests.document.made_documents import documents
from tests.document.storage.content_of_a_file import written_example
from workbench.document import DocumentError, Stored, load, read, save, write
from workbench.document.edits import add_sheet, set_algorithm, set_attribute
from workbench.document.model import Document, Polygon
from workbench.document.samples.examples import example_document
from workbench.document.state import SessionState, TubeSettings
from workbench.document.storage.files import VERSION, decode, encode, upgraded
from workbench.document.subjects import Position, Subject
from workbench.rendering import frame_buffer

SAMPLES = Path(__file__).parents[1] / "samples"


@given(documents())
def test_every_document_comes_back_as_it_was(document: Document) -> None:
    assert decode(encode(Stored(document))) == Stored(document)


def test_session_and_blobs_come_back(tmp_path: Path) -> None:
    content = b"a mesh" * 1000
    stored = Stored(
        example_document(),
        SessionState(
            sheet="s1",
            selection=("f1",),
            active="f1",
            compare="dda_line",
            workspace="clip",
            positions={
                "clip": Position(Subject("clipper", ("f1",), "liang_barsky"), 4, detail=True),
                "curves": Position(Subject("curve", arguments={"u": 0.25, "name": "P", "at": (1.0, 2.5)})),
            },
            ask_first=True,
            tube=TubeSettings("vector", "P7", time_s=1.25),
        ),
        {hashlib.sha256(content).hexdigest(): content},
        origin="/somewhere/else.gwb",
    )
    write(stored, tmp_path / "a.gwb")
    assert read(tmp_path / "a.gwb") == stored


def test_the_text_is_readable(tmp_path: Path) -> None:
    save(example_document(), tmp_path / "a.gwb")
    text = (tmp_path / "a.gwb").read_text("utf-8")
    raw = json.loads(text)
    assert list(raw) == ["format", "version", "document", "session", "blobs"]
    assert (raw["format"], raw["version"]) == ("graphics-workbench", VERSION)
    assert '    "name": "A line",\n    "width_px": 40,\n' in text


STEPPED = {
    1: ("figure", 3),
    2: ("clipper", 3),
    3: ("curve", 3),
    4: ("clipper", 7),
    5: ("curve", 3),
    6: ("curve", 3),
    7: ("curve", 3),
    8: ("curve", 3),
}


@pytest.mark.parametrize("version", range(1, VERSION + 1))
def test_a_sample_of_every_version_opens(version: int) -> None:
    stored = read(SAMPLES / f"version-{version}.gwb")
    kinds = ["Line", "Polyline", "Circle", "Ellipse", "SeedFill"]
    kinds += ["Polygon"] * (version > 1) + ["Curve"] * 3 * (version > 2)
    assert [type(figure).__name__ for figure in stored.document.sheets[0].figures] == kinds
    assert stored.session.compare == "dda_line"
    assert (stored.session.subject.kind, stored.session.step) == STEPPED[version]
    assert list(stored.blobs.values()) == [b"blob"]
    assert decode(encode(stored)) == stored


def test_the_sample_of_version_7_has_a_named_view() -> None:
    scene = read(SAMPLES / "version-7.gwb").document.sheets[0].scene
    assert scene is not None
    assert [(view.name, view.camera.projection) for view in scene.named_views] == [
        ("From above", "isometric")
    ]


@pytest.mark.parametrize("version", range(2, 8))
def test_polygons_of_older_versions_are_drawn_as_they_were(version: int) -> None:
    raw = json.loads((SAMPLES / f"version-{version}.gwb").read_text("utf-8"))
    raw["session"]["compare"] = "scan_line_fill"
    if version > 3:
        raw["session"]["positions"]["fill"] = {"subject": {"kind": "figure", "entry": "scan_line_fill"}}
    stored = decode(json.dumps(raw).encode())
    polygons = [figure for figure in stored.document.sheets[0].figures if isinstance(figure, Polygon)]
    assert [polygon.algorithm for polygon in polygons] == ["scan_line_exact"]
    assert stored.session.compare == "scan_line_exact"
    if version > 3:
        assert stored.session.positions["fill"].subject.entry == "scan_line_exact"


def test_since_version_8_the_fill_of_the_course_keeps_its_name() -> None:
    raw = json.loads((SAMPLES / "version-8.gwb").read_text("utf-8"))
    figures = raw["document"]["sheets"][0]["figures"]
    (polygon,) = [each for each in figures if "ring_ends" in each]
    assert polygon["algorithm"] == "scan_line_exact"
    polygon["algorithm"] = raw["session"]["compare"] = "scan_line_fill"
    stored = decode(json.dumps(raw).encode())
    kept = [each for each in stored.document.sheets[0].figures if isinstance(each, Polygon)]
    assert [each.algorithm for each in kept] == ["scan_line_fill"]
    assert stored.session.compare == "scan_line_fill"


def test_what_version_3_stepped_stands_in_the_workspaces_that_step_it() -> None:
    session = read(SAMPLES / "version-3.gwb").session
    at_u = Subject("curve", entry="de_boor", arguments={"u": 0.25})
    assert session.workspace == "curves"
    assert session.positions == {
        "draw": Position(),
        "fill": Position(),
        "clip": Position(Subject("clipper")),
        "curves": Position(at_u, 3),
    }
    raw = json.loads((SAMPLES / "version-3.gwb").read_text("utf-8"))
    raw["session"] |= {"stepped": "figure", "step": 12, "detail": True}
    session = decode(json.dumps(raw).encode()).session
    assert session.positions["draw"] == session.positions["fill"] == Position(step=12, detail=True)
    assert session.positions["curves"] == Position(at_u)


@pytest.mark.parametrize("damage", [{"stepped": "dance"}, {"stepped": []}, {"step": "3"}, {"curve_u": {}}])
def test_a_damaged_version_3_is_refused(damage: dict[str, Any]) -> None:
    raw = json.loads((SAMPLES / "version-3.gwb").read_text("utf-8"))
    raw["session"] |= damage
    with pytest.raises(DocumentError):
        decode(json.dumps(raw).encode())


def test_versions_are_upgraded_one_after_the_other() -> None:
    steps = {1: lambda raw: {**raw, "a": 1}, 2: lambda raw: {**raw, "b": raw["a"] + 1}}
    assert upgraded({"version": 1}, 1, steps, 3) == {"version": 3, "a": 1, "b": 2}
    with pytest.raises(DocumentError, match="version"):
        upgraded({"version": 2}, 2, steps, 3)
    with pytest.raises(DocumentError, match="version"):
        upgraded({"version": 0}, 0, steps, 3)


def _put(raw: dict[str, Any], path: list[str | int], value: Any) -> bytes:
    at: Any = raw
    for step in path[:-1]:
        at = at[step]
    at[path[-1]] = value
    return json.dumps(raw).encode()


SHEET: list[str | int] = ["document", "sheets", 0]

FIGURE: list[str | int] = [*SHEET, "figures", 0]


@pytest.mark.parametrize(
    ("path", "value", "field"),
    [
        ([*FIGURE, "radius_world"], "12", "sheets[0].figures[0].radius_world"),
        ([*FIGURE, "radius_world"], None, "sheets[0].figures[0].radius_world"),
        ([*FIGURE, "radius_world"], -1, "sheets[0].figures[0].radius_world"),
        ([*FIGURE, "radius_world"], float("nan"), "sheets[0].figures[0].radius_world"),
        ([*FIGURE, "radius_world"], float("inf"), "sheets[0].figures[0].radius_world"),
        ([*FIGURE, "radius_world"], float("-inf"), "sheets[0].figures[0].radius_world"),
        ([*FIGURE, "radius_world"], 10**400, "sheets[0].figures[0].radius_world"),
        ([*FIGURE, "points_world", 0, "x"], 1e7, "sheets[0].figures[0].points_world[0].x"),
        ([*FIGURE, "points_world", 0, "z"], 1, "sheets[0].figures[0].points_world[0].z"),
        ([*FIGURE, "points_world"], [], "sheets[0].figures[0].points_world"),
        ([*FIGURE, "kind"], "spiral", "sheets[0].figures[0].kind"),
        ([*FIGURE, "algorithm"], "dda_line", "sheets[0].figures[0].algorithm"),
        ([*FIGURE, "colour"], 44, "sheets[0].figures[0].colour"),
        ([*FIGURE, "colour"], 1.5, "sheets[0].figures[0].colour"),
        ([*FIGURE, "colour"], 10**40, "sheets[0].figures[0].colour"),
        ([*FIGURE, "id"], "f2", "sheets[0].figures[1].id"),
        ([*FIGURE, "id"], "f/2", "sheets[0].figures[0].id"),
        ([*FIGURE, "visible"], 1, "sheets[0].figures[0].visible"),
        ([*SHEET, "width_px"], 4097, "sheets[0].width_px"),
        ([*SHEET, "width_px"], 0, "sheets[0].width_px"),
        ([*SHEET, "height_px"], [1], "sheets[0].height_px"),
        ([*SHEET, "palette", 3], 2**24, "sheets[0].palette[3]"),
        ([*SHEET, "views", 0, "window_world", "xmin"], 1e6, "sheets[0].views[0].window_world"),
        ([*SHEET, "name"], "\ud800", "sheets[0].name"),
        ([*SHEET, "scenery"], {}, "sheets[0].scenery"),
        ([*SHEET, "scene"], {"fog": 1}, "sheets[0].scene.fog"),
        (["document", "sheets"], [], "sheets"),
        (["document", "last_id"], -1, "last_id"),
        (["document"], [], "document"),
        (["session", "active"], "f9", "session.active"),
        (["session", "selection"], ["f1", "f9"], "session.selection[1]"),
        (["session", "sheet"], "s9", "session.sheet"),
        (["session", "positions"], {"draw": {"step": -1}}, "session.positions.draw.step"),
        (["session", "positions"], {"draw": {"step": "1"}}, "session.positions.step"),
        (
            ["session", "positions"],
            {"draw": {"subject": {"kind": ""}}},
            "session.positions.draw.subject.kind",
        ),
        (
            ["session", "positions"],
            {"draw": {"subject": {"ids": ["f1", "f9"]}}},
            "session.positions.draw.subject.ids[1]",
        ),
        (
            ["session", "positions"],
            {"draw": {"subject": {"arguments": {"u": 1e999}}}},
            "session.positions.draw.subject.arguments.u",
        ),
        (["session", "positions"], {"a/b": {}}, "session.workspace"),
        (["session", "workspace"], 3, "session.workspace"),
        (["session", "compare"], "de casteljau", "session.compare"),
        (["session", "tube", "refresh_hz"], 0, "session.tube.refresh_hz"),
        (["session", "tube", "phosphor"], 31, "session.tube.phosphor"),
        (["version"], VERSION + 1, "version"),
        (["version"], 10**30, "version"),
        (["version"], 0, "version"),
        (["version"], "1", "version"),
        (["format"], "graphics", "format"),
        (["blobs"], {"ab": "AAAA"}, "blobs.ab"),
        (["blobs"], {"ab": "?"}, "blobs"),
        (["more"], 1, "more"),
    ],
)
def test_one_wrong_field_is_refused_by_its_name(path: list[str | int], value: Any, field: str) -> None:
    with pytest.raises(DocumentError) as refusal:
        decode(_put(written_example(), path, value))
    assert refusal.value.field == field
    assert field in str(refusal.value)
    assert str(refusal.value).endswith(".")
    assert "`" not in str(refusal.value)


def test_an_algorithm_of_a_newer_version_is_kept_and_the_default_draws() -> None:
    named = json.loads(_put(written_example(), [*FIGURE, "algorithm"], "circle_of_tomorrow"))
    newer = _put(named, ["session", "compare"], "other_circle")
    document = decode(newer).document
    figure = document.sheets[0].figures[0]
    assert (figure.algorithm, figure.drawn_with) == ("circle_of_tomorrow", "midpoint_circle")
    assert decode(encode(decode(newer))) == decode(newer)
    plain = decode(json.dumps(written_example()).encode()).document.sheets[0]
    assert np.array_equal(frame_buffer(document.sheets[0]), frame_buffer(plain))
    address = f"{document.sheets[0].id}/{figure.id}/radius_world"
    enlarged = set_attribute(address, 3.0)(document).sheets[0].figures[0]
    assert enlarged.algorithm == "circle_of_tomorrow"


def test_an_edit_chooses_only_what_there_is() -> None:
    document = decode(json.dumps(written_example()).encode()).document
    figure = document.sheets[0].figures[0].id
    for slug in ("circle_of_tomorrow", "dda_line"):
        with pytest.raises(DocumentError, match="choose one of midpoint_circle, circle_fill"):
            set_algorithm(figure, slug)(document)


def test_a_missing_field_is_named() -> None:
    for path, field in [([*FIGURE], "radius_world"), (SHEET, "name"), ([], "document"), ([], "format")]:
        raw = written_example()
        at: Any = raw
        for step in path:
            at = at[step]
        del at[field]
        with pytest.raises(DocumentError) as refusal:
            decode(json.dumps(raw).encode())
        assert refusal.value.field.endswith(field)


def test_a_document_that_is_not_sound_is_not_written(tmp_path: Path) -> None:
    save(example_document(), tmp_path / "a.gwb")
    with pytest.raises(DocumentError):
        save(Document(()), tmp_path / "a.gwb")
    with pytest.raises(DocumentError):
        write(Stored(example_document(), SessionState(active="f9")), tmp_path / "a.gwb")
    with pytest.raises(DocumentError):
        write(Stored(example_document(), blobs={"0" * 64: b""}), tmp_path / "a.gwb")
    assert load(tmp_path / "a.gwb") == example_document()


def test_base64_is_what_it_says() -> None:
    content = bytes(range(256))
    raw = json.loads(encode(Stored(example_document(), blobs={hashlib.sha256(content).hexdigest(): content})))
    assert base64.b64decode(next(iter(raw["blobs"].values()))) == content


@pytest.mark.parametrize("spent", ["last_id", "figure", "point", "sheet"])
def test_a_file_whose_ids_are_spent_can_be_worked_on(spent: str) -> None:
    document = example_document()
    (sheet,) = document.sheets
    line = sheet.figures[0]
    if spent == "last_id":
        document = replace(document, last_id=999_999_999_999_999)
    elif spent == "figure":
        line = replace(line, id="f999999999999999")
    elif spent == "point":
        points = (replace(line.points_world[0], id="p999999999999999"), *line.points_world[1:])
        line = replace(line, points_world=points)
    else:
        sheet = replace(sheet, id="s999999999999999")
    document = replace(document, sheets=(replace(sheet, figures=(line,)),))
    named = Subject("figure", (line.id, line.points_world[0].id))
    state = SessionState(
        sheet=sheet.id, selection=(line.id,), active=line.id, positions={"draw": Position(named, 4)}
    )
    stored = decode(encode(Stored(document, state)))
    (again,) = stored.document.sheets
    (figure,) = again.figures
    assert stored.session.sheet == again.id
    assert stored.session.selection == (figure.id,)
    assert stored.session.active == figure.id
    point = figure.points_world[0].id
    assert stored.session.positions == {"draw": Position(Subject("figure", (figure.id, point)), 4)}
    assert (frame_buffer(again) == frame_buffer(sheet)).all()
    assert len(add_sheet(again)(stored.document).sheets) == 2
