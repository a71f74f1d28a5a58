"""The octree of a solid, as far as it is stepped: its cells as the eye sees them, the one in hand strong."""

from typing import NamedTuple

import numpy as np

from workbench.algorithms.solids.implicit import EMPTY, FULL, PARTIAL
from workbench.document.model import Sheet
from workbench.geometry.meshes import Array
from workbench.language import _, ngettext
from workbench.panels.space.visibility.depth_run import DepthRun, method_run
from workbench.panels.stage.picture import Pixels, packed
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.solid_octree import cube_edges, sides_seen
from workbench.rendering.scene.viewpoint import Viewpoint
from workbench.rendering.subjects.visibility import octree_objects, octrees_call, window_of
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Drawn, PenStroke, Tint
from workbench.widgets.look.tokens import Tokens, tokens

_LIGHT = (0.82, 1.0, 0.68)
"""How light the sides across x, y and z are."""
_PARTIAL = 0.45
"""So much of its colour a cell has that is filled in part."""
_MOST_SIDES = 6_000


class SolidRun(NamedTuple):
    """``cells`` (n, 5) so far, in a cube with this corner (3,) and size, seen from ``viewpoint``; ``done``:
    no more come. ``colour`` is the object's, ``fault`` says why there is nothing to step."""

    depth: DepthRun
    cells: Array
    corner: Array
    size: float
    viewpoint: Viewpoint
    colour: int
    done: bool
    fault: str = ""

    @property
    def legend(self) -> str:
        """How many cells there are of each kind, and between what the volume is."""
        if self.fault:
            return self.fault
        full, partial, empty = (int((self.cells[:, 4] == state).sum()) for state in (FULL, PARTIAL, EMPTY))
        cubes = self.cells[:, 3] ** 3
        least = float(cubes[self.cells[:, 4] == FULL].sum())
        most = float(cubes[self.cells[:, 4] != EMPTY].sum())
        said = ngettext(
            "{full:,} cell full, {partial:,} in part (pale), {empty:,} empty.",
            "{full:,} cells full, {partial:,} in part (pale), {empty:,} empty.",
            full,
        ).format(full=full, partial=partial, empty=empty)
        if not self.done:
            return said
        return said + "<br>" + _("Volume from {least:.4g} to {most:.4g}.").format(least=least, most=most)

    def picture(self, now: Tokens) -> Pixels:
        """The bare ground, over which cells are drawn."""
        return np.full(self.depth.size[::-1], packed(now.canvas), np.uint32)

    def drawn(self) -> tuple[Drawn, ...]:
        """The cube, the cells that are not empty, from back to front, and the cell that came last."""
        if self.fault:
            return ()
        now = tokens()
        drawn: list[Drawn] = [
            PenStroke(edge, "muted", 1.0, "dot")
            for edge in cube_edges(self.corner, self.size, self.viewpoint)
        ]
        sides = sides_seen(self.cells, self.corner, self.size, self.viewpoint)
        for ring, state, axis in zip(
            sides.rings[-_MOST_SIDES:],
            sides.states[-_MOST_SIDES:].tolist(),
            sides.axes[-_MOST_SIDES:].tolist(),
            strict=True,
        ):
            share = 1.0 if state == FULL else _PARTIAL
            drawn.append(
                Tint(ring, _mixed(packed(now.canvas), self.colour, share, _LIGHT[axis]), 255, "muted")
            )
        if len(self.cells) and not self.done:
            x, y, z, side, state = self.cells[-1].tolist()
            pattern = "dot" if state == EMPTY else "solid"
            edges = cube_edges(np.array([x, y, z]), side, self.viewpoint)
            drawn += [PenStroke(edge, "accent", 2.0, pattern) for edge in edges]  # type: ignore[arg-type]
        return tuple(drawn)


def _mixed(ground: int, colour: int, share: float, light: float) -> str:
    """A share of a colour over the ground, darkened, as "#RRGGBB"."""
    channels = []
    for shift in (16, 8, 0):
        low, high = ground >> shift & 255, colour >> shift & 255
        channels.append(round((low + share * (high - low)) * light))
    return "#{:02X}{:02X}{:02X}".format(*channels)


def solid_run(depth: DepthRun, session: Session) -> SolidRun:
    """How far the session's run has come."""
    sheet, subject = session.sheet, session.subject
    call, viewpoint = octrees_call(sheet, subject), _viewpoint(sheet, depth)
    things = octree_objects(sheet, subject)
    assert sheet.scene is not None
    materials = {material.id: material.colour for material in sheet.scene.materials}
    colour = materials[things[0].material] if things else 0
    nothing = np.zeros((0, 5))
    if call is None:
        said = _(
            "Two visible solids are combined: add another sphere, ellipsoid, torus, cylinder, cone or box."
        )
        return SolidRun(depth, nothing, np.zeros(3), 1.0, viewpoint, colour, True, said)
    corner, size = (call.arguments[call.entry.parameter_names.index(name)] for name in ("corner", "size"))
    run, rows, done = method_run(session), nothing, False
    if run is not None and run.recording is not None and run.moment is not None:
        count = len(run.moment.emitted) if run.detail or run.step is None else run.step.emitted_to
        rows = np.array(run.recording.emitted.array(0, count), np.float64).reshape(-1, 5)
        done = bool(len(rows)) and (rows[:, 3] ** 3).sum() > (1 - 1e-9) * size**3
    return SolidRun(depth, rows, corner, size, viewpoint, colour, done)


def _viewpoint(sheet: Sheet, depth: DepthRun) -> Viewpoint:
    """From where the coarse picture is seen."""
    assert sheet.scene is not None
    meshes = [np.zeros((0, 3)), *(mesh.vertices for mesh, *_rest in placed(sheet.scene))]
    return Viewpoint.of(sheet.scene.camera, depth.size, window_of(sheet), np.concatenate(meshes))
