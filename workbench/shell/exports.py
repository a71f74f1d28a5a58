"""What File, Export does: asks for a name, writes beside the window, and says what became of it."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from PySide6.QtCore import QEvent, QObject, QTimer

from workbench.language import _, ngettext
from workbench.paths import home_folder

if TYPE_CHECKING:
    from workbench.exchange.writing import Row
    from workbench.panels.panel import Panel
    from workbench.panels.stage.export import Exporter
    from workbench.session.writer import Outcome, Writer
    from workbench.shell.window import MainWindow
    from workbench.widgets.fields.writing_card import WritingCard

_PICTURE_PX = 1600
# What is written within this time needs no card.
_CARD_AFTER_MS = 400


class TableOffer(NamedTuple):
    """One table that can be exported now."""

    title: str
    ask: Callable[[], None]


class Exports(QObject):
    """The commands of the Export menu. One thing is written at a time; ``writer`` and ``card`` come late."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._notes: Callable[[Any], list[str]] = lambda _content: []
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(_CARD_AFTER_MS)
        self._soon.timeout.connect(self._show_card)
        self._name = ""
        self._closes = self._failed = False
        window.entered.connect(self._offer)

    def _offer(self, workspace: str) -> None:
        """Let the menus of the canvases lead here too."""
        if "writer" not in self.__dict__ or not self.writer.busy:
            self._close_card()
        for panel in self._window.panels(workspace):
            panel.offer_export(self._window.menus.submenus["export"])

    # What can be exported

    def picture(self) -> None:
        """Every pixel of the sheet."""
        from workbench.rendering import frame_buffer

        sheet = self._window.session.sheet
        cell = max(1, _PICTURE_PX // max(sheet.width_px, sheet.height_px))
        self._ask("picture", "", lambda: (frame_buffer(sheet), cell))

    def drawing(self) -> None:
        """The figures of the sheet, and what of them is not exact."""
        from workbench.exchange.svg_writing import Exported, write_svg

        def notes(exported: Exported) -> list[str]:
            inexact = _("What SVG cannot say exactly is at most {error:.2g} off.")
            error = [inexact.format(error=exported.error)] if exported.error > 0 else []
            return [*error, *exported.notes]

        self._ask("drawing", "", partial(write_svg, self._window.session.sheet), notes)

    def step(self) -> None:
        """What the canvas shows."""
        exporter = self._exporter()
        if exporter is not None:
            pages = exporter.this_step()
            self._ask("step", _("step"), lambda: pages)

    def run(self) -> None:
        """Every step of the run: how is chosen on the card."""
        from workbench.panels.stage.pages import rows_of

        exporter = self._exporter()
        if exporter is None or self._is_busy():
            return
        if not exporter.steps:
            self._window.say_status(_("No run is recorded; draw or select a figure whose steps are shown."))
            return
        parts, whole = exporter.this_run().parts, exporter.steps + 1

        def note(row: Row) -> str:
            count = ngettext("{n} picture", "{n} pictures", parts).format(n=parts)
            if parts < whole:
                count = _("The first {n} of {whole:,} pictures").format(n=parts, whole=whole)
            paths = row.paths(self.proposed(_("run"), row.suffix), parts)
            names = paths[0].name if len(paths) == 1 else f"{paths[0].name} … {paths[-1].name}"
            return _("{count}: {names}").format(count=count, names=names)

        self.card.offer(_("Export this run"), rows_of("run"), note)

    def points(self) -> None:
        """The points of the curve that is worked on."""
        points = [point for panel in self._panels() for point in panel.points()]
        if points:
            self._ask("points", _("points"), lambda: points)
        else:
            self._window.say_status(_("Select a curve in Curves first, to export its points."))

    def hand_table(self) -> None:
        """The hand table of the run."""
        if not self._hand_rows():
            self._window.say_status(_("There is no hand table yet; draw or select a figure that is stepped."))
            return
        from workbench.engine.observation import Steps
        from workbench.exchange.run_tables import hand

        run, rows = self._window.session.run, self._hand_rows()
        entry, recording = run.entry, run.recording
        self._ask("table", _("table"), lambda: hand(Steps(entry, recording), range(rows)))

    def tables(self) -> list[TableOffer]:
        """Every other table that can be exported now."""
        session = self._window.session
        offers: list[TableOffer] = []
        if session is None:
            return offers
        run, figure = session.run, session.active_figure

        def offer(title: str, make: Callable[[], Any]) -> None:
            offers.append(TableOffer(title, partial(self._ask, "table", title.lower(), make)))

        if figure is not None:
            offer(_("Pixels in the order of painting"), partial(_pixels, session.sheet, figure))
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
        self._window.say_status(_("Go to Draw, Fill, Clip or Curves first, where steps are shown."))
        return None

    # Asking and writing

    @cached_property
    def writer(self) -> Writer:
        """What writes."""
        from workbench.session.writer import Writer

        writer = Writer(self)
        writer.told.connect(self._tell)
        writer.ended.connect(self._ended)
        return writer

    @cached_property
    def card(self) -> WritingCard:
        """What shows the choices and the progress."""
        from workbench.widgets.fields.writing_card import WritingCard

        card = WritingCard(self._window, self._window.stack)
        card.chosen.connect(self._ask_run)
        card.cancelled.connect(self._cancel)
        return card

    def proposed(self, word: str, suffix: str) -> Path:
        """Beside the document, with its name, and a word for what it is."""
        path = self._window.session.path
        folder = path.parent if path else home_folder()
        stem = "-".join(filter(None, (self._window.files.name, word.replace(" ", "-"))))
        return folder / f"{stem}{suffix}"

    def _ask(
        self,
        kind: str,
        word: str,
        make: Callable[[], Any],
        notes: Callable[[Any], list[str]] = lambda _content: [],
    ) -> None:
        from workbench.panels.stage.pages import rows_of
        from workbench.widgets.fields.save_dialog import SaveDialog

        if self._is_busy():
            return
        rows = rows_of(kind)
        start = self.proposed(word, rows[0].suffix)

        def then(path: Path, row: Row) -> None:
            self._write(row, make, path, notes)

        SaveDialog(self._window, _("Export"), start, rows, then).open()

    def _ask_run(self, row: Row, width: int, seconds: float) -> None:
        from workbench.widgets.fields.save_dialog import SaveDialog

        exporter = self._exporter()
        if exporter is None:
            return
        pages = exporter.this_run(self.writer.ask, width, seconds)

        def then(path: Path, row: Row) -> None:
            self._write_unless_there(row, lambda: pages, path, row.paths(path, pages.parts))

        SaveDialog(
            self._window, _("Export this run"), self.proposed(_("run"), row.suffix), [row], then
        ).open()

    def _write_unless_there(self, row: Row, make: Callable[[], Any], path: Path, paths: list[Path]) -> None:
        """Write; several files ask before any is replaced, since the dialog knows but one name."""
        there = [each for each in paths if os.path.exists(each)] if row.numbered else []
        if not there:
            self._write(row, make, path)
            return
        self._close_card()
        sentence = ngettext(
            "{first} is there already; {all} files, {from_} to {to}, would be written.",
            "{n} of the {all} files {from_} to {to} are there already, the first of them {first}.",
            len(there),
        )
        self._window.messages.ask(
            sentence.format(
                n=len(there), all=len(paths), first=there[0].name, from_=paths[0].name, to=paths[-1].name
            ),
            [
                (_("Cancel"), lambda: None),
                (ngettext("Replace it", "Replace them", len(there)), lambda: self._write(row, make, path)),
            ],
        )

    def _is_busy(self) -> bool:
        if self.writer.busy:
            self._window.say_status(_("{name} is still being written.").format(name=self._name))
            return True
        return False

    def _write(
        self,
        row: Row,
        make: Callable[[], Any],
        path: Path,
        notes: Callable[[Any], list[str]] = lambda _content: [],
    ) -> None:
        if self._is_busy():
            return
        self._name, self._notes, self._closes = path.name, notes, False
        self._window.installEventFilter(self)
        if self.card.isVisible():
            self._show_card()
        else:
            self._soon.start()
        self.writer.start(row, make, path)

    def _show_card(self) -> None:
        self.card.progress(_("Writing {name}").format(name=self._name))

    def _tell(self, done: int, parts: int) -> None:
        if self.card.isVisible():
            self.card.tell(done, parts)

    def _cancel(self) -> None:
        if self.writer.busy:
            self.writer.cancel()
            self.card.stop()
        else:
            self._close_card()

    def _close_card(self) -> None:
        self._soon.stop()
        if "card" in self.__dict__:
            self.card.hide()

    def _ended(self, outcome: Outcome) -> None:
        self._window.removeEventFilter(self)
        self._close_card()
        messages = self._window.messages
        self._failed = bool(outcome.problem)
        if outcome.problem:
            messages.say(outcome.problem, "error")
        elif self._closes:
            self._window.close()
        elif outcome.cancelled:
            self._window.say_status(_("Cancelled; {name} was not written.").format(name=self._name))
        else:
            messages.say(" ".join([_written(outcome.paths), *self._notes(outcome.content)]))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """While something is being written the window does not close unasked."""
        if event.type() != QEvent.Type.Close or self._closes:
            return super().eventFilter(watched, event)
        event.ignore()
        self._window.messages.ask(
            _("{name} is still being written.").format(name=self._name),
            [
                (_("Close when it is written"), self._close_later),
                (_("Cancel it and close"), self._close_without),
                (_("Stay"), lambda: None),
            ],
        )
        return True

    def _close_later(self) -> None:
        """Close, now or at the end; what was not written is said first."""
        self._closes = True
        if not self.writer.busy and not self._failed:
            self._window.close()

    def _close_without(self) -> None:
        self.writer.cancel()
        self._closes = True
        if not self.writer.busy:
            self._window.close()


def _written(paths: tuple[Path, ...]) -> str:
    folder = paths[0].parent
    if len(paths) == 1:
        return _("{name} is written in {folder}.").format(name=paths[0].name, folder=folder)
    sentence = _("{n} files, {first} to {last}, are written in {folder}.")
    return sentence.format(n=len(paths), first=paths[0].name, last=paths[-1].name, folder=folder)


def _pixels(sheet: Any, figure: Any) -> Any:
    from workbench.exchange.tables import Table
    from workbench.panels.stage.picture import pixel_rows

    return Table(("k", "x", "y"), pixel_rows(sheet, figure))


def _as_it_is(table: Any) -> Any:
    return table


def _table(columns: tuple[str, ...], rows: Any) -> Any:
    from workbench.exchange.tables import Table

    return Table(columns, list(rows))
