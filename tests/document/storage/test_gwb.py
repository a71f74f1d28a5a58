"""The file: what is saved is opened again, and what is damaged is refused by naming the field."""

import base64
import hashlib
import json
import os
import stat
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.made_documents import documents
from workbench.document import DocumentError, Stored, load, read, save, write
from workbench.document.edits import add_sheet, set_algorithm, set_attribute
from workbench.document.model import Document
from workbench.document.places import joined, path_at
from workbench.document.samples.examples import example, example_document, examples
from workbench.document.state import SessionState, TubeSettings
from workbench.document.storage.files import MAX_BYTES, VERSION, decode, encode, upgraded
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
            step=4,
            detail=True,
            ask_first=True,
            stepped="clipper",
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


@pytest.mark.parametrize("version", [1, 2, 3, 5])
def test_a_sample_of_every_version_opens(version: int) -> None:
    stored = read(SAMPLES / f"version-{version}.gwb")
    kinds = ["Line", "Polyline", "Circle", "Ellipse", "SeedFill"]
    kinds += ["Polygon"] * (version > 1) + ["Curve"] * 3 * (version > 2)
    assert [type(figure).__name__ for figure in stored.document.sheets[0].figures] == kinds
    assert stored.session.compare == "dda_line"
    assert list(stored.blobs.values()) == [b"blob"]
    assert decode(encode(stored)) == stored


def test_versions_are_upgraded_one_after_the_other() -> None:
    steps = {1: lambda raw: {**raw, "a": 1}, 2: lambda raw: {**raw, "b": raw["a"] + 1}}
    assert upgraded({"version": 1}, 1, steps, 3) == {"version": 3, "a": 1, "b": 2}
    with pytest.raises(DocumentError, match="version"):
        upgraded({"version": 2}, 2, steps, 3)
    with pytest.raises(DocumentError, match="version"):
        upgraded({"version": 0}, 0, steps, 3)


def _example() -> dict[str, Any]:
    raw: dict[str, Any] = json.loads(encode(Stored(example("circles").document)))
    return raw


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
        (["session", "step"], -1, "session.step"),
        (["session", "compare"], "de_casteljau", "session.compare"),
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
        decode(_put(_example(), path, value))
    assert refusal.value.field == field
    assert field in str(refusal.value)
    assert str(refusal.value).endswith(".")
    assert "`" not in str(refusal.value)


def test_an_algorithm_of_a_newer_version_is_kept_and_the_default_draws() -> None:
    named = json.loads(_put(_example(), [*FIGURE, "algorithm"], "circle_of_tomorrow"))
    newer = _put(named, ["session", "compare"], "other_circle")
    document = decode(newer).document
    figure = document.sheets[0].figures[0]
    assert (figure.algorithm, figure.drawn_with) == ("circle_of_tomorrow", "midpoint_circle")
    assert decode(encode(decode(newer))) == decode(newer)
    plain = decode(json.dumps(_example()).encode()).document.sheets[0]
    assert np.array_equal(frame_buffer(document.sheets[0]), frame_buffer(plain))
    address = f"{document.sheets[0].id}/{figure.id}/radius_world"
    enlarged = set_attribute(address, 3.0)(document).sheets[0].figures[0]
    assert enlarged.algorithm == "circle_of_tomorrow"


def test_an_edit_chooses_only_what_there_is() -> None:
    document = decode(json.dumps(_example()).encode()).document
    figure = document.sheets[0].figures[0].id
    for slug in ("circle_of_tomorrow", "dda_line"):
        with pytest.raises(DocumentError, match="choose one of midpoint_circle, circle_fill"):
            set_algorithm(figure, slug)(document)


def test_a_missing_field_is_named() -> None:
    for path, field in [([*FIGURE], "radius_world"), (SHEET, "name"), ([], "document"), ([], "format")]:
        raw = _example()
        at: Any = raw
        for step in path:
            at = at[step]
        del at[field]
        with pytest.raises(DocumentError) as refusal:
            decode(json.dumps(raw).encode())
        assert refusal.value.field.endswith(field)


def test_a_file_that_breaks_off_is_refused_at_every_byte() -> None:
    whole = encode(Stored(example_document()))
    fields = set()
    for length in range(len(whole.rstrip())):
        with pytest.raises(DocumentError) as refusal:
            decode(whole[:length])
        fields.add(refusal.value.field)
    assert "sheets[0].figures[0].points_world[1].y" in fields
    assert "session.tube.phosphor" in fields


@pytest.mark.parametrize(
    "data", [b"", b" \n", b"null", b"[]", b"12", b"{}", b'"text"', b"[" * 100_000, b"\x00" * 50]
)
def test_what_is_no_picture_is_refused(data: bytes) -> None:
    with pytest.raises(DocumentError):
        decode(data)


def test_text_that_is_not_utf_8_is_refused_where_it_is_not() -> None:
    data = encode(Stored(example_document())).replace(b"A line", b"A l\xffne")
    with pytest.raises(DocumentError) as refusal:
        decode(data)
    assert refusal.value.field == "sheets[0].name"


