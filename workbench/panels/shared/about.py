"""About this algorithm: what the run's entry declares, and the step up to the next rung of its ladder."""

from workbench.session.session import Session


def may_choose(session: Session, slug: str) -> bool:
    """Whether this algorithm can be chosen for what is being stepped."""
    return slug in session.choices_of()


def choose(session: Session, slug: str) -> None:
    """Let what is being stepped be made by this algorithm; nothing happens where that cannot be."""
    if may_choose(session, slug):
        session.choose(slug)
        if session.state.compare == slug:
            session.update_state(compare="")
