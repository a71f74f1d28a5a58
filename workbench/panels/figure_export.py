"""Getting the picture out: to the clipboard, as PNG, as PDF with vectors, as a table of pixels."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QMarginsF, QObject, QRectF, QSizeF, Qt, Signal
from PySide6.QtGui import QFont, QGuiApplication, QImage, QPageSize, QPainter, QPdfWriter
from PySide6.QtWidgets import QFileDialog, QWidget

from workbench.exchange.tables import Table, to_csv
from workbench.language import _
from workbench.panels.figure_picture import pixel_rows
from workbench.panels.figure_view import FigureView
from workbench.widgets.canvas_overlay import Overlay
from workbench.widgets.canvas_painter import Picture, Scene, paint_rulers, paint_scene, ruler_sizes
from workbench.widgets.canvas_view import Area, fitted
from workbench.widgets.tokens import LIGHT

PAGE_MM = (180.0, 140.0)
DOTS_PER_INCH = 1200
CAPTION_PX = 40
MOST_PAGES = 500


@dataclass(frozen=True, slots=True)
class Page:
    """One picture of a run: what it shows, and the sentence under it."""

    picture: Picture
    overlay: Overlay
    caption: str


def ask_and_write(owner: QWidget, title: str, name: str, kinds: str, write: Callable[[Path], None]) -> str:
    """Ask for a file, write it, and return the sentence that says so; empty when none was chosen.

    ``kinds`` are as in "PNG (*.png);;PDF (*.pdf)": a name without an ending gets that of the chosen kind.
    """
    chosen, kind = QFileDialog.getSaveFileName(owner, title, name, kinds)
    if not chosen:
        return ""
    path = Path(chosen)
    if not path.suffix:
        path = path.with_suffix("." + (kind or kinds).partition(" ")[0].lower())
    try:
        write(path)
    except OSError as problem:
        text = _("{path} was not written: {reason}. Choose another folder.")
        return text.format(path=path, reason=problem.strerror or problem)
    return _("{path} is written.").format(path=path)


def write_pdf(path: Path, title: str, pages: Iterator[Page], font: QFont) -> int:
    """Write one page per picture, with lines and cells as vectors; returns how many. Raises OSError."""
    path.write_bytes(b"")
    writer = QPdfWriter(str(path))
    writer.setResolution(DOTS_PER_INCH)
    writer.setPageSize(QPageSize(QSizeF(*PAGE_MM), QPageSize.Unit.Millimeter))
    writer.setPageMargins(QMarginsF(0, 0, 0, 0))
    writer.setTitle(title)
    painter = QPainter()
    if not painter.begin(writer):
        raise OSError(_("{path} cannot be written; choose another folder.").format(path=path))
    count = 0
    for page in pages:
        if count:
            writer.newPage()
        paint_page(painter, page, (writer.width(), writer.height()), font, DOTS_PER_INCH / 96)
        count += 1
    painter.end()
    return count


def paint_page(painter: QPainter, page: Page, size: tuple[int, int], font: QFont, unit: float) -> None:
    """Paint picture, rulers and caption on an area of ``size`` dots; ``unit`` dots are one logical pixel."""
    ruler_width, ruler_height = ruler_sizes(font, page.picture.size, unit)
    below = round(CAPTION_PX * unit)
    area = Area(ruler_width, 0, size[0], size[1] - ruler_height - below)
    view = fitted(area, *page.picture.size, round(8 * unit), largest=4096)
    scene = Scene(area, view, page.picture.size, LIGHT, unit, font, page.overlay, vector=True)
    paint_scene(painter, page.picture, scene)
    paint_rulers(painter, scene, None)
    caption = scene.caption()
    caption.setPixelSize(round(13 * unit))
    painter.setFont(caption)
    painter.setPen(Qt.GlobalColor.black)
    box = QRectF(ruler_width, size[1] - below, size[0] - ruler_width, below)
    painter.drawText(box, Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignVCenter, page.caption)


def page_image(page: Page, font: QFont, width: int = 1600) -> QImage:
    """The same page as an image."""
    height = round(width * PAGE_MM[1] / PAGE_MM[0])
    image = QImage(width, height, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.TextAntialiasing)
    paint_page(painter, page, (width, height), font, 2.0)
    painter.end()
    return image


class Exporter(QObject):
    """The commands that get a picture out. ``said`` sends one sentence about what became of it."""

    said = Signal(str)

    def __init__(self, view: FigureView, owner: QWidget) -> None:
        super().__init__(owner)
        self._view = view
        self._owner = owner

    def page(self, number: int | None = None) -> Page:
        """What the canvas shows now, or one step of the run."""
        made = self._view.on_paper(number)
        run = self._view.stepped_run()
        steps = None if run is None else run.steps
        at = run.step if run is not None and number is None else None
        step = steps[number] if steps is not None and number is not None else at
        caption = "" if step is None else "".join(part.text for part in step.sentence)
        return Page(Picture(made.pixels, made.background), made.overlay, caption)

    def copy_picture(self) -> None:
        """Put what the canvas shows on the clipboard."""
        QGuiApplication.clipboard().setImage(self._view.canvas.grab_picture())
        self.said.emit(_("The picture is on the clipboard."))

    def save_step(self) -> None:
        """Ask for a file and save what the canvas shows now."""
        self._ask(_("Save this step"), _("picture"), "PNG (*.png);;PDF (*.pdf)", self.write_step)

    def save_run(self) -> None:
        """Ask for a file and save every step: pages of a PDF, or numbered PNG files."""
        self._ask(_("Save this run"), _("run"), "PDF (*.pdf);;PNG (*.png)", self.write_run)

    def save_pixels(self) -> None:
        """Ask for a file and save the pixels of the active figure in the order of painting."""
        self._ask(_("Save pixels"), _("pixels"), "CSV (*.csv)", self.write_pixels)

    def save_table(self) -> None:
        """Ask for a file and save the hand table of the run."""
        self._ask(_("Save hand table"), _("table"), "CSV (*.csv)", self.write_table)

    def _ask(self, title: str, name: str, kinds: str, write: Callable[[Path], None]) -> None:
        said = ask_and_write(self._owner, title, name, kinds, write)
        if said:
            self.said.emit(said)

    def write_step(self, path: Path) -> None:
        """Write this step as PDF or PNG, by the file's ending. Raises OSError."""
        self._write(path, iter([self.page()]))

    def write_run(self, path: Path) -> None:
        """Write every recorded step, at most the first ``MOST_PAGES``. Raises OSError."""
        run = self._view.stepped_run()
        last = 0 if run is None or run.steps is None else len(run.steps)
        self._write(path, (self.page(k) for k in range(min(last, MOST_PAGES - 1) + 1)))

    def write_pixels(self, path: Path) -> None:
        """Write k, x, y of every pixel of the active figure. Raises OSError."""
        session = self._view.session
        figure = session.active_figure
        rows = [] if figure is None else pixel_rows(session.sheet, figure)
        path.write_text(to_csv(Table(("k", "x", "y"), rows)), encoding="utf-8", newline="")

    def write_table(self, path: Path) -> None:
        """Write the hand table, as far as it is recorded, with every digit. Raises OSError."""
        run = self._view.stepped_run()
        rows: list[tuple[object, ...]] = []
        columns: tuple[str, ...] = ()
        if run is not None and run.steps is not None and run.entry is not None:
            columns = run.entry.columns
            rows = [run.steps.row(number) for number in range(1, len(run.steps) + 1)]
        path.write_text(to_csv(Table(columns, rows)), encoding="utf-8", newline="")

    def _write(self, path: Path, pages: Iterator[Page]) -> None:
        font = self._owner.font()
        if path.suffix.lower() == ".pdf":
            write_pdf(path, self._view.session.sheet.name, pages, font)
            return
        made = list(pages)
        for number, page in enumerate(made):
            target = path if len(made) == 1 else path.with_stem(f"{path.stem}-{number:03d}")
            if not page_image(page, font).save(str(target)):
                raise OSError(_("the folder cannot be written"))
