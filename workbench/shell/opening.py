"""Opening what is built in: an example or a question, in its workspace, on its page, at its step."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec.structs import replace

from workbench.document.samples.examples import Example, example

if TYPE_CHECKING:
    from workbench.document.model import Sheet
    from workbench.shell.questions import Question
    from workbench.shell.window import MainWindow


def open_example(window: MainWindow, slug: str, step: int | None = None) -> None:
    """Open a built-in picture in its workspace, at a step if one is given."""
    chosen = example(slug)
    window.files.example(slug, lambda: _enter(window, chosen.workspace, chosen, step))


def open_question(window: MainWindow, question: Question) -> None:
    """Open workspace, example and step of a question."""
    window.files.example(question.example)
    if question.frame:
        window.session.frames.show(question.frame)
    _enter(window, question.workspace, example(question.example), question.step, question.dock, question.page)


def enter_where_seen(window: MainWindow, left_in: str = "") -> None:
    """Go to the workspace, and in it to the page, that a picture was left in, by the name of its run; or else
    to one where its sheet can be seen.
    """
    of_pages = {
        run: (slug, page)
        for slug in window.workspace_slugs
        for run, page in window.workspace(slug).pages.items()
    }
    if left_in in of_pages:
        workspace, page = of_pages[left_in]
        enter_page(window, workspace, page)
        return
    places = (left_in, place_for(window.session.sheet), "draw")
    window.enter(next(place for place in places if place in window.workspace_slugs))


def enter_page(window: MainWindow, workspace: str, page: str) -> None:
    """Go to a page of a workspace."""
    window.enter(workspace, lambda: window.panels(workspace)[0].show_page(page))


def place_for(sheet: Sheet) -> str:
    """The workspace where what a sheet has can be seen: its motion, its scene, or its figures."""
    if sheet.motion is not None and sheet.motion.tracks:
        return "animate"
    if sheet.scene is not None and sheet.scene.objects and not sheet.figures:
        return "space"
    return "draw"


def _enter(
    window: MainWindow, workspace: str, chosen: Example, step: int | None, dock: str = "", page: str = ""
) -> None:
    """Show a workspace, in it ``page`` or the one that an example is about, there a step, a dock in front."""

    def arrive() -> None:
        at_home = workspace == chosen.workspace
        window.panels(workspace)[0].show_page(page or (chosen.page if at_home else ""))
        if chosen.entry and at_home and page in ("", chosen.page):
            session = window.session
            session.update_state(subject=replace(session.subject, entry=chosen.entry), step=0)
        if step is not None:
            window.session.update_state(step=step)
        if dock or chosen.dock:
            window.arrangements.bring_forward(dock or chosen.dock)

    window.enter(workspace, arrive)
