"""The page Raster or random: one picture on both kinds of display, under one magnifying glass."""

from collections.abc import Sequence
from dataclasses import replace as replace_setup
from functools import partial

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import (
    QAction,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QResizeEvent,
    QShowEvent,
)
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from workbench.algorithms.scanning.random_scan import random_scan as text
from workbench.display.magnified import Pixels, magnified_raster, magnified_vector
from workbench.display.setup import TubeSetup, too_many_pixels
from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.comparison.bar import ComparisonBar
from workbench.panels.display.comparison.derivation import derivation
from workbench.panels.display.comparison.facts import DARK, Facts, features, measured
from workbench.panels.panel import DockPart, KeysWhileSeen, Said
from workbench.panels.shared.lighting import Lighting
from workbench.panels.shared.tube_feed import setup_of
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.display_program import Strokes
from workbench.rendering.subjects.comparison import (
    KIND,
    compared,
    lens_of,
    number_of,
)
from workbench.rendering.subjects.random_scan import MOST_LINES, shortest_ps_of, timing_of
from workbench.session.session import Session
from workbench.widgets.canvas.pixel_canvas import ARROWS
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.plots.refresh_plot import RefreshCurve, RefreshPlot
from workbench.widgets.tables.feature_table import FeatureTable
from workbench.widgets.tube.lens import TubeLens
from workbench.widgets.tube.refusal import Refusal
from workbench.widgets.tube.stroke_view import StrokeView, Trace
from workbench.widgets.tube.view import TubeView

PAGE = "comparison"
_PLOT_PX, _LOW_PX = 140, 400


