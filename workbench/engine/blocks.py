"""The titled blocks of an algorithm's text.

A comment on a line of its own opens a block, and its first line is the title. The block reaches to the
next title at the same or a smaller indentation, and to the end of the lines indented like it. A title
further in opens a block inside. The header of a loop that holds titled blocks belongs to no block, nor
does what follows such a loop at the same indentation before the next title.
"""

import functools
import inspect
import io
import tokenize
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Block:
    """One titled block. Lines are numbers in the source file; ``lines`` are those that belong to it alone."""

    title: str
    title_line: int
    lines: tuple[int, ...]

    @property
    def first_line(self) -> int:
        """The first line of code."""
        return self.lines[0]

    @property
    def last_line(self) -> int:
        """The last line of code."""
        return self.lines[-1]


@dataclass(frozen=True, slots=True)
class _Line:
    """A logical line of the text, or the first line of a comment (then with a title)."""

    first: int
    last: int
    indent: int
    word: str
    title: str = ""


@functools.cache
def blocks(function: Callable[..., Any]) -> tuple[Block, ...]:
    """The titled blocks of ``function``, from top to bottom. OSError: its source cannot be found."""
    source, start = inspect.getsourcelines(function)
    text = _logical_lines("".join(source), start - 1)
    found: list[tuple[_Line, list[int]]] = []
    open_blocks: list[tuple[int, list[int]]] = []
    for number, line in enumerate(text):
        closes = bool(line.title) or _holds_titles(text, number)
        while open_blocks and open_blocks[-1][0] >= line.indent + (not closes):
            open_blocks.pop()
        if line.title:
            found.append((line, []))
            open_blocks.append((line.indent, found[-1][1]))
        elif open_blocks and not closes:
            open_blocks[-1][1].extend(range(line.first, line.last + 1))
    return tuple(Block(line.title, line.first, tuple(own)) for line, own in found if own)


def loop_headers(function: Callable[..., Any]) -> frozenset[int]:
    """The lines of the headers of those loops of ``function`` that hold titled blocks."""
    source, start = inspect.getsourcelines(function)
    text = _logical_lines("".join(source), start - 1)
    headers = [line for number, line in enumerate(text) if _holds_titles(text, number)]
    return frozenset(number for line in headers for number in range(line.first, line.last + 1))


def block_at(function: Callable[..., Any], line: int) -> Block | None:
    """The block that ``line`` of the source file belongs to, if any."""
    return next((block for block in blocks(function) if line in block.lines), None)


def _holds_titles(text: list[_Line], number: int) -> bool:
    """Whether this line is the header of a loop with a titled block inside."""
    header = text[number]
    if header.title or header.word not in ("for", "while"):
        return False
    for line in text[number + 1 :]:
        if line.indent <= header.indent:
            return False
        if line.title:
            return True
    return False


def _logical_lines(source: str, shift: int) -> list[_Line]:
    """The lines of ``source`` in order, each comment that stands alone as one line with its title."""
    lines: list[_Line] = []
    first: tokenize.TokenInfo | None = None
    comment = -1
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.NEWLINE and first is not None:
            lines.append(_Line(first.start[0] + shift, token.start[0] + shift, first.start[1], first.string))
            first = None
        elif token.type == tokenize.COMMENT and first is None:
            if token.start[0] - 1 != comment:
                line, title = token.start[0] + shift, token.string.lstrip("# ").rstrip()
                lines.append(_Line(line, line, token.start[1], "#", title))
            comment = token.start[0]
        elif first is None and token.type not in _SPACING:
            first = token
    return lines


_SPACING = (
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.COMMENT,
    tokenize.ENDMARKER,
)
