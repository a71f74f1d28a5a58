"""What edits of curves are made of."""

from collections.abc import Callable

from workbench.document.addresses import figure_with
from workbench.document.building import Edit, numbered, remembering, with_changed
from workbench.document.errors import DocumentError
from workbench.document.model import Curve, Document
from workbench.language import _


def curve_with(document: Document, figure: str) -> Curve:
    """The curve with this id; raises DocumentError."""
    curve = figure_with(document, figure)[1]
    if not isinstance(curve, Curve):
        sentence = _("Figure {id!r} is not a curve; choose a curve.")
        raise DocumentError(figure, sentence.format(id=figure))
    return curve


def changing(figure: str, change: Callable[[Curve], Curve]) -> Edit:
    """The edit that puts ``change(curve)`` in place of a curve; what is new in it gets ids of its own."""

    def edit(document: Document) -> Document:
        old = curve_with(document, figure)
        try:
            new = numbered(document, change(old))
        except ValueError as problem:
            raise DocumentError(figure, str(problem)) from problem
        after = with_changed(document, [new])
        return after if set(old.ids) <= set(new.ids) else remembering(document, after)

    return edit
