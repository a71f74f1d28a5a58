"""About this algorithm: what the run's entry declares, and the step up to the next rung of its ladder."""

from workbench.document.edits import set_algorithm, set_clipper
from workbench.document.model import AnyFigure, Curve
from workbench.language import _
from workbench.rendering.clipping import clippers_of
from workbench.rendering.curve_runs import construction_of, constructions_of
from workbench.session.session import Session


def may_choose(session: Session, slug: str) -> bool:
    """Whether this algorithm can be chosen for what is being stepped."""
    figure = session.active_figure
    if figure is None:
        return False
    match session.state.stepped:
        case "clipper":
            return slug in clippers_of(figure)
        case "curve":
            return isinstance(figure, Curve) and slug in (construction_of(figure), *constructions_of(figure))
    return slug in figure.algorithms


def choose(session: Session, slug: str) -> None:
    """Let what is being stepped be made by this algorithm; nothing happens where that cannot be."""
    figure = session.active_figure
    if figure is None or not may_choose(session, slug):
        return
    match session.state.stepped:
        case "clipper":
            session.apply(set_clipper(session.sheet.id, slug), _("Change algorithm"))
        case "curve":
            _construct(session, figure, slug)
        case _:
            session.apply(set_algorithm(figure.id, slug), _("Change algorithm"))
    if session.state.compare == slug:
        session.update_state(compare="")


def _construct(session: Session, curve: AnyFigure, slug: str) -> None:
    own = isinstance(curve, Curve) and slug == construction_of(curve)
    session.update_state(construction="" if own else slug, step=0)
