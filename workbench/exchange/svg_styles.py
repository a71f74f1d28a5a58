"""Style sheets inside an SVG, as far as drawing programs write them: elements, classes and ids, no nesting.

Source: CSS 2.1, chapters 5 and 6.
"""

import re
from collections import defaultdict
from typing import NamedTuple

_COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)|<!--|-->", re.DOTALL)
_RULE = re.compile(r"([^{}]+)\{([^{}]*)\}")
_SELECTOR = re.compile(r"(\*|[\w-]*)((?:[.#][\w-]+)*)")
_PART = re.compile(r"[.#][\w-]+")


class _Rule(NamedTuple):
    weight: tuple[int, int, int, int]
    tag: str
    parts: frozenset[str]
    declarations: dict[str, str]


class StyleSheet:
    """The rules of all ``<style>`` elements."""

    def __init__(self, text: str) -> None:
        self._rules: dict[str, list[_Rule]] = defaultdict(list)
        for order, found in enumerate(_RULE.finditer(_COMMENT.sub("", text))):
            stated = declarations(found[2])
            for selector in found[1].split(","):
                match = _SELECTOR.fullmatch(selector.strip())
                if match is None or not (match[1] or match[2]):
                    continue
                parts = _PART.findall(match[2])
                tag = "" if match[1] == "*" else match[1]
                ids = sum(part[0] == "#" for part in parts)
                weight = (ids, len(parts) - ids, bool(tag), order)
                key = parts[0] if parts else tag
                self._rules[key].append(_Rule(weight, tag, frozenset(parts), stated))

    def style_of(self, tag: str, attributes: dict[str, str]) -> dict[str, str]:
        """What the rules say about an element."""
        if not self._rules:
            return {}
        own = {f".{name}" for name in attributes.get("class", "").split()}
        if "id" in attributes:
            own.add(f"#{attributes['id']}")
        rules = [
            rule
            for key in (*own, tag, "")
            for rule in self._rules.get(key, ())
            if rule.tag in ("", tag) and rule.parts <= own
        ]
        found: dict[str, str] = {}
        for rule in sorted(rules, key=lambda rule: rule.weight):
            found.update(rule.declarations)
        return found


def declarations(text: str) -> dict[str, str]:
    """Properties and their values, as in ``fill: none; stroke: red``."""
    written = (part.partition(":") for part in text.split(";"))
    return {name.strip(): value.replace("!important", "").strip() for name, colon, value in written if colon}
