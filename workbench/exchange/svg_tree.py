"""An SVG file as a tree of elements that know their line, read so that no file can do harm.

Nothing outside the file is fetched, entities that expand into others are refused, and size and depth of a
file are bounded.
"""

import re
from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat

from workbench.exchange.svg_styles import declarations
from workbench.language import _

SVG = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"
OWN = "https://graphics-workbench.invalid/figure"
MOST_BYTES = 64 * 2**20
MOST_DEPTH = 200
_LONGEST_ENTITY = 200
# Elements without an <svg> around them, as they are copied from a page; it is put into the line before them.
_FRAGMENT = re.compile(r"\s*<(?:path|g|line|polyline|polygon|rect|circle|ellipse)[\s/>]")
_AROUND = (
    f'<svg xmlns="{SVG}" xmlns:xlink="{XLINK}" xmlns:workbench="{OWN}" '
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
    'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">\n'
).encode()


class SvgError(ValueError):
    """An SVG text was refused: one sentence with the place, and nothing was taken over."""


@dataclass(slots=True)
class Element:
    """One element: its local name (empty outside SVG), attributes and children; line and column from 1.

    Attributes without a namespace have their plain names, XLink's ``href`` too; our own begin with ``own:``.
    ``viewport`` is what 100 % of width and height mean, 0 where that is not known; ``sheet`` what the style
    sheet of the file says about it; ``text`` what stands in a ``style`` element.
    """

    tag: str
    attributes: dict[str, str]
    line: int
    column: int
    children: list["Element"] = field(default_factory=list)
    viewport: tuple[float, float] = (0.0, 0.0)
    sheet: dict[str, str] = field(default_factory=dict)
    text: str = ""

    @property
    def style(self) -> dict[str, str]:
        """Presentation attributes; those of the ``style`` attribute win, then those of the style sheet."""
        return {**self.attributes, **self.sheet, **declarations(self.attributes.get("style", ""))}

    def refusal(self, sentence: str) -> SvgError:
        """The error with ``sentence``, after where this element begins."""
        called = self.attributes.get("id", "")
        name = f"<{self.tag}> {called[:40]!r}" if called else f"<{self.tag}>"
        where = _("Line {line}, column {column}, {name}").format(
            line=self.line, column=self.column, name=name
        )
        return SvgError(f"{where}: {sentence}")


def read_tree(text: str | bytes) -> Element:
    """The outermost element, an ``svg``, which is put around elements that lack it.

    Raises: SvgError with line and column.
    """
    data = text.encode("utf-8", "replace") if isinstance(text, str) else text
    if not data.strip():
        raise SvgError(_("The SVG is empty; choose a file that holds a picture."))
    if len(data) > MOST_BYTES:
        sentence = _("The SVG has {size:,} bytes, and at most {most:,} can be read; choose a smaller one.")
        raise SvgError(sentence.format(size=len(data), most=MOST_BYTES))
    begin = _FRAGMENT.match(text) if isinstance(text, str) else None
    reader = _Reader(expat.ParserCreate("utf-8" if isinstance(text, str) else None, " "), begin is not None)
    try:
        if begin:
            reader.parser.Parse(_AROUND, False)
        reader.parser.Parse(data, not begin)
        if begin:
            reader.parser.Parse(b"</svg>", True)
    except expat.ExpatError as error:
        sentence = _("the XML is broken ({reason}); correct it there.")
        raise _at(
            error.lineno - reader.added, error.offset, sentence.format(reason=expat.ErrorString(error.code))
        ) from error
    except (ValueError, LookupError) as error:
        if isinstance(error, SvgError):
            raise
        raise SvgError(_("The SVG is in a character set that cannot be read; save it as UTF-8.")) from error
    if reader.root is None or reader.root.tag != "svg":
        raise SvgError(_("This is XML, but no SVG: its outermost element is not <svg>; choose another file."))
    return reader.root


def _at(line: int, column: int, sentence: str) -> SvgError:
    where = _("Line {line}, column {column}").format(line=line, column=column + 1)
    return SvgError(f"{where}: {sentence}")


class _Reader:
    """Builds the tree from what the parser tells."""

    def __init__(self, parser: Any, fragment: bool) -> None:
        self.parser = parser
        self.added = int(fragment)
        self.root: Element | None = None
        self._open: list[Element] = []
        parser.StartElementHandler = self._begin
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._text
        parser.EntityDeclHandler = self._entity
        parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)

    def _begin(self, name: str, attributes: dict[str, str]) -> None:
        namespace, _blank, local = name.rpartition(" ")
        line, column = self.parser.CurrentLineNumber - self.added, self.parser.CurrentColumnNumber
        if len(self._open) >= MOST_DEPTH:
            sentence = _("elements are nested more than {most} deep; ungroup some.").format(most=MOST_DEPTH)
            raise _at(line, column, sentence)
        named = {_attribute(key): value for key, value in attributes.items()}
        element = Element(local if namespace in (SVG, "") else "", named, line, column + 1)
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _end(self, name: str) -> None:
        self._open.pop()

    def _text(self, text: str) -> None:
        if self._open and self._open[-1].tag == "style":
            self._open[-1].text += text

    def _entity(self, name: str, parameter: bool, value: str | None, *outside: str | None) -> None:
        if parameter or value is None or len(value) > _LONGEST_ENTITY or re.search("[&%<]", value):
            sentence = _("entity {name!r} would expand into something else; write it out.")
            line, column = self.parser.CurrentLineNumber - self.added, self.parser.CurrentColumnNumber
            raise _at(line, column, sentence.format(name=name[:40]))


def _attribute(key: str) -> str:
    namespace, _blank, local = key.rpartition(" ")
    if namespace == OWN:
        return f"own:{local}"
    return local if namespace in ("", XLINK) else key
