"""What an open window holds: document, undo, selection, runs."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.session.session import Session

__all__ = ["Session"]


def __getattr__(name: str) -> object:
    """Give ``Session`` when it is asked for: what needs no Qt here can then be imported without it."""
    if name == "Session":
        from workbench.session.session import Session

        return Session
    raise AttributeError(name)
