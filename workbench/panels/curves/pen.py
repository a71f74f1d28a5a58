"""Tools that draw curves: the pen for every kind, click by click."""

from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np
from msgspec.structs import replace

from workbench.algorithms.numerals import with_minus
from workbench.document.curves.edits import add_path_point, add_points, curve_with
from workbench.document.curves.pieces import goes_round
from workbench.document.edits import add_figure, both
from workbench.document.model import TANGENT_SPLINES, Curve, CurvePoint, Document
from workbench.document.transforms.chains import read_only_reason
from workbench.language import _
from workbench.panels.curves.drags import constrained
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.shape import TANGENT_SHARE, device_points
from workbench.panels.stage.gesture import Modifiers
from workbench.panels.stage.tools import FigureTool
from workbench.rendering import device_map

Place = tuple[float, float]
# How far the button must move, in pixels of the picture, until a handle is pulled out.
PULL = 0.6


@dataclass(slots=True)
class Node:
    """One point clicked with the pen, and where the handle pulled out of it ends, if any (device)."""

    at: Place
    pulled: Place | None = None


class PenTool(FigureTool):
    """Draws curves: a click adds a point, a drag pulls out its tangent; Enter ends, the first point closes.

    A first click on the end of an open curve goes on with that one.

    ``model`` is a curve without points that new ones are like: its kind, degree and so on.
    """

    name, icon, key, kind = "pen", "pen-nib", "P", Curve

    def __init__(self, focus: CurveFocus) -> None:
        super().__init__(focus.session)
        self.focus = focus
        self.model = Curve("", (), Curve.algorithms[0], spline="b_spline")
        self._nodes: list[Node] = []
        self._held = False
        self._reach = 0.75
        self._pressed = (0.0, 0.0)
        self.modifiers = Modifiers.NoModifier
        self._continued: tuple[str, bool] | None = None

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Pen")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Another point; on the first one the curve is closed, on the last one it ends."""
        self._reach = reach
        self.modifiers, self._pressed = modifiers, (x, y)
        place = self._placed(x, y)
        if not self.busy:
            self._continued = self._end_at(x, y)
            self._nodes = [Node(place)]
            self.begin()
            if self._continued is not None:
                self._held = False
                return
        elif self._near(self._nodes[-1].at, x, y):
            self.finish()
            return
        elif self._closes_at(x, y):
            self.model = replace(self.model, closed=True)
            self.finish()
            self.model = replace(self.model, closed=False)
            return
        else:
            self._nodes.append(Node(place))
        self._held = True
        self._grow(None)

    def _placed(self, x: float, y: float) -> Place:
        """Where a point or handle is put; with Ctrl in one of eight directions from the last point."""
        if self.modifiers & Modifiers.ControlModifier and self.busy and self._nodes:
            ax, ay = self._nodes[-1].at
            dx, dy = constrained(x - ax, y - ay)
            return round(ax + dx, 4), round(ay + dy, 4)
        return self.focus.placed(x, y)

    def _end_at(self, x: float, y: float) -> tuple[str, bool] | None:
        """The open curve that ends there, and whether that is its begin; None where none does."""
        for figure in reversed(self.session.sheet.figures):
            if isinstance(figure, Curve) and self._goes_on(figure):
                points = device_points(self.session.sheet, figure)
                for number, first in ((-1, False), (0, True)):
                    if self._near(tuple(points[number].tolist()), x, y):
                        return figure.id, first
        return None

    @staticmethod
    def _goes_on(curve: Curve) -> bool:
        return curve.visible and not goes_round(curve) and not read_only_reason(curve)

    def _added(self, figure: str, first: bool, nodes: list[Node], document: Document) -> Document:
        """The document with a curve that goes on by all nodes but the one that it ends at."""
        curve = curve_with(document, figure)
        if len(nodes) < 2:
            return document
        world = [self.focus.world(*node.at, curve) for node in nodes[1:]]
        if curve.spline != "bezier_path":
            return add_points(figure, world[::-1] if first else world, 0 if first else None)(document)
        pulled = [None if n.pulled is None else self.focus.world(*n.pulled, curve) for n in nodes[1:]]
        return both(
            *(
                add_path_point(figure, x, y, handle, first)
                for (x, y), handle in zip(world, pulled, strict=True)
            )
        )(document)

    def _near(self, place: Place, x: float, y: float) -> bool:
        return float(np.hypot(place[0] - x, place[1] - y)) <= self._reach

    def _closes_at(self, x: float, y: float) -> bool:
        """Whether a click there comes back to the first point of a curve that can go round."""
        bends = self._has_handles and any(node.pulled is not None for node in self._nodes)
        if self._continued is not None or len(self._nodes) < (2 if bends else 3):
            return False
        return goes_round(replace(self.model, closed=True)) and self._near(self._nodes[0].at, x, y)

    def move(self, x: float, y: float) -> None:
        """Pull out a handle while the button is down; else show how the curve would go on."""
        if not self.busy:
            return
        last = self._nodes[-1]
        place = self._placed(x, y)
        if self._held:
            far = float(np.hypot(x - self._pressed[0], y - self._pressed[1])) > PULL
            if (far or last.pulled is not None) and self._has_handles:
                last.pulled = place
            self._grow(None)
        else:
            closes = self._closes_at(x, y)
            self.tag = _("Click to close the curve") if closes else self._place_text(place)
            self._grow(None if closes or self._near(last.at, x, y) else place, closes)

    def release(self, x: float, y: float) -> None:
        """The point is where it is; without handles a drag ends in a second point."""
        if not self.busy or not self._held:
            return
        self._held = False
        place = self._placed(x, y)
        if not self._has_handles and not self._near(self._pressed, x, y):
            self._nodes.append(Node(place))
        self._grow(None)

    @property
    def _has_handles(self) -> bool:
        return self.model.spline == "bezier_path" or self.model.spline in TANGENT_SPLINES

    def _place_text(self, place: Place) -> str:
        count = len(self._nodes)
        return with_minus(f"P{count} ({place[0]:g}, {place[1]:g})\n") + _(
            "Enter ends the curve, Backspace removes the last point"
        )

    def _grow(self, pointer: Place | None, closes: bool = False) -> None:
        nodes = [*self._nodes, Node(pointer)] if pointer is not None else list(self._nodes)
        if self._continued is not None:
            figure, first = self._continued
            if self.show(partial(self._added, figure, first, nodes), _("Go on with the curve")):
                self.session.update_state(selection=(figure,), active=figure)
            return
        if len(nodes) < 2:  # nothing of which would be seen; whatever follows, it is not left behind
            self.show(lambda document: document, "")
            return
        made = self._curve(nodes, self.model.closed or closes)
        if self.show(add_figure(self.session.sheet.id, made), _("Draw {what}").format(what=self.title)):
            last = self.session.sheet.figures[-1].id
            self.session.update_state(selection=(last,), active=last, step=0)

    def _curve(self, nodes: list[Node], closed: bool) -> Curve:
        model = replace(self.model, algorithm=self.algorithm, colour=self.next_colour(), closed=closed)
        if model.spline == "bezier_path":
            points, joints = path_places(nodes, closed)
            made = [
                CurvePoint("", *self.focus.world(*place), joint=joint)
                for place, joint in zip(points, joints, strict=True)
            ]
            return replace(model, points_world=tuple(made))
        scale = device_map(self.session.sheet)
        tangents = (
            tangents_of(nodes, closed) if model.spline in TANGENT_SPLINES else [(0.0, 0.0)] * len(nodes)
        )
        made = [
            CurvePoint(
                "",
                *self.focus.world(*node.at),
                tangent_x=round(tangent[0] / scale.sx, 9),
                tangent_y=round(tangent[1] / scale.sy, 9),
            )
            for node, tangent in zip(nodes, tangents, strict=True)
        ]
        return replace(model, points_world=tuple(made))

    def back(self) -> bool:
        """Take the last point back; False when nothing is being drawn."""
        if not self.busy:
            return False
        if len(self._nodes) < 2:
            self.cancel()
        else:
            self._nodes.pop()
            self._grow(None)
        return True

    def finish(self) -> None:
        """End the curve with the points so far; one point makes none."""
        if not self.busy:
            return
        if len(self._nodes) < 2:
            self.cancel()
            self.failed.emit(_("A curve needs two points; click at least two places."))
            return
        self._grow(None)
        self._nodes, self._held, self.tag = [], False, ""
        self.commit()

    def cancel(self) -> None:
        """Take back what was begun."""
        super().cancel()
        self._nodes, self._held = [], False


