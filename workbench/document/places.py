"""Where in a JSON text a byte lies: the path of the field around it, for errors that only know the byte."""

import re

_TOKEN = re.compile(rb'"(?:[^"\\]|\\.)*(?:"|\Z)|[{}\[\],:]', re.DOTALL)


def path_at(text: bytes, offset: int) -> str:
    """Path, such as ``document.sheets[0].name``, of the value around byte ``offset``; empty outermost."""
    keys: list[str | int] = []
    string = ""
    for token in _TOKEN.finditer(text, 0, max(0, min(offset, len(text)))):
        symbol = token.group()
        if symbol[:1] == b'"':
            string = symbol.strip(b'"').decode("utf-8", "replace")
        elif symbol in (b"{", b"["):
            keys.append("" if symbol == b"{" else 0)
        elif symbol in (b"}", b"]"):
            del keys[-1:]
        elif keys and symbol == b":" and isinstance(keys[-1], str):
            keys[-1] = string
        elif keys and symbol == b",":
            last = keys[-1]
            keys[-1] = last + 1 if isinstance(last, int) else ""
    return joined(keys)


def joined(keys: list[str | int]) -> str:
    """The text form of a path of names and indices."""
    text = ""
    for key in keys:
        if isinstance(key, int):
            text += f"[{key}]"
        elif key:
            text += f".{key}" if text else key
    return text


def line_of(text: bytes, offset: int) -> int:
    """Number of the line that byte ``offset`` is on, from 1."""
    return text.count(b"\n", 0, offset) + 1
