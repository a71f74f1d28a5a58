"""Why this pixel? Every fragment that came to it, its depth against the stored one; a click goes there."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLabel, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from workbench.language import _, ngettext
from workbench.panels.space.visibility.depth_run import DepthRun
from workbench.session.session import Session
from workbench.widgets.look.icons import icon


class FragmentList(QWidget):
    """The fragments of ``session.state.pixel``; with *Ask first* those that came so far."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._shown: tuple[object, ...] = ()
        self.caption = QLabel()
        self.caption.setWordWrap(True)
        self.caption.setContentsMargins(12, 8, 12, 4)
        self.list = QListWidget()
        self.list.setWordWrap(True)
        self.list.setIconSize(QSize(16, 16))
        self.list.setAccessibleName(_("Fragments of the pixel"))
        self.list.setToolTip(_("Click a line to go to that step"))
        self.list.setFrameShape(QListWidget.Shape.NoFrame)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.itemClicked.connect(self._go)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.caption)
        column.addWidget(self.list, 1)
        self.setAutoFillBackground(True)

    def refresh(self, run: DepthRun | None) -> None:
        """Follow the run."""
        pixel = self._session.state.pixel
        if run is None or pixel is None:
            self._shown = ()
            self.list.clear()
            self.caption.setText(_("Click a pixel, or point at one and press Y: what came to it?"))
            return
        numbers = run.fragments.at(*pixel).tolist()
        if run.hidden:
            numbers = [number for number in numbers if number < run.reached]
        shown = run.call, pixel, len(numbers)
        if not self._shown or shown[0] is not self._shown[0] or shown[1:] != self._shown[1:]:
            self._shown = shown
            self._list(run, pixel, numbers)
        self._mark(run)

    def _list(self, run: DepthRun, pixel: tuple[int, int], numbers: list[int]) -> None:
        self.list.clear()
        text = ngettext("{n} fragment came to it.", "{n} fragments came to it.", len(numbers))
        said = text.format(n=len(numbers)) if numbers else _nothing(run)
        self.caption.setText(f"<b>({pixel[0]}, {pixel[1]})</b> {said}")
        winners = [number for number in numbers if run.fragments.won[number]]
        for number in numbers:
            self.list.addItem(self._item(run, number, number == winners[-1]))

    def _item(self, run: DepthRun, number: int, stands: bool) -> QListWidgetItem:
        fragments = run.fragments
        won = bool(fragments.won[number])
        verb = _("refused") if not won else _("won, and stands") if stands else _("won")
        text = (
            _("{z} is less than {stored}, stored there.")
            if won
            else _("{z} is not less than {stored}, stored there.")
        )
        name = run.name_of(int(fragments.surface[number]))
        head = _("Step {n}: {surface}, {verb}.").format(n=number + 1, surface=name, verb=verb)
        z, stored = float(fragments.z[number]), float(fragments.stored[number])
        told = text.format(z=run.depth_text(z), stored=run.depth_text(stored))
        item = QListWidgetItem(icon("check" if won else "x", "text" if won else "warn"), f"{head}\n{told}")
        font = item.font()
        font.setWeight(font.Weight.DemiBold if stands else font.Weight.Normal)
        item.setFont(font)
        item.setData(Qt.ItemDataRole.UserRole, number + 1)
        return item

    def _mark(self, run: DepthRun) -> None:
        """The line of the present step is the current one."""
        rows = [self.list.item(k).data(Qt.ItemDataRole.UserRole) for k in range(self.list.count())]
        self.list.setCurrentRow(rows.index(run.reached) if run.reached in rows else -1)

    def _go(self, item: QListWidgetItem) -> None:
        self._session.update_state(step=item.data(Qt.ItemDataRole.UserRole), detail=False)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter goes to the step that is marked."""
        item = self.list.currentItem()
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and item is not None:
            self._go(item)
        else:
            super().keyPressEvent(event)


def _nothing(run: DepthRun) -> str:
    z = run.depth_text(run.farthest)
    if run.hidden:
        return _("No fragment has come to it yet: it holds z = {z}.").format(z=z)
    return _("No surface covers it: it keeps z = {z} and the colour of the ground.").format(z=z)
