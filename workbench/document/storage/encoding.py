"""The text of a file in pieces, so that neither one call nor one string is as long as the whole.

msgspec holds Python's interpreter for as long as it works. Each piece of figures is made, decoded again and
compared before the next one; a program that saves on a thread goes on between them.
"""

import binascii
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import msgspec
from msgspec.structs import replace

from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Document
from workbench.document.storage.embedding import as_text
from workbench.language import _

# Of the lists and objects that stand in for what comes in pieces: a text never holds a bare line break.
_NO_FIGURES, _NO_BLOBS = b'\n    "figures": []', b'\n "blobs": {}'
_ABSENT = (b',\n    "scene": null', b',\n    "motion": null')
_MOST_POINTS = 1_000
_CHUNK = 3 * 2**16  # a multiple of three bytes, which base64 writes as four

# Made while the module is imported, by one thread: as in ``files``.
_encoder = msgspec.json.Encoder(enc_hook=as_text)
_figures_decoder = msgspec.json.Decoder(list[AnyFigure])


def pieces(file: Any, decoder: msgspec.json.Decoder[Any]) -> Iterator[bytes]:
    """The text of ``file``, a struct with ``document`` and ``blobs`` that ``decoder`` decodes.

    Together they are its JSON with an indent of one. Raises DocumentError where a piece reads back
    differently, or where ``file`` holds what no JSON can.
    """
    document: Document = file.document
    bare = tuple(replace(sheet, figures=()) for sheet in document.sheets)
    frame = replace(file, document=replace(document, sheets=bare), blobs={})
    *heads, last = _proven(frame, decoder).split(_NO_FIGURES)
    for head, sheet in zip(heads, document.sheets, strict=True):
        yield head
        yield b'\n    "figures": ['
        for number, some in enumerate(_parted(sheet.figures)):
            listed = _proven(some, _figures_decoder)
            yield (b"," if number else b"") + listed[1:-2].replace(b"\n", b"\n    ")
        yield b"\n    ]" if sheet.figures else b"]"
    before, after = last.split(_NO_BLOBS)
    yield before
    yield from _blob_pieces(file.blobs)
    yield after + b"\n"


def _parted(figures: Iterable[AnyFigure]) -> Iterator[list[AnyFigure]]:
    """``figures`` in lists with some hundred points each, unless one figure has more."""
    some: list[AnyFigure] = []
    count = 0
    for figure in figures:
        some.append(figure)
        count += len(figure.points_world)
        if count >= _MOST_POINTS:
            yield some
            some, count = [], 0
    if some:
        yield some


def _proven(value: Any, decoder: msgspec.json.Decoder[Any]) -> bytes:
    try:
        text = msgspec.json.format(_encoder.encode(value), indent=1)
        for nothing in _ABSENT:
            text = text.replace(nothing, b"")
        if decoder.decode(text) == value:
            return text
    except (TypeError, ValueError) as error:
        sentence = _("This cannot be put into a file ({reason}).")
        raise DocumentError("", sentence.format(reason=error)) from error
    sentence = _("What was written did not read back the same, so the old file was kept; save again.")
    raise DocumentError("", sentence)


def _blob_pieces(blobs: Mapping[str, bytes]) -> Iterator[bytes]:
    yield b'\n "blobs": {'
    for number, (digest, content) in enumerate(blobs.items()):
        yield b'%s\n  "%s": "' % (b"," if number else b"", digest.encode("ascii"))
        for start in range(0, len(content), _CHUNK):
            yield binascii.b2a_base64(memoryview(content)[start : start + _CHUNK], newline=False)
        yield b'"'
    yield b"\n }" if blobs else b"}"
