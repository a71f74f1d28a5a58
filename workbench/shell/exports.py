"""What the Export menu offers: the picture, the drawing, a step, the run, points and tables."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from PySide6.QtCore import QObject

from workbench.language import _, at_most, ngettext
from workbench.shell.writing import Writing

if TYPE_CHECKING:
    from workbench.exchange.writing import FileFormat
    from workbench.panels.panel import Panel
    from workbench.panels.stage.export import Exporter
    from workbench.shell.window import MainWindow

_PICTURE_PX = 1600
_SECONDS = (2.0, 1.0, 0.5, 0.2, 0.1, 0.04)


class TableOffer(NamedTuple):
    """One table that can be exported now."""

    title: str
    ask: Callable[[], None]


class Exports(QObject):
    """The commands of the Export menu; ``writing`` writes."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.writing = Writing(window)
        window.entered.connect(self._offer)

    def _offer(self, workspace: str) -> None:
        """Let the menus of the canvases lead here too."""
        self.writing.rest()
        for panel in self._window.panels(workspace):
            panel.offer_export(self._window.menus.submenus["export"])

    def picture(self) -> None:
        """Every pixel of the sheet."""
        from workbench.rendering import frame_buffer

        sheet = self._window.session.sheet
        cell = max(1, _PICTURE_PX // max(sheet.width_px, sheet.height_px))
        self.writing.ask("picture", "", lambda: (frame_buffer(sheet), cell))

    def drawing(self) -> None:
        """The figures of the sheet, and what of them is not exact."""
        from workbench.exchange.svg_writing import Exported, write_svg

        def notes(exported: Exported) -> list[str]:
            inexact = _("What SVG cannot express exactly is approximated within {error}.")
            error = [inexact.format(error=at_most(exported.error))] if exported.error > 0 else []
            return [*error, *exported.notes]

        self.writing.ask("drawing", "", partial(write_svg, self._window.session.sheet), notes)

    def step(self) -> None:
        """What the canvas shows."""
        exporter = self._exporter()
        if exporter is not None:
            pages = exporter.this_step()
            self.writing.ask("step", _("step"), lambda: pages)

    def run(self) -> None:
        """Every step of the run: how is chosen on the card."""
        from workbench.panels.stage.pages import formats_of
        from workbench.widgets.fields.writing_card import Pictures

        exporter = self._exporter()
        if exporter is None or self.writing.is_busy():
            return
        if not exporter.steps:
            nothing = _("No run is recorded; draw or select a figure whose steps are shown.")
            self._window.say_status(_kept_back() if exporter.kept_back else nothing)
            return
        parts, whole = exporter.this_run().parts, exporter.steps + 1

        def note(file_format: FileFormat) -> str:
            count = ngettext("{n} picture", "{n} pictures", parts).format(n=parts)
            if parts < whole:
                count = _("The first {n} of {whole:,} pictures").format(n=parts, whole=whole)
            paths = file_format.paths(self.writing.proposed(_("run"), file_format.suffix), parts)
            names = paths[0].name if len(paths) == 1 else f"{paths[0].name} … {paths[-1].name}"
            return _("{count}: {names}").format(count=count, names=names)

        texts = {
            ".png": _("PNG, one file per step"),
            ".pdf": _("PDF, one page per step"),
            ".gif": _("Animated GIF"),
        }
        formats = [(each, texts.get(each.suffix, each.title)) for each in formats_of("run")]
        speeds = [(_speed_text(seconds), seconds) for seconds in _SECONDS]
        offered = Pictures(_("Export this run"), formats, speeds, 1.0, note, self._ask_run)
        self.writing.card.offer(offered)

    def _ask_run(self, file_format: FileFormat, width: int, seconds: float) -> None:
        exporter = self._exporter()
        if exporter is not None:
            pages = exporter.this_run(self.writing.writer.ask, width, seconds)
            self.writing.ask_pictures(_("Export this run"), _("run"), file_format, pages)

    def points(self) -> None:
        """The points of the curve that is worked on."""
        points = [point for panel in self._panels() for point in panel.points()]
        if points:
            self.writing.ask("points", _("points"), lambda: points)
        else:
            self._window.say_status(_("Select a curve in Curves first, to export its points."))

    def derivation(self) -> None:
        """The page of formulas that derives what the workspace shows."""
        made = next((page for panel in self._panels() if (page := panel.derivation()) is not None), None)
        if made is None:
            self._window.say_status(_("Go to a workspace with matrices first, such as Transform or View."))
        else:
            self.writing.ask("derivation", _("derivation"), lambda: made)

    def tube(self) -> None:
        """The drawing of the tube, with labels or without."""
        made = next((page for panel in self._panels() if (page := panel.drawing()) is not None), None)
        if made is None:
            self._window.say_status(_("Go to the page Gun of Display first, where the tube is cut open."))
        else:
            self.writing.ask("derivation", _("tube"), lambda: made)

    def hand_table(self) -> None:
        """The hand table of the run."""
        if not self._hand_rows():
            nothing = _("There is no hand table yet; draw or select a figure that is stepped.")
            self._window.say_status(_kept_back() if self._window.session.run.kept_back else nothing)
            return
        from workbench.engine.observation import Steps
        from workbench.exchange.run_tables import hand

        run, rows = self._window.session.run, self._hand_rows()
        entry, recording = run.entry, run.recording
        self.writing.ask("table", _("table"), lambda: hand(Steps(entry, recording), range(rows)))

    def tables(self) -> list[TableOffer]:
        """Every other table that can be exported now."""
        session = self._window.session
        offers: list[TableOffer] = []
        if session is None:
            return offers
        run, figure = session.run, session.active_figure

        def offer(title: str, make: Callable[[], Any]) -> None:
            offers.append(TableOffer(title, partial(self.writing.ask, "table", title.lower(), make)))

        if figure is not None:
            offer(_("Pixels in the order in which they are painted"), partial(_pixels, session.sheet, figure))
        if run.recording is not None and not run.ask_first:
            from workbench.exchange.run_tables import lines

            offer(_("Every line with its variables"), partial(lines, run.recording))
        if run.step is not None:
            for title, (columns, rows) in run.step.tables.items():
                if rows:
                    offer(_("{table} at this step").format(table=_(title)), partial(_table, columns, rows))
        for panel in self._panels():
            for title, table in panel.tables():
                offer(title, partial(_as_it_is, table))
        return offers

    def _hand_rows(self) -> int:
        run = self._window.session.run
        return run.tellable if run.entry is not None and run.entry.columns else 0

    def _panels(self) -> list[Panel]:
        return self._window.panels(self._window.place)

    def _exporter(self) -> Exporter | None:
        """That of the workspace that is shown; where there is none that is said."""
        for panel in self._panels():
            if panel.exporter is not None:
                return panel.exporter
        self._window.say_status(
            _("A step is exported with its canvas: go to Draw, Fill, Clip, Transform, View or Curves.")
        )
        return None


def _kept_back() -> str:
    return _("The steps are kept back while Ask first is on; answer the first one, or switch Ask first off.")


def _pixels(sheet: Any, figure: Any) -> Any:
    from workbench.exchange.tables import Table
    from workbench.panels.stage.picture import pixel_rows

    return Table(("k", "x", "y"), pixel_rows(sheet, figure))


def _as_it_is(table: Any) -> Any:
    return table


def _table(columns: tuple[str, ...], rows: Any) -> Any:
    from workbench.exchange.tables import Table

    return Table(columns, list(rows))


def _speed_text(seconds: float) -> str:
    if seconds > 1:
        return _("{n:g} seconds per step").format(n=seconds)
    each = round(1 / seconds)
    return ngettext("{n} step per second", "{n} steps per second", each).format(n=each)
