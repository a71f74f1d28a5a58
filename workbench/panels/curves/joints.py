"""How smoothly the pieces of a curve join, as rows of a table."""

import numpy as np

from workbench.algorithms import curves
from workbench.document.curves.pieces import ends_steer, goes_round
from workbench.document.curves.shaping import AGREEMENT
from workbench.document.model import THROUGH, Curve, Sheet
from workbench.panels.curves.names import point_name
from workbench.panels.curves.shape import device_pieces
from workbench.widgets.tables.continuity_table import Joint

MOST_JOINTS = 300


def joints(sheet: Sheet, curve: Curve) -> list[Joint]:
    """The joints of a curve's pieces, measured in pixels, named by the point there where there is one."""
    pieces = device_pieces(sheet, curve)
    if pieces is None:
        return []
    found = curves.joints(pieces, goes_round(curve), AGREEMENT)
    kept = pieces.knots[np.append(np.diff(pieces.knots) > 0, True)]
    return [
        Joint(joint_name(curve, number), float(kept[number + 1]), one)
        for number, one in enumerate(found[:MOST_JOINTS])
    ]


def joint_name(curve: Curve, number: int) -> str:
    """The name of the point at a joint, or the number of the joint."""
    index = joint_point(curve, number)
    return f"t_{{{number + 1}}}" if index is None else f"P_{{{point_name(curve, index)[1:]}}}"


def joint_point(curve: Curve, number: int) -> int | None:
    """The number of the control point at a joint; None where the joint is not at a point."""
    points = len(curve.points_world)
    if curve.spline == "bezier_path":
        return 3 * (number + 1) % points if curve.closed else 3 * (number + 1)
    if curve.spline in THROUGH:
        return (number + 1 + ends_steer(curve)) % points
    return None
