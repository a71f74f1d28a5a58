"""The notation of formulas: plain text such as ``x_p(1 - cos theta) + y_p sin theta``, read into pieces.

A name of one or two letters is a variable (italic), one of Greek letters is that letter, ``sin`` and its like
are functions; longer names and "what stands in quotes" are words. ``_`` and ``^`` lower and raise the name or
number that follows, or what stands in braces. Whatever the text, nothing of it is dropped.
"""

import re
from functools import lru_cache
from typing import Literal, NamedTuple

Kind = Literal["variable", "number", "function", "word", "operator", "sign", "comma", "mark", "open", "close"]

GREEK = {
    name: letter
    for names, letters in (
        (
            "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau "
            "upsilon phi chi psi omega",
            "αβγδεζηθικλμνξπρστυφχψω",
        ),
        ("Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega", "ΓΔΘΛΞΠΣΦΨΩ"),
    )
    for name, letter in zip(names.split(), letters, strict=True)
}
_FUNCTIONS = "sin cos tan cot arcsin arccos arctan atan2 log ln exp sqrt min max det floor"
FUNCTIONS = frozenset(_FUNCTIONS.split())
_OPERATORS = {"-": "−", "*": "·", "<=": "≤", ">=": "≥", "!=": "≠", "->": "→", "...": "…"}
_OPENING, _CLOSING, _MARKS = "([{", ")]}", "′°%…|?_^"
_LETTERS_OF_A_VARIABLE = 2

_TOKEN = re.compile(
    r"""(?P<space>\s+)|"(?P<quoted>[^"]*)"|(?P<number>\d+(?:\.\d+)?(?:e[+-]?\d+)?)|(?P<name>atan2|[^\W\d_]+)
    |(?P<script>[_^])|(?P<operator><=|>=|!=|->|\.\.\.|.)""",
    re.VERBOSE | re.DOTALL,
)
_LOWERED = re.compile(r"[^\W_]+|.", re.DOTALL)


class Piece(NamedTuple):
    """One run of a formula, with what is lowered and raised behind it; ``spaced``: a blank came before."""

    text: str
    kind: Kind
    below: "Formula" = ()
    above: "Formula" = ()
    spaced: bool = False


Formula = tuple[Piece, ...]


@lru_cache(maxsize=512)
def parse(text: str) -> Formula:
    """The pieces of ``text``, left to right."""
    pieces: list[Piece] = []
    at, spaced = 0, False
    while at < len(text):
        token = _TOKEN.match(text, at)
        assert token is not None, "the last alternative takes any character"
        at = token.end()
        if token["space"]:
            spaced = True
        elif token["script"] and pieces and at < len(text) and not text[at].isspace():
            script, at = _script(text, at)
            last = pieces[-1]
            lowered = token["script"] == "_"
            pieces[-1] = (
                last._replace(below=(*last.below, *script))
                if lowered
                else last._replace(above=(*last.above, *script))
            )
        else:
            pieces.append(_piece(token, pieces[-1] if pieces else None, spaced))
            spaced = False
    return tuple(pieces)


def _script(text: str, at: int) -> tuple[Formula, int]:
    """What is lowered or raised from ``at`` on, and where it ends."""
    if text[at] != "{":
        run = _LOWERED.match(text, at)
        assert run is not None, "there is a character"
        return parse(run[0]), run.end()
    depth = 0
    for end in range(at, len(text)):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if not depth:
            return parse(text[at + 1 : end]), end + 1
    return parse(text[at + 1 :]), len(text)


def _piece(token: re.Match[str], before: Piece | None, spaced: bool) -> Piece:
    if token["quoted"] is not None:
        return Piece(token["quoted"], "word", spaced=spaced)
    if token["number"]:
        return Piece(token["number"].replace("-", "−"), "number", spaced=spaced)
    text = token[0]
    if token["name"]:
        return Piece(GREEK.get(text, text), _kind_of_name(text), spaced=spaced)
    if text in _OPENING:
        return Piece(text, "open", spaced=spaced)
    if text in _CLOSING:
        return Piece(text, "close", spaced=spaced)
    if text in ",;":
        return Piece(text, "comma", spaced=spaced)
    text = _OPERATORS.get(text, "′" if text == "'" else text)
    if text in _MARKS:
        return Piece(text, "mark", spaced=spaced)
    starts = before is None or before.kind in ("operator", "sign", "open", "comma")
    if text in "−+±" and starts:
        return Piece(text, "sign", spaced=spaced)
    return Piece(text, "operator", spaced=spaced)


def _kind_of_name(name: str) -> Kind:
    if name in FUNCTIONS:
        return "function"
    return "variable" if name in GREEK or len(name) <= _LETTERS_OF_A_VARIABLE else "word"


def parted(before: Piece | None, piece: Piece) -> bool:
    """Whether a gap parts two pieces: around operators and functions, and where there was a blank."""
    if before is None or piece.kind in ("comma", "close") or "/" in (before.text, piece.text):
        return False
    if "operator" in (before.kind, piece.kind) or before.kind == "comma":
        return True
    if before.kind in ("open", "sign") or (piece.kind == "open" and not piece.spaced):
        return False
    return piece.spaced or "function" in (before.kind, piece.kind)
