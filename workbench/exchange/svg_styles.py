"""What style sheets, attributes and ``style`` say about each element of an SVG, in the order of the cascade.

Rules are parsed by tinycss2 and selectors compiled by cssselect2. Those that look at siblings or counts are
left out, since they may take time without bound. Source: CSS 2.1, chapters 5 and 6; Selectors Level 3.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple

from workbench.exchange.svg_colours import is_paint
from workbench.exchange.svg_tree import PROPERTIES, Element
from workbench.language import _

if TYPE_CHECKING:
    from cssselect2 import ElementWrapper

MOST_CHARACTERS = 400_000
MOST_SELECTORS = 10_000
MOST_TRIALS = 1_000_000  # of a selector with an element
_SHORT = ("opacity", "fill-opacity", "stroke-opacity")
_PAINTS = ("fill", "stroke", "color")

Said = dict[str, tuple[str, bool]]
"""Property -> its value, and whether it is important."""


class StyleError(ValueError):
    """A style sheet asks for more work than is done: one sentence that begins small."""


class _Rule(NamedTuple):
    """``descents``: how many of its parts may be any of the elements around an element."""

    weight: tuple[Any, ...]
    matches: Any
    descents: int
    said: Said


class StyleSheet:
    """The rules of all ``<style>`` elements. Raises StyleError where they are too much.

    ``left_out`` are selectors that are not understood here.
    """

    def __init__(self, text: str) -> None:
        self.left_out: list[str] = []
        self._rules: dict[tuple[str, str], list[_Rule]] = defaultdict(list)
        self._selectors = self._trials = 0
        if "{" not in text:
            return
        if len(text) > MOST_CHARACTERS:
            sentence = _("the style sheet has {size:,} characters; shorten it to {most:,}.")
            raise StyleError(sentence.format(size=len(text), most=MOST_CHARACTERS))
        import tinycss2

        orders = count()
        for rule in tinycss2.parse_stylesheet(text, skip_comments=True, skip_whitespace=True):
            if rule.type == "qualified-rule" and (said := _declared(rule.content)):
                self._add(rule.prelude, said, next(orders))

    @property
    def empty(self) -> bool:
        """Whether no rule says anything."""
        return not self._rules

    def _add(self, prelude: list[Any], said: Said, order: int) -> None:
        from cssselect2 import SelectorError, compile_selector_list, parser

        self._selectors += 1 + sum(token == "," for token in prelude)
        if self._selectors > MOST_SELECTORS:
            sentence = _("the style sheet has more than {most:,} selectors; leave some out.")
            raise StyleError(sentence.format(most=MOST_SELECTORS))
        try:
            parsed = list(parser.parse(prelude))
            compiled = compile_selector_list(prelude)
        except (SelectorError, NotImplementedError, RecursionError):
            parsed, compiled = [], []
        descents = [_descents(selector.parsed_tree) for selector in parsed]
        if not compiled or None in descents:
            import tinycss2

            self.left_out.append(tinycss2.serialize(prelude).strip()[:40])
        for selector, around in zip(compiled, descents, strict=True):
            if around is None or selector.never_matches or selector.pseudo_element is not None:
                continue
            key = ("#", selector.id) if selector.id else (".", selector.class_name or "")
            key = key if key[1] else ("<", selector.local_name or "")
            weight = (*selector.specificity, order)
            self._rules[key].append(_Rule(weight, selector.test, around, said))

    def said_of(self, element: "ElementWrapper", depth: int) -> Iterator[Said]:
        """What the rules say of an element ``depth`` elements deep, weakest first. Raises: StyleError."""
        keys = [("#", element.id or ""), *((".", name) for name in element.classes)]
        keys += [("<", element.local_name), ("<", "")]
        tried = [rule for key in keys for rule in self._rules.get(key, ())]
        self._trials += len(keys) + sum(1 + depth**rule.descents for rule in tried)
        if self._trials > MOST_TRIALS:
            raise StyleError(_("the style sheet has too many rules for its elements; leave some out."))
        fitting = [rule for rule in tried if rule.matches(element)]
        return (rule.said for rule in sorted(fitting, key=lambda rule: rule.weight))


def cascade(root: Element, elements: Sequence[Element]) -> list[str]:
    """Set the ``style`` of all ``elements`` in ``root``; the selectors that were left out.

    Raises: SvgError, at the element that a style sheet is too much for.
    """
    element = root
    try:
        sheet = StyleSheet("\n".join("".join(each.text) for each in elements if each.tag == "style"))
        rules = {} if sheet.empty else _rules_of(root, sheet)
        for element in elements:
            element.style = _style(element, rules.get(element, {}))
    except StyleError as error:
        raise element.refusal(str(error)) from error
    return sheet.left_out


def _style(element: Element, ruled: Said) -> dict[str, str]:
    """Attributes, rules and the ``style`` attribute; of equal importance the last one holds."""
    own = declarations(element.attributes.get("style", ""))
    said = {name: (value, False) for name, value in element.attributes.items() if _is_sound(name, value)}
    for layer in (ruled, own):
        _lay_over(said, layer)
    return {name: value.strip() for name, (value, _important) in said.items()}


def _lay_over(said: Said, layer: Said) -> None:
    """Let ``layer`` say what follows; what is important gives way to what is important alone."""
    said.update({name: pair for name, pair in layer.items() if pair[1] >= said.get(name, ("", False))[1]})


def _rules_of(root: Element, sheet: StyleSheet) -> dict[Element, Said]:
    """What the rules say of each element in ``root`` of which they say anything. Raises: StyleError."""
    from cssselect2 import ElementWrapper

    ruled: dict[Element, Said] = {}
    waiting = [(root, ElementWrapper.from_xml_root(_as_etree(root)), 0)]
    while waiting:
        element, wrapper, depth = waiting.pop()
        said: Said = {}
        for layer in sheet.said_of(wrapper, depth):
            _lay_over(said, layer)
        if said:
            ruled[element] = said
        inside = zip(element.children, wrapper.iter_children(), strict=True)
        waiting += [(child, its, depth + 1) for child, its in inside]
    return ruled


def _as_etree(root: Element) -> Any:
    """The tree as selectors are matched against."""
    from xml.etree.ElementTree import Element as Node

    top = Node(root.tag or "-", root.attributes)
    waiting = [(root, top)]
    while waiting:
        element, node = waiting.pop()
        for child in element.children:
            inner = Node(child.tag or "-", child.attributes)
            node.append(inner)
            waiting.append((child, inner))
    return top


def _descents(tree: Any) -> int | None:
    """How many descendant combinators a selector has; None where it looks at siblings or counts."""
    from cssselect2 import parser

    if isinstance(tree, parser.CombinedSelector):
        left, right = _descents(tree.left), _descents(tree.right)
        if left is None or right is None or tree.combinator not in (" ", ">"):
            return None
        return left + right + int(tree.combinator == " ")
    simple = (
        parser.LocalNameSelector,
        parser.NamespaceSelector,
        parser.ClassSelector,
        parser.IDSelector,
        parser.AttributeSelector,
    )
    for part in tree.simple_selectors:
        named = isinstance(part, parser.PseudoClassSelector) and part.name in ("root", "first-child", "hover")
        if not (isinstance(part, simple) or named):
            return None
    return 0


def declarations(text: str) -> Said:
    """What a ``style`` attribute says, as in ``fill: none; stroke: red !important``."""
    if ":" not in text:
        return {}
    import tinycss2

    return _declared(tinycss2.parse_blocks_contents(text[:MOST_CHARACTERS]))


def _declared(content: list[Any]) -> Said:
    import tinycss2

    said: Said = {}
    if content and content[0].type not in ("declaration", "at-rule", "error"):
        content = tinycss2.parse_blocks_contents(content)
    for item in content:
        if item.type != "declaration" or item.lower_name not in PROPERTIES:
            continue
        value = tinycss2.serialize(item.value).strip()
        if _is_sound(item.lower_name, value) and item.important >= said.get(item.lower_name, ("", False))[1]:
            said[item.lower_name] = value, item.important
    return said


def _is_sound(name: str, value: str) -> bool:
    """Whether a property has a value it may have; any other counts as not being there."""
    if name not in PROPERTIES:
        return False
    if name in _PAINTS:
        return is_paint(value)
    if name in _SHORT and value.strip() != "inherit":
        return share(value) is not None
    return True


def share(text: str) -> float | None:
    """An opacity, 0 to 1, of a number or percentage; None where it is neither."""
    word = text.strip()
    number = word.removesuffix("%")
    try:
        value = float(number[:40]) / (100.0 if number != word else 1.0)
    except ValueError:
        return None
    return min(max(value, 0.0), 1.0) if value == value else None
