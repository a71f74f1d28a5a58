"""The text of a file is made in pieces: it is what msgspec makes of the whole, and none of them is long."""

import base64
import os
import threading
import tracemalloc
from pathlib import Path

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.made_documents import documents
from tests.document.views import seen_through
from workbench.document import DocumentError, Stored, read, write
from workbench.document.model import Document, Line, WorldPoint
from workbench.document.samples.examples import blank_sheet, example_document
from workbench.document.storage import encoding, files
from workbench.document.storage.blobs import MAX_BLOB_BYTES, Blob
from workbench.document.storage.files import decode, encode

blobs = st.lists(st.binary(max_size=40).map(Blob), max_size=3).map(lambda all: {b.digest: b for b in all})


def many(count: int) -> Document:
    (sheet,) = blank_sheet().sheets
    lines = tuple(
        Line(
            f"f{n}",
            (WorldPoint(f"p{n}-0", n, 1 / 3), WorldPoint(f"p{n}-1", 2.0, n)),
            "dda_line",
            name='"figures": []\n',
        )
        for n in range(count)
    )
    other = replace(
        seen_through(sheet, id="v2"), id="s2", name='x\n    "figures": []\n "blobs": {}', figures=()
    )
    return Document((replace(sheet, figures=lines), other))


@given(documents(), blobs)
def test_the_pieces_are_what_the_whole_is(document: Document, blobs: dict[str, bytes]) -> None:
    stored = Stored(document, blobs=blobs, origin="/a")
    raw = msgspec.json.decode(encode(stored))
    assert msgspec.json.format(msgspec.json.encode(raw), indent=1) + b"\n" == encode(stored)
    assert list(raw) == ["format", "version", "document", "session", "blobs", "origin"]
    whole = msgspec.json.decode(msgspec.json.encode(document))
    for sheet in whole["sheets"]:
        assert sheet.pop("scene") is None
        assert sheet.pop("motion") is None
    assert raw["document"] == whole
    assert {name: base64.b64decode(text) for name, text in raw["blobs"].items()} == blobs


@pytest.mark.parametrize("count", [0, 1, 499, 500, 501, 1700])
def test_many_figures_come_in_several_pieces(count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    stored = Stored(many(count))
    made: list[int] = []
    whole = encoding._proven

    def note(value: object, decoder: object) -> bytes:
        made.append(len(whole(value, decoder)))
        return whole(value, decoder)

    monkeypatch.setattr(encoding, "_proven", note)
    text = encode(stored)
    assert decode(text) == stored
    assert len(made) == 1 + -(-count // 500)
    assert max(made) < 250_000


def test_a_large_blob_is_never_held_as_text(tmp_path: Path) -> None:
    blob = Blob(os.urandom(8 * 2**20))
    stored = Stored(example_document(), blobs={blob.digest: blob})
    write(stored, tmp_path / "a.gwb")
    tracemalloc.start()
    try:
        write(stored, tmp_path / "a.gwb")
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 3 * 2**20
    assert read(tmp_path / "a.gwb") == stored


def test_what_reads_back_differently_never_replaces(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(Stored(example_document()), tmp_path / "a.gwb")
    old = (tmp_path / "a.gwb").read_bytes()
    whole = msgspec.json.format

    def misspell(text: bytes, indent: int) -> bytes:
        return whole(text.replace(b"0.3333333333333333", b"0.3333333333333334"), indent=indent)

    with monkeypatch.context() as patch:
        patch.setattr(msgspec.json, "format", misspell)
        with pytest.raises(DocumentError, match="did not read back the same"):
            write(Stored(many(2)), tmp_path / "a.gwb")
    assert (tmp_path / "a.gwb").read_bytes() == old
    assert [file.name for file in tmp_path.iterdir()] == ["a.gwb"]


def test_what_could_not_be_opened_again_is_not_saved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(files, "MAX_BYTES", 20_000)
    write(Stored(many(10)), tmp_path / "a.gwb")
    with pytest.raises(DocumentError, match="20,000"):
        write(Stored(many(200)), tmp_path / "a.gwb")
    assert read(tmp_path / "a.gwb").document == many(10)


def test_blobs_are_equal_by_their_digest() -> None:
    one, same, other = Blob(b"mesh"), Blob(bytearray(b"mesh")), Blob(b"mess")
    assert one == same
    assert one != other
    assert one == b"mesh"
    assert {one: 1}[same] == 1
    assert len({one.digest, same.digest, other.digest}) == 2
    # It is the digest that is compared: a content that was compared would tell them apart.
    vars(other)["digest"] = one.digest
    assert one == other


def test_a_blob_has_at_most_64_mb(tmp_path: Path) -> None:
    assert MAX_BLOB_BYTES == 64 * 2**20
    content = bytes(MAX_BLOB_BYTES + 1)
    with pytest.raises(
        DocumentError, match="This has 67,108,865 bytes; a picture can keep at most 67,108,864"
    ):
        Blob(content)
    said = (
        "^blobs.0000000000000000… has 67,108,865 bytes, but at most 67,108,864 can be kept; open another copy"
    )
    with pytest.raises(DocumentError, match=said):
        write(Stored(example_document(), blobs={"0" * 64: content}), tmp_path / "a.gwb")
    assert list(tmp_path.iterdir()) == []


def test_several_threads_write_at_once(tmp_path: Path) -> None:
    documents = [many(50 * n) for n in range(1, 5)]
    threads = [
        threading.Thread(target=write, args=(Stored(document), tmp_path / f"{n}.gwb"))
        for n, document in enumerate(documents)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [read(tmp_path / f"{n}.gwb").document for n in range(4)] == documents
