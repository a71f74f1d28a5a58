"""Ask first: where a figure is in the next frame is answered by a click on the picture."""

import math

from workbench.document.motion.tracks import track_on
from workbench.rendering import figure_map
from workbench.session.session import Session

_AXES = {"x": 0, "y": 1}


def asked_axis(session: Session) -> int | None:
    """Which coordinate the run asks for, 0 or 1; None where it asks for nothing that has a place."""
    run, target = session.run, str(session.state.subject.arguments.get("target", ""))
    name, *rest = target.split("/")
    if not run.options or len(rest) != 2 or track_on(session.sheet, target) is None:
        return None
    if not any(figure.id == name and rest[0] in figure.ids for figure in session.sheet.figures):
        return None
    call = run.own_call()
    return _AXES.get(rest[1], None if rest[1] != "*" or call is None else call.number)


def answer_at(session: Session, x: float, y: float) -> bool:
    """Choose the value that is nearest to a device point; False where no place is asked for.

    Of values that lie within the same pixel the right one counts: a hand cannot tell them apart.
    """
    run, axis = session.run, asked_axis(session)
    if axis is None or run.steps is None:
        return False
    name = str(session.state.subject.arguments["target"]).split("/")[0]
    sheet = session.frames.sheet
    scale = figure_map(sheet, next(figure for figure in sheet.figures if figure.id == name))
    place, beside = scale.world_point(x, y)[axis], scale.world_point(x + 1.0, y + 1.0)[axis]
    away = {option: abs(float(str(option).replace("−", "-")) - place) for option in run.options}
    right = run.steps[run.seen + 1].answer
    run.choose(right if away.get(right, math.inf) <= abs(beside - place) else min(away, key=away.__getitem__))
    return True
