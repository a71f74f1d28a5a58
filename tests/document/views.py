"""Sheets seen through other views, for tests."""

from typing import Any

from msgspec.structs import replace

from workbench.document.model import Sheet


def seen_through(sheet: Sheet, **changes: Any) -> Sheet:
    """``sheet`` with something of its first view replaced."""
    return replace(sheet, views=(replace(sheet.first_view, **changes), *sheet.views[1:]))
