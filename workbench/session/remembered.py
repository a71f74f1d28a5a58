"""What a file remembers of its runs, as far as this version of the program can run it."""

from msgspec.structs import replace

from workbench.document.errors import DocumentError
from workbench.document.state import SessionState
from workbench.language import _
from workbench.rendering.subjects.registry import checked


def runnable(state: SessionState) -> tuple[SessionState, list[str]]:
    """``state`` without the positions that cannot be run here, and a sentence for each of these."""
    positions, sentences = {}, []
    for workspace, position in state.positions.items():
        try:
            checked(position.subject)
            positions[workspace] = position
        except DocumentError as problem:
            sentence = _("The step to open at was left out: {problem}")
            sentences.append(sentence.format(problem=problem))
    return (replace(state, positions=positions), sentences) if sentences else (state, [])