def test_a_byte_order_mark_does_no_harm() -> None:
    assert decode(b"\xef\xbb\xbf" + encode(Stored(example_document()))).document == example_document()


BYTES = [
    encode(Stored(one.document, blobs={hashlib.sha256(b"x").hexdigest(): b"x"})) for one in examples()[:3]
]


def _decodes_or_refuses(data: bytes) -> None:
    said = ""
    try:
        decode(data)
    except DocumentError as error:
        said = str(error)
    assert not said or said.endswith(".")


@settings(max_examples=300)
@given(
    st.sampled_from(BYTES),
    st.lists(
        st.tuples(st.floats(0, 1, exclude_max=True), st.binary(max_size=4), st.integers(0, 6)), max_size=4
    ),
)
def test_whatever_is_damaged_raises_nothing_but_a_document_error(
    data: bytes, damages: list[tuple[float, bytes, int]]
) -> None:
    for at, new, removed in damages:
        start = int(at * len(data))
        data = data[:start] + new + data[start + removed :]
    _decodes_or_refuses(data)


@settings(max_examples=150)
@given(
    st.lists(
        st.sampled_from(["document", "sheets", 0, "figures", "session", "tube", "blobs", "points_world", "x"])
    ),
    st.recursive(
        st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
        lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
        max_leaves=6,
    ),
)
def test_whatever_value_stands_anywhere_raises_nothing_but_a_document_error(
    path: list[Any], value: Any
) -> None:
    raw = _example()
    at: Any = raw
    for step in path:
        try:
            at[step]
        except (KeyError, IndexError, TypeError):
            break
        if not isinstance(at[step], (dict, list)) or step == path[-1]:
            at[step] = value
            break
        at = at[step]
    _decodes_or_refuses(json.dumps(raw).encode("utf-8", "surrogatepass"))


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "none.gwb", tmp_path / ("n" * 300), "bad\0name"):
        with pytest.raises(DocumentError):
            load(path)
    for path in (tmp_path, tmp_path / "no folder" / "a.gwb", tmp_path / ("n" * 300), "bad\0name"):
        with pytest.raises(DocumentError):
            save(example_document(), path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with a name")
def test_a_pipe_is_refused_and_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(DocumentError):
        load(tmp_path / "pipe")
    with pytest.raises(DocumentError):
        save(example_document(), tmp_path / "pipe")
    assert stat.S_ISFIFO((tmp_path / "pipe").stat().st_mode)


def test_a_file_of_absurd_size_is_not_even_read(tmp_path: Path) -> None:
    with open(tmp_path / "huge.gwb", "wb") as file:
        file.truncate(MAX_BYTES + 1)
    with pytest.raises(DocumentError, match=f"{MAX_BYTES + 1:,}"):
        load(tmp_path / "huge.gwb")


@pytest.mark.parametrize("call", ["os.stat", "builtins.open"])
def test_a_file_that_may_not_be_read_is_refused(
    call: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save(example_document(), tmp_path / "a.gwb")

    def denied(*_args: Any, **_kwargs: Any) -> None:
        raise PermissionError(13, "Permission denied")

    with monkeypatch.context() as patch:
        patch.setattr(call, denied)
        with pytest.raises(DocumentError, match="permissions"):
            load(tmp_path / "a.gwb")


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


def _path_sign_by_sign(text: str, offset: int) -> list[str | int]:
    """The path at an offset of a JSON text without escapes, as one would find it with a finger."""
    keys: list[str | int] = []
    word, in_word = "", False
    for sign in text[:offset]:
        if sign == '"':
            word, in_word = ("", True) if not in_word else (word, False)
        elif in_word:
            word += sign
        elif sign in "{[":
            keys.append("" if sign == "{" else 0)
        elif sign in "}]":
            keys.pop()
        elif sign == ":":
            keys[-1] = word
        elif sign == ",":
            last = keys[-1]
            keys[-1] = last + 1 if isinstance(last, int) else ""
    return keys


JSON = st.recursive(
    st.integers(-9, 999) | st.text("ab,:[]{} ", max_size=4) | st.none(),
    lambda inner: (
        st.lists(inner, max_size=5) | st.dictionaries(st.text("xyz,[{", max_size=3), inner, max_size=4)
    ),
    max_leaves=25,
)


@given(JSON, st.floats(0, 1), st.sampled_from([None, 1]))
def test_the_place_of_any_byte_is_found(value: Any, share: float, indent: int | None) -> None:
    text = json.dumps(value, indent=indent)
    offset = round(share * len(text))
    assert path_at(text.encode(), offset) == joined(_path_sign_by_sign(text, offset))


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
    state = SessionState(sheet=sheet.id, selection=(line.id,), active=line.id)
    stored = decode(encode(Stored(document, state)))
    (again,) = stored.document.sheets
    (figure,) = again.figures
    assert stored.session.sheet == again.id
    assert stored.session.selection == (figure.id,)
    assert stored.session.active == figure.id
    assert (frame_buffer(again) == frame_buffer(sheet)).all()
    assert len(add_sheet(again)(stored.document).sheets) == 2
