"""An SVG file as a tree of elements that know their line, read so that no file can do harm.

Nothing outside the file is fetched, entities that expand into others are refused, and size, depth, number
of elements and what entities add up to are bounded. Only attributes that say what is drawn are kept.
"""

import re
from collections import Counter
from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat

from workbench.document.storage.content import Progress, silent
from workbench.language import _

SVG = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"
OWN = "https://graphics-workbench.invalid/figure"
GEOMETRY = {
    "path": ("d",),
    "line": ("x1", "y1", "x2", "y2"),
    "polyline": ("points",),
    "polygon": ("points",),
    "rect": ("x", "y", "width", "height", "rx", "ry"),
    "circle": ("cx", "cy", "r"),
    "ellipse": ("cx", "cy", "rx", "ry"),
}
INHERITED = (
    "fill",
    "fill-opacity",
    "fill-rule",
    "stroke",
    "stroke-dasharray",
    "stroke-opacity",
    "stroke-width",
    "visibility",
    "color",
    "font-size",
)
# What an element may refer to by these changes how it looks, and no figure has it.
REFERRING = (
    "fill",
    "stroke",
    "clip-path",
    "mask",
    "filter",
    "marker",
    "marker-start",
    "marker-mid",
    "marker-end",
)
PROPERTIES = {*INHERITED, *REFERRING, "display", "opacity", "transform", "transform-origin"}
MOST_BYTES = 16 * 2**20
MOST_ELEMENTS = 100_000
MOST_DEPTH = 200
_MOST_DECLARATIONS = 500
_LONGEST_ENTITY = 200
_LONGEST_NAMESPACE = 500
_CHUNK = 2**20
_READ = {name for names in GEOMETRY.values() for name in names} | PROPERTIES
LAYER = "http://www.inkscape.org/namespaces/inkscape groupmode"
_READ |= {"own:figure", "own:geometry", "own:group", LAYER, "id", "class", "style", "transform", "href"}
_READ |= {"viewBox", "preserveAspectRatio", "systemLanguage", "requiredExtensions"}
# Elements without an <svg> around them, as they are copied from a page; it is put into the line before them.
_FRAGMENT = re.compile(r"\s*<(?:path|g|line|polyline|polygon|rect|circle|ellipse)[\s/>]")
_AROUND = (
    f'<svg xmlns="{SVG}" xmlns:xlink="{XLINK}" xmlns:workbench="{OWN}" '
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
    'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">\n'
).encode()


class SvgError(ValueError):
    """An SVG text was refused: one sentence with the place, and nothing was taken over."""


class UnreadError(SvgError):
    """One element cannot be read and is left out, with all that is in it: a sentence with the place."""


@dataclass(slots=True, eq=False)
class Element:
    """One element: its local name (empty outside SVG), attributes and children; line and column from 1.

    Attributes without a namespace have their plain names, XLink's ``href`` too; our own begin with ``own:``.
    ``viewport`` is what 100 % of width and height mean, ``font_px`` what 1 em is; ``style`` what attributes
    and style sheets say about its look; ``text`` the parts of what stands in a ``style`` element.
    """

    tag: str
    attributes: dict[str, str]
    line: int
    column: int
    children: list["Element"] = field(default_factory=list)
    viewport: tuple[float, float] = (100.0, 100.0)
    font_px: float = 16.0
    style: dict[str, str] = field(default_factory=dict)
    text: list[str] = field(default_factory=list)

    def refusal(self, sentence: str) -> SvgError:
        """The error that refuses the whole file with ``sentence``, after where this element begins."""
        return SvgError(self._with_place(sentence))

    def unread(self, sentence: str) -> UnreadError:
        """The error that leaves out this element, likewise."""
        return UnreadError(self._with_place(sentence))

    def _with_place(self, sentence: str) -> str:
        called = self.attributes.get("id", "")
        tag = self.tag[:40]
        name = f"<{tag}> {called[:40]!r}" if called else f"<{tag}>"
        where = _("Line {line}, column {column}, {name}").format(
            line=self.line, column=self.column, name=name
        )
        return f"{where}: {sentence}"


