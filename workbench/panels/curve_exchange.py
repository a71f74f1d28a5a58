"""Curves in and out: points by clipboard and CSV, paths by SVG."""

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from msgspec.structs import replace
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QFileDialog, QWidget

from workbench.document.curve_edits import add_points
from workbench.document.curve_pieces import goes_round
from workbench.document.edits import Edit, add_figures
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Curve, CurvePoint, Sheet
from workbench.engine import background
from workbench.exchange.point_lists import PointsError, read_points, write_points
from workbench.exchange.svg_paths import Imported, SvgError, read_svg
from workbench.language import _, ngettext
from workbench.panels.curve_focus import CurveFocus
from workbench.panels.curve_freehand import FIT_PX, fit_words, fitted
from workbench.panels.figure_actions import Row
from workbench.rendering import device_map

_SVG = "SVG (*.svg)"
_READ_AT_ONCE = 20_000
_POINTS = "CSV (*.csv);;" + "TXT (*.txt)"


class CurveExchange(QObject):
    """The commands that bring points and curves in, and copy them. ``said`` sends what became of it.

    ``model`` gives a curve without points that new ones are like.
    """

    said = Signal(str)
    _read = Signal(object, object)

    def __init__(self, focus: CurveFocus, model: Callable[[], Curve], owner: QWidget) -> None:
        super().__init__(owner)
        self.focus, self._model, self._owner = focus, model, owner
        self.session = focus.session
        self._read.connect(self._take_found)

    def rows(self) -> list[Row]:
        """Name, text, icon, key and what it does."""
        return [
            ("copy_points", _("Copy points"), "copy-simple", "", self.copy),
            ("paste_points", _("Paste points or paths"), "clipboard-text", "", self.paste),
            ("paste_fitted", _("Fit a curve to pasted points"), "clipboard-text", "", self.paste_fitted),
            ("import_svg", _("Bring in SVG..."), "download-simple", "", self.ask_svg),
            ("import_points", _("Bring in points from CSV..."), "download-simple", "", self.ask_points),
        ]

    # The clipboard

    def copy(self) -> None:
        """Put the chosen points, or with none chosen all of the curve, on the clipboard as a table."""
        curve = self.focus.curve
        if curve is None:
            self.said.emit(_("Select one curve first."))
            return
        places = self.places(curve)
        QGuiApplication.clipboard().setText(write_points(places, "\t"))
        text = ngettext("{n} point copied.", "{n} points copied.", len(places))
        self.said.emit(text.format(n=len(places)))

    def places(self, curve: Curve) -> list[tuple[float, float]]:
        """The chosen points of the curve, or with none chosen all of them."""
        numbers = self.focus.numbers(curve) or range(len(curve.points_world))
        return [(curve.points_world[k].x, curve.points_world[k].y) for k in numbers]

    def paste(self) -> None:
        """Points on the clipboard go on the end of the selected curve, or make one; SVG becomes figures."""
        text = QGuiApplication.clipboard().text()
        if "<svg" in text or "<path" in text:
            self.take_svg(text)
        else:
            self.take_points(text)

    def paste_fitted(self) -> None:
        """Fit a Bézier path to the points on the clipboard."""
        try:
            world = read_points(QGuiApplication.clipboard().text())
            points = device_map(self.session.sheet).points(world)
            made, error = fitted(self.focus, points, FIT_PX, self._model().colour)
        except ValueError as problem:
            self.said.emit(str(problem))
            return
        if self._add([made], _("Fit a curve")):
            self.said.emit(fit_words(made, len(points), error))

    # What text holds

    def take_points(self, text: str) -> None:
        """Points go on the end of the selected open curve, or make a new one."""
        try:
            places = read_points(text).tolist()
        except PointsError as problem:
            self.said.emit(str(problem))
            return
        curve = self.focus.selected
        if curve is not None and not goes_round(curve):
            done = self._apply(add_points(curve.id, [(x, y) for x, y in places]), _("Add points"))
        else:
            points = tuple(CurvePoint("", x, y) for x, y in places)
            done = self._add([replace(self._model(), points_world=points)], _("Add points"))
        if done:
            text = ngettext("{n} point added.", "{n} points added.", len(places))
            self.said.emit(text.format(n=len(places)))

    def take_svg(self, text: str | bytes) -> None:
        """The figures of an SVG come onto the sheet; a long one is read beside, meanwhile one may go on."""
        sheet = self.session.sheet
        if len(text) <= _READ_AT_ONCE:
            self._take_found(sheet, _found_in(text, sheet))
            return
        self.said.emit(_("Reading {size:,} kB of SVG ...").format(size=len(text) // 1000))

        def read() -> None:
            found = _found_in(text, sheet)
            with suppress(RuntimeError):  # this panel is gone
                self._read.emit(sheet, found)

        background.thread(read, "read SVG").start()

    def _take_found(self, sheet: Sheet, found: Imported | str) -> None:
        """What an SVG held, or the sentence that says why nothing."""
        if isinstance(found, str):
            self.said.emit(found)
            return
        if self.session.sheet.id != sheet.id:
            self.said.emit(_("Another sheet was opened before the SVG was read; bring it in again here."))
            return
        if not found.figures:
            self.said.emit(" ".join(found.notes) or _("This SVG shows nothing that is a figure."))
            return
        if self._add(found.figures, _("Bring in SVG")):
            count = len(found.figures)
            said = [ngettext("{n} figure came in.", "{n} figures came in.", count).format(n=count)]
            if found.error > 0:
                said.append(_("Arcs are at most {error:.2g} off.").format(error=found.error))
            self.said.emit(" ".join([*said, *found.notes]))

    def _add(self, figures: list[Curve] | tuple[AnyFigure, ...], name: str) -> bool:
        known = {figure.id for figure in self.session.sheet.figures}
        if not self._apply(add_figures(self.session.sheet.id, figures), name):
            return False
        made = [figure.id for figure in self.session.sheet.figures if figure.id not in known]
        self.session.update_state(selection=tuple(made), active=made[-1])
        return True

    def _apply(self, edit: Edit, name: str) -> bool:
        try:
            self.session.apply(edit, name)
        except DocumentError as problem:
            self.said.emit(problem.short)
            return False
        return True

    # Files

    def ask_svg(self) -> None:
        """Ask for an SVG and bring it in."""
        self._open(_("Bring in SVG"), _SVG)

    def ask_points(self) -> None:
        """Ask for a table of points and bring it in."""
        self._open(_("Bring in points"), _POINTS)

    def take_file(self, path: Path) -> None:
        """Bring in a file: an SVG by its ending, or else a table of points."""
        try:
            content = path.read_bytes()
        except OSError as problem:
            text = _("{path} was not read: {reason}. Choose another file.")
            self.said.emit(text.format(path=path, reason=problem.strerror or problem))
            return
        if path.suffix.lower() == ".svg":
            self.take_svg(content)
        else:
            self.take_points(content.decode("utf-8", "replace"))

    def _open(self, title: str, kinds: str) -> None:
        chosen, _kind = QFileDialog.getOpenFileName(self._owner, title, "", kinds)
        if chosen:
            self.take_file(Path(chosen))


def _found_in(text: str | bytes, sheet: Sheet) -> Imported | str:
    """What an SVG holds, placed on the sheet, or the sentence that says what is wrong with it."""
    try:
        return read_svg(text, sheet)
    except SvgError as problem:
        return str(problem)
