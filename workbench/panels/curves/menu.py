"""The menu of the canvas in the Curves panel: what is done to points, joints and curves, in groups."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from workbench.language import _
from workbench.panels.curves.insight import switches
from workbench.panels.stage.transforming import BOX, MOTIONS, ON_CHAINS

_PARTED = ""


def groups() -> list[tuple[str, tuple[str, ...]]]:
    """Title and the names of the actions of each group; those without a title stand in the menu itself."""
    return [
        (
            "",
            (
                "insert",
                "remove_knot",
                "split",
                "join",
                "closed",
                _PARTED,
                "cut",
                "copy",
                "paste",
                "duplicate",
                "delete",
                "group",
                "ungroup",
                _PARTED,
                "copy_points",
                "paste_points",
            ),
        ),
        (
            _("Points"),
            (
                "corner",
                "smooth",
                "symmetric",
                _PARTED,
                "align_left",
                "align_centre",
                "align_right",
                "align_bottom",
                "align_middle",
                "align_top",
                _PARTED,
                "select_all",
                "snap",
            ),
        ),
        (_("Joint"), ("make_G1", "make_C1", "make_G2", "make_C2")),
        (_("Transform"), (BOX, _PARTED, *MOTIONS, _PARTED, *ON_CHAINS)),
        (_("Curve"), ("raise", "lower", "reverse", _PARTED, "forwards", "backwards")),
        (
            _("Convert"),
            (
                "convert_bezier_path",
                "convert_bezier",
                "convert_b_spline",
                "convert_nurbs",
                "convert_hermite",
                "flatten",
                _PARTED,
                "paste_fitted",
            ),
        ),
        (_("Show"), (*(f"show_{name}" for name, _title, _meaning in switches()), _PARTED, "why")),
        (_("In and out"), ("copy_picture",)),
    ]


def canvas_menu(actions: Mapping[str, QAction], parent: QWidget, more: Sequence[QAction] = ()) -> QMenu:
    """The menu, ``more`` at its end, made anew each time since actions are switched off and on.

    It goes when it is closed, and its submenus with it.
    """
    menu = QMenu(parent)
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    for title, names in groups():
        into = menu.addMenu(title) if title else menu
        for name in names:
            if name == _PARTED:
                into.addSeparator()
            else:
                into.addAction(actions[name])
        if not title:
            menu.addSeparator()
    menu.addActions(more)
    return menu
