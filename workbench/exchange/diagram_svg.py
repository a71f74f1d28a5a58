"""A derivation as SVG. Its type has the widths of Helvetica, which other faces are fitted to where read."""

from xml.etree import ElementTree

from workbench.exchange.diagrams import WHITE, Derivation, lay_out_derivation
from workbench.exchange.formulas.layout import Area, Disc, Glyphs, Line, Primitive, Style, Typesetter
from workbench.exchange.svg_transforms import number
from workbench.exchange.svg_tree import SVG
from workbench.exchange.svg_writing import NO_XML

# Advance widths of Helvetica, thousandths of the size; Adobe Font Metrics, 1997.
_ADVANCES = {
    **dict.fromkeys("0123456789abdeghnopquL$#_αβεηθκμνπρστ?", 556),
    **dict.fromkeys("cksvxyzJ", 500),
    **dict.fromkeys(" ft,.;:/!I[]\\·", 278),
    **dict.fromkeys("ijl", 222),
    **dict.fromkeys("r()-", 333),
    **dict.fromkeys("ABEKPSVXY&", 667),
    **dict.fromkeys("CDHNRUw", 722),
    **dict.fromkeys("FTZ", 611),
    **dict.fromkeys("GOQ", 778),
    **dict.fromkeys("mM", 833),
    **dict.fromkeys("+−=<>~×±≤≥≠≈", 584),
    "W": 944,
    "|": 260,
    "{": 334,
    "}": 334,
    "%": 889,
    "°": 400,
    "*": 389,
    "^": 469,
    "'": 191,
    "′": 191,
    "→": 1000,
    "…": 1000,
}
_OTHER, _FIGURE = 600, 600
_FAMILIES = {"figures": "Courier New, Liberation Mono, monospace"}
_FAMILY = "Helvetica, Arial, Liberation Sans, sans-serif"
_DASHES = {"dash": (4.0, 2.0), "dot": (1.0, 2.0)}


class PaperMetrics:
    """The widths of Helvetica, and of a fixed-width face for numbers."""

    def width(self, text: str, size: float, style: Style) -> float:
        """How far a run goes."""
        if style == "figures":
            return _FIGURE * len(text) * size / 1000
        bolder = 1.06 if "bold" in style else 1.0
        return bolder * sum(_ADVANCES.get(letter, _OTHER) for letter in text) * size / 1000

    def ascent(self, size: float) -> float:
        """How far letters go up from the base line."""
        return 0.76 * size

    def descent(self, size: float) -> float:
        """How far letters go down from the base line."""
        return 0.22 * size


def write_diagram(derivation: Derivation) -> str:
    """The page as an SVG text, in points."""
    laid = lay_out_derivation(derivation, Typesetter(PaperMetrics()))
    ElementTree.register_namespace("", SVG)
    root = ElementTree.Element(
        f"{{{SVG}}}svg",
        {
            "width": f"{_short(laid.width)}pt",
            "height": f"{_short(laid.height)}pt",
            "viewBox": f"0 0 {_short(laid.width)} {_short(laid.height)}",
        },
    )
    ElementTree.SubElement(root, f"{{{SVG}}}title").text = NO_XML.sub(" ", derivation.title)
    whole = {"width": "100%", "height": "100%", "fill": WHITE}
    ElementTree.SubElement(root, f"{{{SVG}}}rect", whole)
    for primitive in laid.primitives:
        tag, attributes, text = _element(primitive, derivation.ink(primitive.ink))
        ElementTree.SubElement(root, f"{{{SVG}}}{tag}", attributes).text = text
    ElementTree.indent(root)
    return ElementTree.tostring(root, "unicode", xml_declaration=True) + "\n"


def _element(primitive: Primitive, ink: str) -> tuple[str, dict[str, str], str | None]:
    match primitive:
        case Glyphs():
            return "text", _type(primitive, ink), NO_XML.sub(" ", primitive.text)
        case Line():
            attributes = {"points": _pairs(primitive.points), "fill": "none", "stroke": ink}
            attributes["stroke-width"] = _short(primitive.width)
            if primitive.pattern in _DASHES:
                dashes = (_short(part * primitive.width) for part in _DASHES[primitive.pattern])
                attributes["stroke-dasharray"] = " ".join(dashes)
            return "polyline", attributes, None
        case Area():
            attributes = {"points": _pairs(primitive.points), "fill": ink}
            if primitive.share < 1:
                attributes["fill-opacity"] = _short(primitive.share)
            return "polygon", attributes, None
        case Disc():
            place = {"cx": primitive.x, "cy": primitive.y, "r": primitive.radius}
            attributes = {name: _short(value) for name, value in place.items()}
            attributes |= {"fill": WHITE if primitive.hollow else ink, "stroke": ink}
            attributes["stroke-width"] = _short(0.35 * primitive.radius)
            return "circle", attributes, None


def _type(glyphs: Glyphs, ink: str) -> dict[str, str]:
    attributes = {
        "x": _short(glyphs.x),
        "y": _short(glyphs.y),
        "font-family": _FAMILIES.get(glyphs.style, _FAMILY),
        "font-size": _short(glyphs.size),
        "fill": ink,
    }
    if glyphs.width:
        attributes |= {"textLength": _short(glyphs.width), "lengthAdjust": "spacingAndGlyphs"}
    if "italic" in glyphs.style:
        attributes["font-style"] = "italic"
    if "bold" in glyphs.style:
        attributes["font-weight"] = "600"
    return attributes


def _pairs(points: tuple[tuple[float, float], ...]) -> str:
    return " ".join(f"{_short(x)},{_short(y)}" for x, y in points)


def _short(value: float) -> str:
    """A length to a hundredth of a point."""
    return number(round(value, 2))
