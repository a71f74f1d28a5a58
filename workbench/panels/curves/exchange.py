"""Curves in and out: points by clipboard and CSV, paths by SVG."""

import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from workbench.document.building import Edit, foreseen
from workbench.document.curves.edits import add_points
from workbench.document.curves.pieces import goes_round
from workbench.document.edits import add_drawing, add_figures
from workbench.document.errors import DocumentError
from workbench.document.model import Curve, CurvePoint, Document, Sheet
from workbench.exchange.point_lists import Array, write_points
from workbench.exchange.readable import kind_of
from workbench.exchange.reading import LIMITS, Fitted, Job
from workbench.exchange.svg_paths import Imported
from workbench.language import _, at_most, legible, ngettext
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.freehand import FIT_PX, fit_words
from workbench.panels.stage.actions import PanelCommand
from workbench.session.incoming import Prepare

_PATH_DATA = re.compile(r"\s*[Mm]\s*[-+.\d][^<>&\"]*\Z")
_UNSCALED = 0.005  # a scale this near to 1 would be said to be 100 %

Say = Callable[[str], object]


class CurveExchange(QObject):
    """The commands that bring points and curves in, and copy them. ``said`` sends what became of it.

    ``model`` gives a curve without points that new ones are like.
    """

    said = Signal(str)

    def __init__(self, focus: CurveFocus, model: Callable[[], Curve], owner: QWidget) -> None:
        super().__init__(owner)
        self.focus, self._model = focus, model
        self.session = focus.session

    def rows(self) -> list[PanelCommand]:
        """Name, text, icon, key and what it does."""
        return [
            ("copy_points", _("Copy points"), "copy-simple", "", self.copy),
            ("paste_points", _("Paste points or paths"), "clipboard-text", "", self.paste),
            ("paste_fitted", _("Fit a curve to pasted points"), "clipboard-text", "", self.paste_fitted),
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
        """Points on the clipboard go on the end of the selected curve, or make one; SVG becomes figures.

        So does what stands in the ``d`` of a path alone.
        """
        text = QGuiApplication.clipboard().text()
        if "<svg" in text or "<path" in text:
            self.take_svg(text)
        elif _PATH_DATA.match(text):
            self.take_svg(f'<path fill="none" stroke="black" d="{text.strip()}"/>')
        else:
            self.take_points(text)

    def paste_fitted(self) -> None:
        """Fit a Bézier path to the points on the clipboard."""
        text, sheet = QGuiApplication.clipboard().text(), self.session.sheet
        job = Job("fit", sheet=sheet, tolerance_px=FIT_PX, colour=self._model().colour)
        self._read_text(job, text, _("points"), partial(self._take_fitted, sheet))

    # What text holds

    def take_points(self, text: str) -> None:
        """Points go on the end of the selected open curve, or make a new one."""
        self._read_text(
            Job("points"), text, _("points"), partial(self._take_places, self.said.emit, self.said.emit)
        )

    def take_svg(self, text: str) -> None:
        """The figures of an SVG come onto the sheet."""
        sheet = self.session.sheet
        self._read_text(
            Job("drawing", sheet=sheet), text, _("SVG"), *self._drawn(sheet, self.said.emit, self.said.emit)
        )

    def take_file(self, path: Path, say: Say, refuse: Say) -> None:
        """Bring in a file: an SVG by its ending, or else a table of points.

        ``say`` is told by name what came in, ``refuse`` why nothing did.
        """
        sheet = self.session.sheet

        def tell(how: Say, sentence: str) -> None:
            how(_("{name}: {sentence}").format(name=legible(path.name), sentence=sentence))

        tell_done, tell_refused = partial(tell, say), partial(tell, refuse)
        if kind_of(path) == "drawing":
            job, how = Job("drawing", str(path), sheet=sheet), self._drawn(sheet, tell_done, tell_refused)
            self._read(job, path.name, tell_refused, *how)
        else:
            job = Job("points", str(path))
            self._read(job, path.name, tell_refused, partial(self._take_places, tell_done, tell_refused))

    def _read_text(self, job: Job, text: str, name: str, *how: Any) -> None:
        content = text[: LIMITS[job.kind] + 1].encode("utf-8", "replace")  # what is more is refused anyway
        self._read(replace(job, content=content), name, self.said.emit, *how)

    def _read(self, job: Job, name: str, refuse: Say, take: Callable[[Any], None], *prepare: Prepare) -> None:
        """Read what is short at once, and else beside: meanwhile one may go on."""
        self.session.incoming.read(job, name, take, refuse, *prepare)

    def _drawn(self, sheet: Sheet, say: Say, refuse: Say) -> tuple[Callable[[Any], None], Prepare]:
        """What takes a drawing onto the sheet, and what prepares it."""
        take = partial(self._take_drawing, sheet, say, refuse)
        return take, partial(_with_edit, self.session.document, sheet.id)

    def _take_fitted(self, sheet: Sheet, result: Fitted) -> None:
        say, edit = self.said.emit, add_figures(sheet.id, [result.curve])
        if self._is_still(sheet, say) and self._add(edit, _("Fit a curve"), say):
            say(fit_words(result.curve, result.points, result.error))

    def _take_places(self, say: Say, refuse: Say, points: Array) -> None:
        places = points.tolist()
        curve = self.focus.selected
        if curve is not None and not goes_round(curve):
            done = self._apply(add_points(curve.id, [(x, y) for x, y in places]), _("Add points"), refuse)
        else:
            curve_points = tuple(CurvePoint("", x, y) for x, y in places)
            curve = replace(self._model(), points_world=curve_points)
            done = self._add(add_figures(self.session.sheet.id, [curve]), _("Add points"), refuse)
        if done:
            text = ngettext("{n} point added.", "{n} points added.", len(places))
            say(text.format(n=len(places)))

    def _take_drawing(self, sheet: Sheet, say: Say, refuse: Say, prepared: tuple[Imported, Edit]) -> None:
        """Put what an SVG held on the sheet, or say why there is nothing."""
        drawing, edit = prepared
        if not self._is_still(sheet, refuse):
            return
        if not drawing.figures:
            refuse(" ".join(drawing.notes) or _("This SVG contains no figures."))
            return
        if self._add(edit, _("Import SVG"), refuse):
            count = len(drawing.figures)
            said = [ngettext("{n} figure imported.", "{n} figures imported.", count).format(n=count)]
            if abs(drawing.scale - 1.0) > _UNSCALED:
                text = _("Scaled to {percent} % to fit the sheet.")
                said.append(text.format(percent=_percent(drawing.scale)))
            if drawing.error > 0:
                text = _("Arcs and curved outlines are approximated within {error}.")
                said.append(text.format(error=at_most(drawing.error)))
            say(" ".join([*said, *drawing.notes]))

    def _is_still(self, sheet: Sheet, refuse: Say) -> bool:
        """Whether the sheet that something was read for is still the current one; says so if not."""
        if self.session.sheet.id == sheet.id:
            return True
        refuse(_("Another sheet was opened before this had been read; import it again here."))
        return False

    def _add(self, edit: Edit, name: str, refuse: Say) -> bool:
        """Do an edit that adds figures, and select them."""
        known = {figure.id for figure in self.session.sheet.figures}
        if not self._apply(edit, name, refuse):
            return False
        added = [figure.id for figure in self.session.sheet.figures if figure.id not in known]
        self.session.update_state(selection=tuple(added), active=added[-1])
        return True

    def _apply(self, edit: Edit, name: str, refuse: Say) -> bool:
        try:
            self.session.apply(edit, name)
        except DocumentError as problem:
            refuse(problem.short)
            return False
        return True


def _percent(scale: float) -> str:
    percent = 100.0 * scale
    return f"{percent:,.0f}" if percent >= 10.0 else f"{percent:.2g}"


def _with_edit(document: Document, sheet: str, result: Any) -> tuple[Imported, Edit]:
    """A drawing, and the edit that brings it onto the sheet, which for a large one takes its time.

    Raises: DocumentError.
    """
    return result, foreseen(add_drawing(sheet, result.figures, result.palette), document)