def path_places(nodes: list[Node], closed: bool) -> tuple[list[Place], list[str]]:
    """Point, handle, handle, point and so on of a path through ``nodes`` (device), with each one's joint.

    Where nothing was pulled out the handle lies a third of the way to the neighbour, and the joint is a
    corner.
    """
    ends = [*nodes, nodes[0]] if closed and len(nodes) > 1 else nodes
    places: list[Place] = []
    joints: list[str] = []
    for here, after in pairwise(ends):
        places += [here.at, _handle(here, after, 1), _handle(after, here, -1)]
        joints += ["corner" if here.pulled is None else "symmetric", "corner", "corner"]
    if not closed or len(nodes) < 2:
        places.append(nodes[-1].at)
        joints.append("corner" if nodes[-1].pulled is None else "symmetric")
    return places, joints


def _handle(node: Node, towards: Node, side: int) -> Place:
    if node.pulled is not None:
        (x, y), (px, py) = node.at, node.pulled
        return x + side * (px - x), y + side * (py - y)
    (x, y), (tx, ty) = node.at, towards.at
    return x + (tx - x) / 3, y + (ty - y) / 3


def tangents_of(nodes: list[Node], closed: bool) -> list[Place]:
    """The derivative at each node (device): what was pulled out, else half the way between its neighbours."""
    found: list[Place] = []
    last = len(nodes) - 1
    for k, node in enumerate(nodes):
        (x, y), pulled = node.at, node.pulled
        if pulled is not None:
            found.append(((pulled[0] - x) / TANGENT_SHARE, (pulled[1] - y) / TANGENT_SHARE))
            continue
        before = nodes[k - 1] if k or closed else node
        after = nodes[(k + 1) % len(nodes)] if k < last or closed else node
        share = 0.5 if before is not node and after is not node else 1.0
        (bx, by), (ax, ay) = before.at, after.at
        found.append((share * (ax - bx), share * (ay - by)))
    return found
