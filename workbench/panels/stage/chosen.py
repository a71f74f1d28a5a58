"""What a panel of figures does to those that are selected."""

from PySide6.QtCore import SignalInstance

from workbench.document.edits import (
    Edit,
    duplicate_figures,
    group_figures,
    shift_order,
    ungroup_figures,
)
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure
from workbench.language import _
from workbench.panels.panel import PlainPanel
from workbench.session.session import Session


class ChosenFigures(PlainPanel):
    """Edits of the selected figures of ``session``; what is wrong with one is sent by ``hover_text``."""

    session: Session
    hover_text: SignalInstance

    def apply(self, edit: Edit, name: str, merge: str = "") -> None:
        """Do an edit; what is wrong with it is said in the status bar."""
        try:
            self.session.apply(edit, name, merge)
        except DocumentError as problem:
            self.hover_text.emit(problem.short)

    def selected(self) -> list[AnyFigure]:
        """The selected figures of the sheet, from back to front."""
        chosen = set(self.session.state.selection)
        return [figure for figure in self.session.frames.sheet.figures if figure.id in chosen]

    def duplicate_selected(self) -> bool:
        """Copy the selected figures; the copies are selected then. False where none are selected."""
        if ids := [figure.id for figure in self.selected()]:
            known = {figure.id for figure in self.session.sheet.figures}
            self.apply(duplicate_figures(ids), _("Duplicate"))
            made = [f.id for f in self.session.sheet.figures if f.id not in known]
            if made:
                self.session.update_state(selection=tuple(made), active=made[-1])
        return bool(ids)

    def shift_order(self, by: int) -> bool:
        """Move the selected figures past what is next in front of them (or behind); False where none are
        selected."""
        if ids := [figure.id for figure in self.selected()]:
            self.apply(shift_order(ids, by), _("Change order"))
        return bool(ids)

    def bring_forwards(self) -> bool:
        """Move the selected figures one place to the front; False where none are selected."""
        return self.shift_order(1)

    def send_backwards(self) -> bool:
        """Move the selected figures one place to the back; False where none are selected."""
        return self.shift_order(-1)

    def group_selected(self) -> bool:
        """Let the selected figures stay together from now on, and say so, which the picture does not; False
        where there are not two."""
        ids = [figure.id for figure in self.selected()]
        if len(ids) < 2:
            return False
        self.apply(group_figures(ids), _("Group"))
        self.hover_text.emit(
            _("{n} figures are one group; hold Alt and click to select one of them.").format(n=len(ids))
        )
        return True

    def ungroup_selected(self) -> bool:
        """Let each figure of the selected groups go by itself, and say so; False where there is none."""
        figures = self.selected()
        groups = {figure.group for figure in figures} - {0}
        if not groups:
            return False
        freed = sum(figure.group in groups for figure in self.session.sheet.figures)
        self.apply(ungroup_figures([figure.id for figure in figures]), _("Ungroup"))
        self.hover_text.emit(_("Each of the {n} figures is on its own again.").format(n=freed))
        return True
