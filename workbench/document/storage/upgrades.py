"""What makes a file of each older version one of the next, as plain JSON values."""

from collections.abc import Callable, Mapping
from typing import Any

from workbench.document.storage.exact_fills import with_exact_fills
from workbench.document.storage.views_of_sheets import with_views

Upgrade = Callable[[dict[str, Any]], dict[str, Any]]

# The workspaces in which version 3 stepped a run of each kind.
_WORKSPACES = {"figure": ("draw", "fill"), "clipper": ("clip",), "curve": ("curves",)}


def _with_positions(raw: dict[str, Any]) -> dict[str, Any]:
    """Version 3 has one step for all workspaces, and what is stepped in fields of its own."""
    session = dict(raw.get("session", {}))
    stepped = session.pop("stepped", "figure")
    place = {"step": session.pop("step", 0), "detail": session.pop("detail", False)}
    u, construction = session.pop("curve_u", 0.5), session.pop("construction", "")
    positions: dict[str, Any] = {
        workspace: {"subject": {"kind": kind}, **(place if kind == stepped else {})}
        for kind, workspaces in _WORKSPACES.items()
        for workspace in workspaces
    }
    positions["curves"]["subject"] |= {"entry": construction, "arguments": {"u": u}}
    workspace = _WORKSPACES[stepped][0]
    return {**raw, "session": {**session, "workspace": workspace, "positions": positions}}


# UPGRADES[1] makes a version 2 of a version 1. Version 2 has polygons, further fills and a clip window,
# version 3 curves, version 5 transforms of figures: no older version holds any. Version 4 has a position for
# each workspace, version 5 views, version 6 motion and the frame that is shown, version 7 keys that tell how
# vertices meet and how a turn goes on, named views, groups, lights that fade, and opacity; version 8 has
# another text under the name ``scan_line_fill``.
UPGRADES: Mapping[int, Upgrade] = {
    1: dict,
    2: dict,
    3: _with_positions,
    4: with_views,
    5: dict,
    6: dict,
    7: with_exact_fills,
}
