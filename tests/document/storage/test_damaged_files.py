"""Files that are damaged, or are no picture at all, are refused in one sentence."""

import hashlib
import json
import os
import stat
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.document.storage.content_of_a_file import written_example
from workbench.document import DocumentError, Stored, load, save
from workbench.document.places import joined, path_at
from workbench.document.samples.examples import example_document, examples
from workbench.document.storage.files import MAX_BYTES, decode, encode


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


def test_half_a_character_at_the_end_is_not_said_to_break_off() -> None:
    begin = b'{"format":"graphics-workbench","version":8,"document":"'
    for end, said in ((b'\\ud800"}', "is not JSON at line 1"), (b"\\ud800", "breaks off at line 1")):
        with pytest.raises(DocumentError, match=said):
            decode(begin + end)


def test_another_kind_of_file_is_not_told_to_end_otherwise() -> None:
    with pytest.raises(DocumentError, match="not a picture of Graphics Workbench; choose another file"):
        decode(b"[" * 10_000)
    with pytest.raises(DocumentError, match=r"not a Graphics Workbench file \(format\); choose one that it"):
        decode(b'{"a": 1}')


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
    raw = written_example()
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


@pytest.mark.parametrize(
    ("broken", "said"), [(b"\xff", "not UTF-8 text"), (b"@", "not JSON"), (b"NaN", "give a finite number")]
)
@pytest.mark.parametrize("deep", [1, 9])
def test_names_as_long_as_a_damaged_file_are_cut(broken: bytes, said: str, deep: int) -> None:
    data = b'{"document": ' + (b'{"%s": ' % (b"rt_device\\t" * 60)) * deep + broken
    with pytest.raises(DocumentError, match=said) as refusal:
        decode(data)
    assert len(str(refusal.value)) < 400
    assert str(refusal.value).endswith(".")