class ComparisonPage(PlainPage, QWidget):
    """``hover_text``: what is said in passing."""

    hover_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND)
    example = "raster-or-random"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self._waiting = False
        self.facts: Facts | None = None
        self._image = DARK
        self._fed: dict[TubeView, object] = {}
        self._measured: object = None
        self._lighting = Lighting(self.refresh_soon, self)
        self.bar = ComparisonBar(session)
        self.raster, self.vector = TubeView("raster"), StrokeView()
        for view in (self.raster, self.vector):
            view.setToolTip(_("Move over the glass to see the same place of both tubes enlarged."))
        self.refusal = Refusal(self.raster)
        self.lenses = TubeLens(self.raster), TubeLens(self.vector)
        self.note = QLabel()
        self.note.setProperty("role", "muted")
        self.note.setWordWrap(True)
        self.note.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.plot = RefreshPlot()
        self.plot.setFixedHeight(_PLOT_PX)
        self.plot.setToolTip(_("Drag the mark: how often a second a list of so many lines is drawn."))
        self.table = FeatureTable(
            _("Raster and random scan"), _("Choose a row to read what has to be added to it")
        )
        tubes = QHBoxLayout()
        tubes.setSpacing(8)
        tubes.addWidget(self.raster)
        tubes.addWidget(self.vector)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(8, 4, 8, 6)
        whole.setSpacing(4)
        whole.addWidget(self.bar)
        whole.addLayout(tubes, 1)
        whole.addWidget(self.note)
        whole.addWidget(self.plot)
        self.setFocusProxy(self.raster)
        self._feeding = QTimer(self, singleShot=True, interval=0)  # each tube has a turn of its own
        self._feeding.timeout.connect(self._show_raster)
        self._drawing = QTimer(self, singleShot=True, interval=0)
        self._drawing.timeout.connect(self._show_vector)
        self._resting = QTimer(self)
        self._resting.setSingleShot(True)
        self._resting.setInterval(80)
        self._resting.timeout.connect(self._show_lenses)
        self._actions = self._made_actions()
        KeysWhileSeen(self, self._actions)
        self._connect()

    def _made_actions(self) -> list[QAction]:
        action = QAction(_("Show the magnifying glass"), self)
        action.setObjectName("comparison.lens")
        action.setShortcut(QKeySequence("Shift+M"))
        action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        action.setCheckable(True)
        action.setChecked(True)
        set_icon(action, "magnifying-glass-plus")
        action.toggled.connect(lambda _on: self._show_lenses())
        self.glass = action
        self.addAction(action)
        for view in (self.raster, self.vector):
            view.addAction(action)
            view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        return [action]

    def _connect(self) -> None:
        session = self.session
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed, session.ahead.arrived):
            told.connect(self.refresh_soon)
        for signal in (session.run.changed, session.run.moved, session.run.grown):
            signal.connect(self.refresh_soon)
        for view in (self.raster, self.vector):
            view.setMouseTracking(True)
            view.installEventFilter(self)
            view.sight.changed.connect(self.refresh_soon)
        self.table.currentCellChanged.connect(lambda *_cells: self._tell())
        self.plot.lines_wanted.connect(lambda lines: self._show_rate(lines))

    # What Display asks of a page

    def docks(self) -> Sequence[DockPart]:
        """The comparison, feature by feature."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return (("raster_or_random", _("Raster or random"), self.table, right),)

    def commands(self) -> Sequence[QAction]:
        """Its commands."""
        return self._actions

    def said(self) -> Said:
        """What is said in passing."""
        return Said(self.hover_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The comparison, and the rate against the number of lines."""
        if self.facts is None:
            return ()
        columns = _("feature"), _("raster scan"), _("random scan"), _("to be added")
        rows = [tuple(row) for row in features(self.facts)]
        tables = [(_("Raster and random scan"), Table(columns, rows, formulas=False))]
        numbers = self.plot.numbers()
        return [*tables, (_("Refresh rate"), numbers)] if numbers else tables

    def copy(self) -> bool:
        """Put both tubes, as they glow now, on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    def derivation(self) -> Derivation | None:
        """Question 10 answered, with diagrams and this picture's numbers."""
        return None if self.facts is None else derivation(self.facts, self._image)

    # What is shown

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen."""
        if not self._waiting and self.isVisible():
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        if not self.isVisible() or self.session.state.workspace != PAGE:
            return
        sheet, subject = self._sheet, self.session.state.subject
        of = compared(subject), self._setup, self._lighting.lit(sheet)
        if self.facts is None or (sheet, *of) != self._measured:
            make = partial(measured, sheet, subject, self._setup)
            answer = self.session.ahead.of(sheet, "comparison", make, *of)
            if answer is None:
                return
            (self.facts, self._image), self._measured = answer, (sheet, *of)
            self.refusal.say(too_many_pixels(self.facts.size))
            self._show_numbers(self.facts)
        self.bar.refresh()
        self._tell()
        self._feeding.start()

    def _show_numbers(self, facts: Facts) -> None:
        """Table and plot."""
        rows = features(facts)
        headings = "", _("Raster scan"), _("Random scan")
        self.table.show_rows(
            headings, [(row.name, row.raster, row.random) for row in rows], [row.but for row in rows]
        )
        self._show_rate(len(facts.program.strokes))

    def _show_rate(self, lines: int) -> None:
        """The plot with so many lines marked: those of the picture, until another number is asked for."""
        facts = self.facts
        if facts is None:
            return
        curve = RefreshCurve(
            facts.line.total_ps * 1e-12, shortest_ps_of(self.session.state.subject) * 1e-12,
            facts.fusion_hz, facts.most, float(facts.raster.refresh_hz),
        )  # fmt: skip
        self.plot.show_curve(curve, lines, MOST_LINES)

    @property
    def _sheet(self) -> Sheet:
        """What is compared: the sheet as it is seen."""
        return self.session.frames.seen

    @property
    def _setup(self) -> TubeSetup:
        """As on the other pages, but for the rate and the speeds of the beam, which are this page's."""
        subject = self.session.state.subject
        return replace_setup(
            setup_of(self.session.state.tube),
            refresh_hz=number_of(subject, "refresh"),
            timing=timing_of(subject),
        )

    def _show_raster(self) -> None:
        """The picture, or of a frame that is stepped what the beam has scanned in the time of the other."""
        facts = self.facts
        if facts is None:
            return
        address, _done_s = self._position(facts)
        if self._may_take(self.raster, (facts, address, self._setup)):
            image, _strokes = self._drawn(facts)
            self.raster.set_image(image)
        self._drawing.start()

    def _show_vector(self) -> None:
        """The list, or of a frame that is stepped what the beam has drawn."""
        facts = self.facts
        if facts is None:
            return
        address, _done_s = self._position(facts)
        self.vector.set_trace(Trace.at(facts.program, address) if address >= 0 else None)
        if self._may_take(self.vector, (facts, address, self._setup)):
            _image, strokes = self._drawn(facts)
            self.vector.set_strokes(strokes.for_tube(), facts.size)
        self._resting.start()

    def _may_take(self, view: TubeView, fed: tuple[object, ...]) -> bool:
        """Set a tube that is seen as the page is; whether it has not been fed so yet."""
        if not view.sight.now:
            return False
        settings = self.session.state.tube
        view.set_setup(self._setup)
        view.set_slow_motion(settings.slow_motion)
        view.set_paused(settings.paused)
        new, self._fed[view] = self._fed.get(view) != fed, fed
        return new

    def _drawn(self, facts: Facts) -> tuple[Pixels, Strokes]:
        """What either beam has drawn by the step: rows of the picture, and strokes of the list."""
        address, done_s = self._position(facts)
        if address < 0:
            return self._image, facts.program.strokes
        image = self._image.copy()
        image[: len(image) - min(int(done_s / float(facts.raster.line_s)), len(image))] = 0
        return image, facts.program.strokes.cut(facts.program.drawn_by(address))

    def _position(self, facts: Facts) -> tuple[int, float]:
        """The address that was run last, and the seconds since the frame began; -1 where none was."""
        run = self.session.run
        if run.entry is None or run.entry.function is not text or not run.position or not run.step_number:
            return -1, 0.0
        address = min(run.step_number, len(facts.program)) - 1
        return address, int(facts.time.each_ps[: address + 1].sum()) * 1e-12

    def _show_lenses(self) -> None:
        """The part under the glass on both tubes."""
        facts = self.facts
        if facts is None or not self.glass.isChecked() or not self.raster.sight.now:
            for lens in self.lenses:
                lens.hide()
            return
        sheet, subject, setup = self._sheet, self.session.state.subject, self._setup
        place, power = lens_of(sheet, subject), number_of(subject, "power")
        image, strokes = self._drawn(facts)
        sizes = tuple(lens.size_px for lens in self.lenses)
        make = partial(_magnified, image, strokes, setup, facts.size, place, power, sizes)
        of = self._measured, self._position(facts), setup, place, power, sizes
        if (parts := self.session.ahead.of(sheet, "magnified", make, *of)) is not None:
            for lens, view, part in zip(self.lenses, (self.raster, self.vector), parts, strict=True):
                lens.show_part(part, view.position(*place))

    def _tell(self) -> None:
        """What has to be added to the chosen row, or what cannot be shown."""
        if self.facts is None:
            return
        rows, number = features(self.facts), self.table.currentRow()
        if 0 <= number < len(rows):
            self.note.setText(rows[number].but)
        elif self.facts.filled:
            said = _("A random-scan tube draws lines only, so what the raster fills is hatched there.")
            self.note.setText(
                said if self.facts.hatches else _("Areas are outlines on the random-scan tube.")
            )
        else:
            self.note.setText(
                _("Move over a tube, or use the arrows: the glass shows both in the same place.")
            )

    # The hand

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The pointer over either tube moves the glass on both, and so do the arrows."""
        if isinstance(watched, TubeView):
            if isinstance(event, QMouseEvent) and event.type() == QEvent.Type.MouseMove:
                cell = watched.pixel_under(event.position())
                if cell is not None:
                    self._move_glass(*cell)
            if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
                way = ARROWS.get(Qt.Key(event.key()))
                if way is not None and is_plain(event):
                    x, y = lens_of(self._sheet, self.session.state.subject)
                    far = 5 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1
                    self._move_glass(round(x) + far * way[0], round(y) + far * way[1])
                    return True
        return super().eventFilter(watched, event)

    def _move_glass(self, x: int, y: int) -> None:
        sheet = self._sheet
        x, y = min(max(x, 0), sheet.width_px - 1), min(max(y, 0), sheet.height_px - 1)
        self.bar.give(x=float(x), y=float(y))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where it is low the tubes need the height that the plot has."""
        super().resizeEvent(event)
        self.plot.setVisible(self.height() > _LOW_PX)

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh_soon()


def _magnified(
    image: Pixels,
    strokes: Strokes,
    setup: TubeSetup,
    size_px: tuple[int, int],
    place: tuple[float, float],
    power: float,
    sizes: tuple[int, ...],
) -> tuple[Pixels, Pixels]:
    """The part of both pictures that is under the glass, as each kind of tube shows it."""
    return (
        magnified_raster(image, setup, place, power, sizes[0]),
        magnified_vector(strokes.for_tube(), setup, size_px, place, power, sizes[1]),
    )
