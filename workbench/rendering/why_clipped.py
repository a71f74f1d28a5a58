"""Why is this pixel empty, where a figure would come to it but is clipped: by what, and in which step."""

from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Stroke
from workbench.document.model import AnyFigure, Sheet
from workbench.engine.calls import own_call
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.geometry.distance import polyline_distance
from workbench.language import _
from workbench.rendering.clipping import clip_box, clipper_calls, clipper_of
from workbench.rendering.mapping import Call
from workbench.rendering.raster import painter_of
from workbench.rendering.rounds import is_lines

_LEFT_OVER = "data1"  # the ink in which a clipper of lines draws what it has not yet cut away
_NEAR_PX = 0.75
_MOST_CALLS = 200


def clipped_away(sheet: Sheet, x: int, y: int) -> str:
    """The sentence for device pixel (x, y) if a figure would have painted it without clipping, or nothing."""
    if all(view.clip_world is None for view in sheet.views):
        return ""
    whole = replace(sheet, views=tuple(replace(view, clip_world=None) for view in sheet.views))
    inside = 0 <= x < sheet.width_px and 0 <= y < sheet.height_px
    painter = int(painter_of(whole)[y, x]) if inside else -1
    if painter < 0:
        return ""
    figure = sheet.figures[painter]
    name = figure.name or _(catalogue.get(figure.drawn_with).title)
    said = _("{name} would come to ({x}, {y}), but this is {where} the clip window").format(
        name=name, x=x, y=y, where=_where(sheet, x, y)
    )
    clipper = clipper_of(sheet, figure)
    if not clipper:
        return _("{said}, so it is not painted there.").format(said=said)
    called = _(catalogue.get(clipper).title)
    step = _step(sheet, figure, x, y) if is_lines(figure) else 0
    if step:
        return _("{said}: {clipper} cuts it off in step {step}.").format(said=said, clipper=called, step=step)
    return _("{said}: {clipper} cuts it off.").format(said=said, clipper=called)


def _where(sheet: Sheet, x: int, y: int) -> str:
    box = clip_box(sheet)
    if box is None:
        return _("outside")
    xmin, ymin, xmax, ymax = box
    up = _("above") if y > ymax else _("below") if y < ymin else ""
    across = _("left of") if x < xmin else _("right of") if x > xmax else ""
    return _(" and ").join(word for word in (up, across) if word) or _("at the edge of")


def _step(sheet: Sheet, figure: AnyFigure, x: int, y: int) -> int:
    """The step, over all segments of a figure, that cuts off what comes to the pixel; 0 where none does."""
    calls, before = clipper_calls(sheet, figure), 0
    for call in calls if len(calls) <= _MOST_CALLS else ():
        steps = Steps(call.entry, record(call.entry.function, *call.arguments))
        near = [number for number in range(len(steps) + 1) if _comes_near(call, steps, number, x, y)]
        if near and near[-1] < len(steps):
            return before + near[-1] + 1
        before += len(steps)
    return 0


def _comes_near(call: Call, steps: Steps, number: int, x: int, y: int) -> bool:
    """Whether what is left of a segment after a step passes through the pixel."""
    step, recording = steps[number], steps.recording
    last = max(step.last, 0)
    over = last == len(recording) - 1
    now = own_call(recording, max(step.first, 0), last, step.emitted_to, over)
    marks = call.entry.marks(call.arguments, now.variables, now.emitted, now.ended)
    left = [mark.points for mark in marks if isinstance(mark, Stroke) and mark.ink == _LEFT_OVER]
    return any(polyline_distance(points, x, y) <= _NEAR_PX for points in left)
