"""Where in a JSON text a byte lies: the path of the field around it, for errors that only know the byte."""

import re

from workbench.language import LONGEST_NAME, legible

_DEEPEST = 32
_TEXT = rb'"(?:[^"\\]++|\\.)*+'
_FLAT = rb'(?:[^{}\[\]"]++|' + _TEXT + rb'")*+'
# A list or an object with no other in it is one token, and so are commas with nothing but numbers between
# them: a file has a hundred times as many bytes as such tokens.
_TOKEN = re.compile(
    rb"\{" + _FLAT + rb"\}|\[" + _FLAT + rb"\]|" + _TEXT + rb'(?:"|\Z)|,[^{}\[\]":]*+|[{}\[\]:]', re.DOTALL
)


def path_at(text: bytes, offset: int) -> str:
    """Path, such as ``document.sheets[0].name``, of the value around byte ``offset``; empty outermost."""
    keys: list[str | int] = []
    string = ""
    for token in _TOKEN.finditer(text, 0, max(0, min(offset, len(text)))):
        symbol = token.group()
        if len(symbol) > 1 and symbol[:1] in (b"{", b"["):
            continue
        if symbol[:1] == b'"':
            string = legible(symbol[: 8 * LONGEST_NAME].strip(b'"').decode("utf-8", "replace"))
        elif symbol in (b"{", b"["):
            keys.append("" if symbol == b"{" else 0)
        elif symbol in (b"}", b"]"):
            del keys[-1:]
        elif keys and symbol == b":" and isinstance(keys[-1], str):
            keys[-1] = string
        elif keys and symbol[:1] == b",":
            last = keys[-1]
            keys[-1] = last + symbol.count(b",") if isinstance(last, int) else ""
    return joined(keys)


def joined(keys: list[str | int]) -> str:
    """The text form of a path of names and indices."""
    text = ""
    for key in keys[:_DEEPEST]:
        if isinstance(key, int):
            text += f"[{key}]"
        elif key:
            text += f".{key}" if text else key
    return text if len(keys) <= _DEEPEST else text + "…"


def line_of(text: bytes, offset: int) -> int:
    """Number of the line that byte ``offset`` is on, from 1."""
    return text.count(b"\n", 0, offset) + 1
