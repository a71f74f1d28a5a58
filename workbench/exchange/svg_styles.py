"""Style sheets inside an SVG, as far as drawing programs write them: elements, classes and ids, no nesting.

Only what is read here of a look is kept. Source: CSS 2.1, chapters 5 and 6.
"""

import re
from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple

from workbench.language import _

INHERITED = ("fill", "stroke", "visibility", "color")
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
PROPERTIES = {*INHERITED, *REFERRING, "display"}
MOST_SELECTORS = 50_000
MOST_TRIALS = 2_000_000  # of a rule with an element

_COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)|<!--|-->", re.DOTALL)
_BRACE = re.compile(r"[{}]")
_SELECTOR = re.compile(r"(\*|[\w-]*)((?:[.#][\w-]+)*)")
_PART = re.compile(r"[.#][\w-]+")


class StyleError(ValueError):
    """A style sheet asks for more work than is done: one sentence that begins small."""


class _Rule(NamedTuple):
    """A selector; ``stated`` are property -> the number of the rule that says it last, and its value."""

    weight: tuple[int, int, int]
    tag: str
    parts: frozenset[str]
    stated: dict[str, tuple[int, str]]


class StyleSheet:
    """The rules of all ``<style>`` elements. Raises StyleError where there are too many."""

    def __init__(self, text: str) -> None:
        self._rules: dict[str, list[_Rule]] = defaultdict(list)
        self._ids: set[str] = set()
        self._known: dict[tuple[str, str, str], dict[str, str]] = {}
        self._selectors = self._trials = 0
        same: dict[tuple[str, frozenset[str]], _Rule] = {}
        for order, (selectors, stated) in enumerate(_rules(_COMMENT.sub("", text))):
            for tag, parts in self._read(selectors):
                rule = same.get((tag, parts))
                if rule is None:
                    ids = sum(part[0] == "#" for part in parts)
                    rule = same[tag, parts] = _Rule((ids, len(parts) - ids, bool(tag)), tag, parts, {})
                rule.stated.update({name: (order, value) for name, value in stated.items()})
        for rule in same.values():
            self._rules[min(rule.parts) if rule.parts else rule.tag].append(rule)
            self._ids.update(part for part in rule.parts if part[0] == "#")

    def _read(self, selectors: str) -> Iterator[tuple[str, frozenset[str]]]:
        """Tag, empty for any, and classes and ids of each selector that is understood."""
        self._selectors += selectors.count(",") + 1
        if self._selectors > MOST_SELECTORS:
            sentence = _("the style sheet has more than {most:,} selectors; leave some out.")
            raise StyleError(sentence.format(most=MOST_SELECTORS))
        for selector in selectors.split(","):
            match = _SELECTOR.fullmatch(selector.strip())
            if match is not None and (match[1] or match[2]):
                yield "" if match[1] == "*" else match[1], frozenset(_PART.findall(match[2]))

    def style_of(self, tag: str, attributes: dict[str, str]) -> dict[str, str]:
        """What the rules say about an element. Raises: StyleError."""
        if not self._rules:
            return {}
        own = {f".{name}" for name in attributes.get("class", "").split()}
        called = f"#{attributes['id']}" if "id" in attributes else ""
        if called in self._ids:
            own.add(called)
        else:
            called = ""
        signature = (tag, attributes.get("class", ""), called)
        if signature not in self._known:
            self._known[signature] = self._matching(tag, own)
        return self._known[signature]

    def _matching(self, tag: str, own: set[str]) -> dict[str, str]:
        tried = [rule for key in (*own, tag, "") for rule in self._rules.get(key, ())]
        self._trials += len(own) + sum(1 + len(rule.parts) for rule in tried)
        if self._trials > MOST_TRIALS:
            raise StyleError(_("the style sheet has too many rules for its classes; leave some out."))
        said: dict[str, tuple[tuple[int, int, int], int, str]] = {}
        for rule in tried:
            if rule.tag in ("", tag) and rule.parts <= own:
                for name, (order, value) in rule.stated.items():
                    if name not in said or (rule.weight, order) >= said[name][:2]:
                        said[name] = rule.weight, order, value
        return {name: value for name, (_weight, _order, value) in said.items()}


def _rules(text: str) -> Iterator[tuple[str, dict[str, str]]]:
    """Selectors and declarations of each rule that has no other in it and says something that is read."""
    before, begin, selectors = "", 0, ""
    for brace in _BRACE.finditer(text):
        part = text[begin : brace.start()]
        if brace.group() == "}" and before == "{" and selectors and (stated := declarations(part)):
            yield selectors, stated
        before, begin, selectors = brace.group(), brace.end(), part


def declarations(text: str) -> dict[str, str]:
    """Properties that are read and their values, as in ``fill: none; stroke: red``."""
    written = (part.partition(":") for part in text.split(";"))
    pairs = ((name.strip(), value) for name, colon, value in written if colon)
    return {name: value.replace("!important", "").strip() for name, value in pairs if name in PROPERTIES}
