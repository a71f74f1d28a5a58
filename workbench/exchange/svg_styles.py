"""What style sheets, attributes and ``style`` say about each element of an SVG, in the order of the cascade.

Rules are parsed by tinycss2 and selectors compiled by cssselect2. Those that look at siblings or counts are
left out, since they may take time without bound. Source: CSS 2.1, chapters 5 and 6; Selectors Level 3.
"""

import re
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
MOST_DIFFERENT = 1_000_000  # characters of declarations in style attributes, each text counted once
_PER_TRIAL = 100  # characters of an attribute that are searched in about the time that a trial takes
# Only a semicolon parts declarations here: nothing is quoted, bracketed, escaped or a comment.
_PLAIN = re.compile(r"""[^"'\\(){}\[\]*@]*""")
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

    ``left_out`` are selectors that are not understood here; ``attributes`` those that the others look at.
    """

    def __init__(self, text: str) -> None:
        self.left_out: list[str] = []
        self._rules: dict[tuple[str, str], list[_Rule]] = defaultdict(list)
        self.attributes: set[str] = set()
        self._selectors = self._trials = 0
        if "{" not in text:
            return
        if len(text) > MOST_CHARACTERS:
            sentence = _("the style sheet has {size:,} characters; shorten it to {most:,}.")
            raise StyleError(sentence.format(size=len(text), most=MOST_CHARACTERS))
        orders = count()
        for rule in _parsed("parse_stylesheet", text, skip_comments=True, skip_whitespace=True):
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
        except (SelectorError, NotImplementedError, RecursionError, SyntaxError, MemoryError):
            # The last three: it is too deep for Python, as which it is compiled.
            parsed, compiled = [], []
        descents = [_descents(selector.parsed_tree) for selector in parsed]
        if not compiled or None in descents:
            self.left_out.append(_text_of(prelude)[:40])
        for tree in (selector.parsed_tree for selector in parsed):
            self.attributes.update(_attributes(tree))
        for selector, around in zip(compiled, descents, strict=True):
            if around is None or selector.never_matches or selector.pseudo_element is not None:
                continue
            key = ("#", selector.id) if selector.id else (".", selector.class_name or "")
            key = key if key[1] else ("<", selector.local_name or "")
            weight = (*selector.specificity, order)
            self._rules[key].append(_Rule(weight, selector.test, around, said))

    def said_of(self, element: "ElementWrapper", depth: int, longest: int) -> Iterator[Said]:
        """What the rules say of an element ``depth`` elements deep, weakest first.

        ``longest`` is how many characters the longest of ``attributes`` has, on it or around it.
        Raises: StyleError.
        """
        keys = [("#", element.id or ""), *((".", name) for name in element.classes)]
        keys += [("<", element.local_name), ("<", "")]
        tried = [rule for key in keys for rule in self._rules.get(key, ())]
        trials = sum(1 + depth**rule.descents for rule in tried)
        self._trials += len(keys) + trials * (1 + longest // _PER_TRIAL)
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
        parsed = _Declarations()
        for element in elements:
            own = parsed.said(element.attributes.get("style", ""))
            element.style = _style(element, rules.get(element, {}), own)
    except StyleError as error:
        raise element.refusal(str(error)) from error
    return sheet.left_out


class _Declarations:
    """What ``style`` attributes say; of texts that many elements have each is parsed once."""

    def __init__(self) -> None:
        self._parsed: dict[str, Said] = {}
        self._characters = 0

    def said(self, text: str) -> Said:
        """What one attribute says. Raises: StyleError where all of them are too much."""
        said: Said = {}
        parts = text.split(";") if _PLAIN.fullmatch(text) else [text]
        for part in map(str.strip, parts):
            if part not in self._parsed:
                self._characters += len(part)
                if self._characters > MOST_DIFFERENT:
                    sentence = _(
                        "the style attributes have more than {most:,} different characters; "
                        "choose a smaller picture."
                    )
                    raise StyleError(sentence.format(most=MOST_DIFFERENT))
                self._parsed[part] = declarations(part)
            _lay(said, self._parsed[part])
        return said


def _lay(said: Said, later: Said) -> None:
    """Put what is said later over what is ``said``; of equal importance the last one holds."""
    for name, pair in later.items():
        if pair[1] >= said.get(name, pair)[1]:
            said[name] = pair


def _style(element: Element, ruled: Said, own: Said) -> dict[str, str]:
    """Attributes, rules and the ``style`` attribute, one over the other."""
    said = {name: (value, False) for name, value in element.attributes.items() if _is_sound(name, value)}
    _lay(said, ruled)
    _lay(said, own)
    return {name: value.strip() for name, (value, _important) in said.items()}


def _rules_of(root: Element, sheet: StyleSheet) -> dict[Element, Said]:
    """What the rules say of each element in ``root`` of which they say anything. Raises: StyleError."""
    from cssselect2 import ElementWrapper

    ruled: dict[Element, Said] = {}
    waiting = [(root, ElementWrapper.from_xml_root(_as_etree(root)), 0, 0)]
    while waiting:
        element, wrapper, depth, around = waiting.pop()
        longest = max((len(element.attributes.get(name, "")) for name in sheet.attributes), default=0)
        longest = max(longest, around)
        said: Said = {}
        for layer in sheet.said_of(wrapper, depth, longest):
            _lay(said, layer)
        if said:
            ruled[element] = said
        inside = zip(element.children, wrapper.iter_children(), strict=True)
        waiting += [(child, its, depth + 1, longest) for child, its in inside]
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


def _attributes(tree: Any) -> Iterator[str]:
    """The names of the attributes that a selector looks at."""
    from cssselect2 import parser

    while isinstance(tree, parser.CombinedSelector):
        yield from _attributes(tree.right)
        tree = tree.left
    for part in tree.simple_selectors:
        if isinstance(part, parser.AttributeSelector):
            yield part.name


def declarations(text: str) -> Said:
    """What a ``style`` attribute says, as in ``fill: none; stroke: red !important``."""
    if ":" not in text:
        return {}
    return _declared(_parsed("parse_blocks_contents", text))


def _parsed(read: str, text: str, **how: bool) -> list[Any]:
    """A text as this function of tinycss2 reads it. Raises: StyleError."""
    import tinycss2

    try:
        parsed: list[Any] = getattr(tinycss2, read)(text, **how)
    except ValueError as error:
        raise StyleError(_("a number in its style has too many digits; shorten it.")) from error
    return parsed


def _declared(content: list[Any]) -> Said:
    import tinycss2

    said: Said = {}
    if not any(item.type in ("declaration", "at-rule", "error") for item in content):  # tokens, so far
        content = tinycss2.parse_blocks_contents(content)
    for item in content:
        if item.type != "declaration" or item.lower_name not in PROPERTIES:
            continue
        value = _text_of(item.value)
        if _is_sound(item.lower_name, value):
            _lay(said, {item.lower_name: (value, item.important)})
    return said


def _text_of(tokens: list[Any]) -> str:
    """What tokens stand for; a few dots where brackets are nested too deep to be said."""
    import tinycss2

    try:
        return str(tinycss2.serialize(tokens)).strip()
    except RecursionError:
        return "..."


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
