"""The test of back faces on the scene, as far as it is stepped: which faces are seen, and their picture."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.model import Sheet
from workbench.language import ngettext
from workbench.panels.space.visibility.depth_run import DepthRun
from workbench.panels.space.visibility.picture import paint_surfaces, surface_colours
from workbench.panels.stage.picture import Pixels, packed
from workbench.rendering.scene.fragments import NOTHING, Index
from workbench.rendering.subjects.visibility import faces_in_order
from workbench.session.run import Run
from workbench.widgets.canvas.drawing import Drawn, PenStroke
from workbench.widgets.look.tokens import Tokens

UNTOLD, BACK, SEEN = -1, 0, 1
_PALE = 0.3


class BackFaceRun(NamedTuple):
    """``told`` (t,) of each device triangle of ``depth``: whether its face is SEEN, a BACK one, or UNTOLD;
    ``now`` are the triangles of the face that was told last."""

    depth: DepthRun
    told: Index
    now: Index

    @property
    def counts(self) -> tuple[int, int]:
        """How many faces before the eye are seen so far, and how many turn away."""
        faces = np.stack([self.depth.device.objects, self.depth.device.faces, self.told], axis=1)
        each = np.unique(faces, axis=0)[:, 2]
        return int((each == SEEN).sum()), int((each == BACK).sum())

    @property
    def legend(self) -> str:
        """How many faces are told."""
        seen, back = self.counts
        said = ngettext(
            "{seen} face seen, {back} turned away (dotted).",
            "{seen} faces seen, {back} turned away (dotted).",
            seen,
        )
        return said.format(seen=seen, back=back)

    def picture(self, now: Tokens) -> Pixels:
        """The nearest of the faces that are seen, and pale what is not told yet."""
        paper = np.full(self.depth.size[::-1], packed(now.canvas), np.uint32)
        colours = surface_colours(self.depth, now)
        paint_surfaces(paper, _nearest(self, self.told == UNTOLD), colours, _PALE)
        paint_surfaces(paper, _nearest(self, self.told == SEEN), colours, 1.0)
        return paper

    def drawn(self) -> tuple[Drawn, ...]:
        """Faces that turn away dotted, the others thin, the one in hand strong."""
        device = self.depth.device
        rings = device.corners[device.triangles][:, [0, 1, 2, 0], :2]
        drawn: list[Drawn] = []
        for ring, told in zip(rings, self.told.tolist(), strict=True):
            drawn.append(PenStroke(ring, "muted", 1.0, "dot" if told == BACK else "solid"))
        drawn += [PenStroke(rings[k], "accent", 2.0) for k in self.now.tolist()]
        return tuple(drawn)


def back_face_run(depth: DepthRun, sheet: Sheet, run: Run | None) -> BackFaceRun:
    """How far the stepped ``run`` has told the faces; none of them where nothing is recorded yet."""
    rows = np.zeros((0, 3))
    if run is not None and run.recording is not None and run.moment is not None and run.step is not None:
        count = len(run.moment.emitted) if run.detail else run.step.emitted_to
        rows = run.recording.emitted.array(0, count)
    order = faces_in_order(sheet)[: len(rows)]
    seen = {face: bool(row[2]) for face, row in zip(order, rows, strict=True)}
    owners = list(zip(depth.device.objects.tolist(), depth.device.faces.tolist(), strict=True))
    worth = {True: SEEN, False: BACK, None: UNTOLD}
    told = np.array([worth[seen.get(face)] for face in owners], np.int64)
    last = order[-1] if order else None
    now = np.array([k for k, face in enumerate(owners) if face == last], np.int64)
    return BackFaceRun(depth, told, now)


def _nearest(run: BackFaceRun, among: NDArray[np.bool_]) -> Index:
    fragments = run.depth.fragments
    chosen = np.flatnonzero(among[fragments.surface])
    order = chosen[np.argsort(-fragments.z[chosen], kind="stable")]
    surfaces = np.full(run.depth.size[::-1], NOTHING)
    # Of several writes to one pixel NumPy keeps the last, which is the nearest.
    surfaces[fragments.y[order], fragments.x[order]] = fragments.surface[order]
    return surfaces