def read_tree(text: str | bytes, progress: Progress = silent) -> Element:
    """The outermost element, an ``svg``, which is put around elements that lack it.

    Raises: SvgError with line and column.
    """
    if len(text) > MOST_BYTES:
        sentence = _("The SVG has {size:,} bytes, but at most {most:,} can be read; choose a smaller one.")
        raise SvgError(sentence.format(size=len(text), most=MOST_BYTES))
    data = text.encode("utf-8", "replace") if isinstance(text, str) else text
    if not data or data.isspace():
        raise SvgError(_("The SVG is empty; choose a file that contains a picture."))
    begin = _FRAGMENT.match(text) if isinstance(text, str) else None
    parser = expat.ParserCreate("utf-8" if isinstance(text, str) else None, " ")
    reader = _Reader(parser, begin is not None, data.count(b"&"))
    try:
        if begin:
            parser.Parse(_AROUND, False)
        for at in range(0, len(data), _CHUNK):
            progress(at / len(data))
            parser.Parse(data[at : at + _CHUNK], False)
        parser.Parse(b"</svg>" if begin else b"", True)
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
        raise SvgError(_("This is XML but not SVG: its outermost element is not <svg>; choose another file."))
    return reader.root


def all_elements(root: Element) -> list[Element]:
    """``root`` and everything in it, level by level."""
    elements = [root]
    for element in elements:
        elements += element.children
    return elements


def _at(line: int, column: int, sentence: str) -> SvgError:
    where = _("Line {line}, column {column}").format(line=line, column=column + 1)
    return SvgError(f"{where}: {sentence}")


class _Reader:
    """Builds the tree from what the parser tells. ``references`` are the entities that may be named."""

    def __init__(self, parser: Any, fragment: bool, references: int) -> None:
        self.parser = parser
        self.added = int(fragment)
        self.root: Element | None = None
        self._open: list[Element] = []
        self._references = references
        self._counts: Counter[str] = Counter()
        parser.buffer_text = True
        parser.specified_attributes = True
        parser.StartElementHandler = self._begin
        parser.EndElementHandler = self._end
        parser.EntityDeclHandler = self._entity
        parser.AttlistDeclHandler = self._default
        parser.StartNamespaceDeclHandler = self._namespace
        parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)

    def _refusal(self, sentence: str) -> SvgError:
        return _at(self.parser.CurrentLineNumber - self.added, self.parser.CurrentColumnNumber, sentence)

    def _begin(self, name: str, attributes: dict[str, str]) -> None:
        namespace, _blank, local = name.rpartition(" ")
        if len(self._open) >= MOST_DEPTH:
            sentence = _("elements are nested more than {most} deep; ungroup some.").format(most=MOST_DEPTH)
            raise self._refusal(sentence)
        self._counts["element"] += 1
        if self._counts["element"] > MOST_ELEMENTS:
            sentence = _("there are more than {most:,} elements; choose a smaller picture.")
            raise self._refusal(sentence.format(most=MOST_ELEMENTS))
        line, column = self.parser.CurrentLineNumber - self.added, self.parser.CurrentColumnNumber
        named = {key: value for name, value in attributes.items() if (key := _attribute(name)) in _READ}
        element = Element(local if namespace in (SVG, "") else "", named, line, column + 1)
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)
        self.parser.CharacterDataHandler = element.text.append if element.tag == "style" else None

    def _end(self, name: str) -> None:
        self._open.pop()
        self.parser.CharacterDataHandler = None

    def _entity(self, name: str, parameter: bool, value: str | None, *outside: str | None) -> None:
        self._declaration()
        if parameter or value is None or len(value) > _LONGEST_ENTITY or re.search("[&%<]", value):
            sentence = _("entity {name!r} would expand into something else; write it out.")
            raise self._refusal(sentence.format(name=name[:40]))
        if len(value) * self._references > MOST_BYTES:
            sentence = _("entity {name!r} could make more than {most:,} characters; write it out.")
            raise self._refusal(sentence.format(name=name[:40], most=MOST_BYTES))

    def _default(self, *_what: object) -> None:
        self._declaration()

    def _declaration(self) -> None:
        self._counts["declaration"] += 1
        if self._counts["declaration"] > _MOST_DECLARATIONS:
            sentence = _("there are more than {most} declarations before the picture; remove some.")
            raise self._refusal(sentence.format(most=_MOST_DECLARATIONS))

    def _namespace(self, _prefix: str | None, uri: str | None) -> None:
        if uri is not None and len(uri) > _LONGEST_NAMESPACE:
            sentence = _("the name of a namespace has more than {most} characters; shorten it.")
            raise self._refusal(sentence.format(most=_LONGEST_NAMESPACE))


def _attribute(key: str) -> str:
    namespace, _blank, local = key.rpartition(" ")
    if namespace == OWN:
        return f"own:{local}"
    return local if namespace in ("", XLINK) else key
