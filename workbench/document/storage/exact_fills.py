"""Version 8 of the file: ``scan_line_fill`` adds up 1/m, and what it was before is ``scan_line_exact``."""

from typing import Any

_BEFORE = "scan_line_fill"
_NOW = "scan_line_exact"


def with_exact_fills(raw: dict[str, Any]) -> dict[str, Any]:
    """``raw``, the JSON values of a file of version 7, in which all is drawn and stepped as it was."""
    document, session = raw.get("document"), raw.get("session")
    if isinstance(document, dict) and isinstance(document.get("sheets"), list):
        sheets = [
            {**sheet, "figures": [_renamed(figure, "algorithm") for figure in sheet["figures"]]}
            if isinstance(sheet.get("figures"), list)
            else sheet
            for sheet in document["sheets"]
        ]
        raw = {**raw, "document": {**document, "sheets": sheets}}
    if isinstance(session, dict):
        session = _renamed(session, "compare")
        if isinstance(positions := session.get("positions"), dict):
            session = {**session, "positions": {name: _with_subject(p) for name, p in positions.items()}}
        raw = {**raw, "session": session}
    return raw


def _with_subject(position: Any) -> Any:
    if isinstance(position, dict) and "subject" in position:
        return {**position, "subject": _renamed(position["subject"], "entry")}
    return position


def _renamed(value: Any, field: str) -> Any:
    if isinstance(value, dict) and value.get(field) == _BEFORE:
        return {**value, field: _NOW}
    return value
