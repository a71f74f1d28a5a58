"""Why this pixel? Every fragment that came to it, or all that was painted there; a click goes to the step."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QListWidgetItem, QWidget

from workbench.language import _, ngettext
from workbench.panels.shared.pixel_list import PixelList, line
from workbench.panels.space.visibility.depth_run import DepthRun, method_run
from workbench.panels.space.visibility.pixel_steps import PixelStep, pixel_steps
from workbench.rendering.scene.back_face_calls import BACK_FACES
from workbench.rendering.scene.fragments import NOTHING
from workbench.rendering.subjects.visibility import is_of_the_scene, method_of
from workbench.session.session import Session
from workbench.widgets.look.icons import icon


class FragmentList(PixelList):
    """The fragments of the pixel that is asked about; with *Ask first* those that came so far.

    It is asked about in the workspace that is stepped in. ``seen``: this is.
    """

    seen = Signal()

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, _("Fragments of the pixel"), parent)
        self._shown: tuple[object, ...] = ()
        self.list.setMinimumHeight(1)  # where there is little room the caption goes first

    def refresh(self, run: DepthRun | None, keeps_depths: bool = True) -> None:
        """Follow the run: the fragments, or what was painted where a method keeps no depths."""
        pixel = self._session.state.asked(self._session.state.workspace)
        if run is None or pixel is None:
            self._shown = ()
            self.list.clear()
            self._say(
                _("Click a pixel, or point at one and press Y: what reached it?")
                if is_of_the_scene(self._session.subject)
                else _("The pages Visibility and Hidden surfaces tell what reached a pixel.")
            )
            return
        if keeps_depths:
            self._list_fragments(run, pixel)
        else:
            self._list_painted(run, pixel)
        self._mark(run.reached if keeps_depths else self._session.run.number)

    def _list_fragments(self, run: DepthRun, pixel: tuple[int, int]) -> None:
        numbers = run.fragments.at(*pixel).tolist()
        if run.hidden:
            numbers = [number for number in numbers if number < run.reached]
        if self._is_shown(run, pixel, len(numbers)):
            return
        text = ngettext("{n} fragment reached it.", "{n} fragments reached it.", len(numbers))
        said = text.format(n=len(numbers)) if numbers else _nothing(run)
        winners = [number for number in numbers if run.fragments.won[number]]
        self._list(pixel, said, [self._item(run, number, number == winners[-1]) for number in numbers])

    def _list_painted(self, run: DepthRun, pixel: tuple[int, int]) -> None:
        stepped = method_run(self._session)
        if method_of(self._session.sheet, self._session.subject) == BACK_FACES:
            self._shown = ()
            self._list(
                pixel, _("Back-face removal decides about faces, not pixels: choose another method."), []
            )
            return
        steps = pixel_steps(run, stepped, *pixel)
        if self._is_shown(run, pixel, (stepped and stepped.entry, *steps)):
            return
        text = ngettext("It was painted {n} time.", "It was painted {n} times.", len(steps))
        said = text.format(n=len(steps)) if steps else _("No surface was painted there.")
        self._list(pixel, said, [_painted_item(run, step, step is steps[-1]) for step in steps])

    def _is_shown(self, run: DepthRun, pixel: tuple[int, int], rows: object) -> bool:
        """Whether these rows of the pixel are listed already; from now on they are."""
        before, self._shown = self._shown, (run.call, pixel, rows)
        return bool(before) and before[0] is run.call and before[1:] == self._shown[1:]

    def _say(self, words: str) -> None:
        """Say it above the list, and where that has no room in the tooltip."""
        self.caption.setText(words)
        self.caption.setToolTip(words)

    def _list(self, pixel: tuple[int, int], said: str, items: list[QListWidgetItem]) -> None:
        self.list.clear()
        self._say(f"<b>({pixel[0]}, {pixel[1]})</b> {said}")
        for item in items:
            self.list.addItem(item)

    def _item(self, run: DepthRun, number: int, stands: bool) -> QListWidgetItem:
        fragments = run.fragments
        won = bool(fragments.won[number])
        verb = _("refused") if not won else _("won, and remains") if stands else _("won")
        text = (
            _("{z} is less than {stored}, which is stored there.")
            if won
            else _("{z} is not less than {stored}, which is stored there.")
        )
        name = run.name_of(int(fragments.surface[number]))
        head = _("Step {n}: {surface}, {verb}.").format(n=number + 1, surface=name, verb=verb)
        z, stored = float(fragments.z[number]), float(fragments.stored[number])
        told = text.format(z=run.depth_text(z), stored=run.depth_text(stored))
        return _list_item(number + 1, f"{head}\n{told}", won, stands)

    def _mark(self, step: int) -> None:
        """The line of the present step is the current one."""
        rows = [self.list.item(k).data(Qt.ItemDataRole.UserRole) for k in range(self.list.count())]
        self.list.setCurrentRow(rows.index(step) if step in rows else -1)

    def go(self, item: QListWidgetItem) -> None:
        """Let the stepper show the step of a line."""
        self._session.update_state(step=item.data(Qt.ItemDataRole.UserRole), detail=False)

    def showEvent(self, event: QShowEvent) -> None:
        """What happened meanwhile is to be listed."""
        super().showEvent(event)
        self.seen.emit()


def _nothing(run: DepthRun) -> str:
    z = run.depth_text(run.farthest)
    if run.hidden:
        return _("No fragment has reached it yet: it holds z = {z}.").format(z=z)
    return _("No surface covers it: it keeps z = {z} and the background colour.").format(z=z)


def _painted_item(run: DepthRun, step: PixelStep, stands: bool) -> QListWidgetItem:
    verb = _("painted, and remains") if stands else _("painted")
    head = _("Step {n}: {surface}, {verb}.").format(n=step.step, surface=run.name_of(step.surface), verb=verb)
    z, under = run.depth_text(step.z), run.depth_text(step.under_z)
    if step.under == NOTHING:
        told = _("z = {z}, over the background.").format(z=z)
    elif step.hides_nearer:
        told = _("z = {z}, over what is nearer, {under}.").format(z=z, under=under)
    else:
        told = _("z = {z}, over {under}, which is not nearer.").format(z=z, under=under)
    return _list_item(step.step, f"{head}\n{told}", not step.hides_nearer, stands)


def _list_item(step: int, text: str, right: bool, stands: bool) -> QListWidgetItem:
    return line(icon("check" if right else "x", "text" if right else "warn"), text, step, stands)
