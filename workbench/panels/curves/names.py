"""What the kinds of curves are called, and the colour and pattern in which each is drawn."""

from workbench.document.model import Curve
from workbench.language import _
from workbench.widgets.canvas.drawing import Pattern

_LOOKS: dict[str, tuple[str, Pattern]] = {
    "bezier": ("data2", "solid"),
    "bezier_path": ("data2", "dash"),
    "b_spline": ("data3", "solid"),
    "nurbs": ("data3", "dash"),
    "hermite": ("data5", "dash"),
    "natural_cubic": ("data4", "solid"),
    "clamped_cubic": ("data4", "dash"),
    "periodic_cubic": ("data4", "dot"),
    "cardinal": ("data6", "dash"),
    "catmull_rom": ("data6", "solid"),
    "kochanek_bartels": ("data6", "dot"),
}
_MARKS: dict[Pattern, str] = {"solid": "\N{BOX DRAWINGS HEAVY HORIZONTAL}" * 2, "dash": "╍╍", "dot": "┅┅"}


def spline_title(spline: str) -> str:
    """What a kind of curve is called."""
    return {
        "bezier": _("Bézier curve"),
        "bezier_path": _("Bézier path"),
        "b_spline": _("B-spline"),
        "nurbs": _("NURBS"),
        "hermite": _("Hermite spline"),
        "natural_cubic": _("Natural cubic spline"),
        "clamped_cubic": _("Clamped cubic spline"),
        "periodic_cubic": _("Periodic cubic spline"),
        "cardinal": _("Cardinal spline"),
        "catmull_rom": _("Catmull-Rom spline"),
        "kochanek_bartels": _("Kochanek-Bartels spline"),
    }[spline]


def look_of(spline: str) -> tuple[str, Pattern]:
    """Ink and pattern of a kind where several kinds are drawn over the same points."""
    return _LOOKS[spline]


def mark_of(spline: str) -> str:
    """The pattern of a kind as characters, for a legend."""
    return _MARKS[_LOOKS[spline][1]]


def is_handle(curve: Curve, index: int) -> bool:
    """Whether a point of a Bézier path is a handle and not a point of the curve."""
    return curve.spline == "bezier_path" and index % 3 != 0


def point_name(curve: Curve, index: int) -> str:
    """What a control point is called: P_0, P_1 and so on, handles by the point they belong to."""
    if curve.spline != "bezier_path":
        return f"P{index}"
    return f"P{index // 3}" if index % 3 == 0 else f"H{(index + 1) // 3}{'+' if index % 3 == 1 else '−'}"
