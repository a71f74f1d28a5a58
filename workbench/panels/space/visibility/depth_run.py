"""The depth buffer's run of a session, as far as it is stepped: what page and docks show."""

from typing import NamedTuple

from workbench.algorithms.visibility.device_plane import corners_of, plane
from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.scene.fragments import Fragments, fragments_of
from workbench.rendering.scene.render import DeviceTriangles
from workbench.rendering.subjects.registry import calls_of
from workbench.rendering.subjects.visibility import (
    Size,
    depth_bits,
    depth_call,
    farthest,
    scene_size,
    triangles_of,
    visible_objects,
)
from workbench.session.run import Run
from workbench.session.session import Session


class DepthRun(NamedTuple):
    """``fragments`` are all of the run, ``reached`` so many have come; ``farthest`` is what the buffer begins
    with, ``bits`` how many it has for a pixel. ``hidden``: what is to come is asked for first.
    """

    sheet: Sheet
    subject: Subject
    call: Call
    device: DeviceTriangles
    fragments: Fragments
    reached: int
    size: Size
    farthest: float
    bits: int
    hidden: bool

    @property
    def now(self) -> int | None:
        """The number of the fragment that came last; None before the first."""
        return self.reached - 1 if 0 < self.reached <= len(self.fragments) else None

    @property
    def so_far(self) -> Fragments:
        """Those that have come."""
        return self.fragments.upto(self.reached)

    def object_name(self, triangle: int) -> str:
        """What the object is called that a triangle is a part of."""
        assert self.sheet.scene is not None
        thing = visible_objects(self.sheet.scene)[int(self.device.objects[triangle])]
        return thing.name or thing.id

    def name_of(self, triangle: int) -> str:
        """The same, with the number of the triangle, as the text counts, where the object has several."""
        name = self.object_name(triangle)
        if (self.device.objects == self.device.objects[triangle]).sum() == 1:
            return name
        return _("{name}, triangle {n}").format(name=name, n=triangle)

    def plane_of(self, triangle: int) -> tuple[float, float, float, float]:
        """A, B, C, D of the device plane of a triangle."""
        return plane(*corners_of(self.device.corners, self.device.triangles, triangle))

    def depth_text(self, z: float) -> str:
        """A depth as the buffer has it: four places, or a whole number where it is one."""
        if not self.bits:
            return f"{z:.4f}"
        return f"{z:.0f}" if z == int(z) else f"{z:.2f}"


def method_run(session: Session) -> Run | None:
    """The session's run where it is that of the chosen method on the scene as it is, not of what was."""
    run = session.run
    return run if run.runs(calls_of(session.sheet, session.subject)) else None


def depth_run(session: Session) -> DepthRun | None:
    """The depth buffer's run on the scene; None where there is no scene that can be stepped.

    While another method is stepped none of its fragments has come.
    """
    subject, sheet, run = session.subject, session.sheet, session.run
    call, device = depth_call(sheet, subject), triangles_of(sheet, subject)
    if call is None or device is None:
        return None
    count = 0
    if run.runs([call]) and run.moment is not None:
        count = run.passed + len(run.moment.emitted) if run.detail else run.number
    return DepthRun(
        sheet,
        subject,
        call,
        device,
        fragments_of(call),
        count,
        scene_size(sheet, subject),
        farthest(subject),
        depth_bits(subject),
        run.ask_first,
    )
