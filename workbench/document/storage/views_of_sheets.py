"""Version 5 of the file: what a sheet had of one window and one viewport is its first view."""

from collections.abc import Iterator
from itertools import count
from typing import Any

from workbench.document.parts import number_of

_HIGHEST = 10**14
_OF_A_VIEW = ("window_world", "viewport_device", "clip_world")


def with_views(raw: dict[str, Any]) -> dict[str, Any]:
    """``raw``, the JSON values of a file of version 4, with a view for each sheet, and an id for each."""
    document = raw.get("document")
    if not isinstance(document, dict) or not isinstance(document.get("sheets"), list):
        return raw  # what is missing is said by whoever reads it
    taken = set(_ids(document))
    last = max(document.get("last_id", 0), *map(number_of, taken), 0)
    free = (f"v{k}" for k in count(last + 1 if last < _HIGHEST else 1))
    sheets = []
    for sheet in document["sheets"]:
        view = {name: sheet[name] for name in _OF_A_VIEW if name in sheet}
        view["id"] = next(identity for identity in free if identity not in taken)
        kept = {name: value for name, value in sheet.items() if name not in _OF_A_VIEW}
        sheets.append({**kept, "views": [view]})
    return {**raw, "document": {**document, "sheets": sheets}}


def _ids(value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        if isinstance(value.get("id"), str):
            yield value["id"]
        for inner in value.values():
            yield from _ids(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _ids(inner)
