"""A method at work: its picture, small, with the pixels that are wrong marked, and what it costs."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QFont,
    QFontMetrics,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import QToolButton, QWidget

from workbench.algorithms import catalogue
from workbench.language import _, ngettext
from workbench.rendering.scene.arena import TRUTH, MethodRun, space_of
from workbench.rendering.scene.counted import counted_forms, kept_texts
from workbench.rendering.scene.growth import Growth
from workbench.rendering.scene.spaces import NOT_YET, title_of
from workbench.widgets.canvas.overlay import Cell
from workbench.widgets.look.icons import icon, set_icon
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import CAPTION_PX, RADIUS, TEXT_PX, colour, theme_changed, tokens
from workbench.widgets.look.type_faces import scaled

HEAD_PX, LINE_PX, AIR_PX, LINES = 24, 15, 8, 3
LEAST_PX = QSize(150, 150)
_ICON_PX, _BUTTON_PX = 16, 18
_WHOLE = 0.85  # a pixel is made of whole ones of the screen where the picture does not become much smaller
_MANY = 10_000
Pixels = NDArray[np.uint32]
Forms = tuple[str, ...]
"""One text in fewer and fewer words."""


class TileState(NamedTuple):
    """What a tile shows: the picture (h, w), 0xRRGGBB, as it is and with the wrong pixels marked; the run and
    the times, as far as there are any."""

    picture: Pixels | None = None
    run: MethodRun | None = None
    growth: Growth | None = None


class MethodTile(QWidget):
    """``chosen``: it was clicked or came to by the keys; ``stepped``: it is to be stepped; ``pointed`` sends
    the pixel under the pointer, None when none is; ``asked`` the one that was clicked; ``moved`` sends by how
    many tiles the keys go on."""

    chosen = Signal(str)
    stepped = Signal(str)
    pointed = Signal(object)
    asked = Signal(object)
    moved = Signal(int, int)

    def __init__(self, method: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.method = method
        self.state = TileState()
        self.is_chosen = False
        self.ring: Cell | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(title_of(method))
        self.setToolTip(_(catalogue.get(method).summary))
        self.button = QToolButton(self)
        set_icon(self.button, "arrow-right", "accent")
        self.button.setAutoRaise(True)
        self.button.setToolTip(_("Step this method on the page Visibility, with the same scene (Enter)"))
        self.button.setAccessibleName(_("Step {title}").format(title=title_of(method)))
        self.button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.button.setCursor(Qt.CursorShape.PointingHandCursor)
        self.button.clicked.connect(lambda: self.stepped.emit(self.method))
        theme_changed.connect(self.update)

    def show_state(self, state: TileState) -> None:
        """Show a picture and what is known of it."""
        self.state = state
        self.setAccessibleDescription("; ".join(filter(None, self.values())) or _("not run yet"))
        self.update()

    def choose(self, on: bool) -> None:
        """Ring it as the one that is spoken of."""
        if on != self.is_chosen:
            self.is_chosen = on
            self.update()

    def point_at(self, cell: Cell | None) -> None:
        """Ring a pixel."""
        if cell != self.ring:
            self.ring = cell
            self.update()

    @property
    def wrong(self) -> int:
        """How many pixels differ from ray casting."""
        run = self.state.run
        return 0 if run is None else int(run.different.sum())

    def values(self) -> tuple[str, ...]:
        """What is known of the run: tests, time, divisions, what is kept, how many pixels differ."""
        return tuple(forms[0] for forms in self._told())

    def _told(self) -> tuple[Forms, ...]:
        run, growth = self.state.run, self.state.growth
        if run is None:
            return ()
        divided, kept = counted_forms(run), kept_texts(run)
        differing = (
            ngettext("{n:,} px differs", "{n:,} px differ", self.wrong),
            ngettext("{n:,} differs", "{n:,} differ", self.wrong),
        )
        return (
            forms_of_tests(run.tests),
            (NOT_YET,) if growth is None else forms_of_time(growth),
            divided[-1] if divided else ("",),
            (_("keeps {what}").format(what=kept[0] if kept else _("nothing")),),
            tuple(form.format(n=self.wrong) for form in differing),
        )

    # Painting

    @property
    def _room(self) -> QRectF:
        """Where the picture may be."""
        below = LINE_PX * LINES + AIR_PX + 2
        return QRectF(
            AIR_PX, HEAD_PX + LINE_PX, self.width() - 2 * AIR_PX, self.height() - HEAD_PX - LINE_PX - below
        )

    @property
    def _picture_area(self) -> QRectF:
        """Where it is."""
        room, picture = self._room, self.state.picture
        if picture is None:
            return room
        rows, columns = picture.shape
        ratio = self.devicePixelRatioF()
        scale = min(room.width() / columns, room.height() / rows) * ratio
        scale = (int(scale) if int(scale) > _WHOLE * scale else scale) / ratio
        width, height = columns * scale, rows * scale
        left = room.left() + round((room.width() - width) / 2 * ratio) / ratio
        return QRectF(left, room.top(), width, height)

    def cell_at(self, position: QPointF) -> Cell | None:
        """The pixel at a place of the tile."""
        picture, area = self.state.picture, self._picture_area
        if picture is None or not area.contains(position):
            return None
        rows, columns = picture.shape
        x = int((position.x() - area.left()) / area.width() * columns)
        y = rows - 1 - int((position.y() - area.top()) / area.height() * rows)
        return min(max(x, 0), columns - 1), min(max(y, 0), rows - 1)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The card, the picture, and the lines below it."""
        now, painter = tokens(), QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        edge = now.error if self.wrong else now.line
        painter.setPen(QPen(colour(edge), 2 if self.wrong else 1))
        painter.setBrush(colour(now.surface))
        inside = QRectF(self.rect()).adjusted(3.5, 3.5, -3.5, -3.5)
        painter.drawRoundedRect(inside, RADIUS, RADIUS)
        if self.is_chosen or self.hasFocus():
            style = Qt.PenStyle.SolidLine if self.is_chosen else Qt.PenStyle.DotLine
            painter.setPen(QPen(colour(now.accent), 2, style))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(1, 1, -1, -1), RADIUS + 2, RADIUS + 2)
        self._paint_head(painter)
        self._paint_picture(painter)
        self._paint_lines(painter)
        painter.end()

    def _paint_head(self, painter: QPainter) -> None:
        now, font = tokens(), QFont(self.font())
        left = AIR_PX
        if self.state.run is not None and self.method != TRUTH:
            name, role = ("warning", "error") if self.wrong else ("check", "text")
            icon(name, role).paint(painter, QRect(left, 6, _ICON_PX, _ICON_PX))
            left += _ICON_PX + 4
        font.setPixelSize(scaled(TEXT_PX))
        font.setWeight(QFont.Weight.DemiBold)
        painter.setFont(font)
        painter.setPen(colour(now.text))
        room = QRectF(left, 4, self.width() - left - AIR_PX, HEAD_PX - 4)
        title = title_of(self.method)
        if painter.fontMetrics().horizontalAdvance(title) > room.width():
            font.setPixelSize(scaled(CAPTION_PX))
            painter.setFont(font)
        title = painter.fontMetrics().elidedText(title, Qt.TextElideMode.ElideRight, int(room.width()))
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter, title)
        space = _(space_of(self.method))
        if self.method == TRUTH:
            space = _("{space} · the truth").format(space=space)
        painter.setFont(self._caption())
        painter.setPen(colour(now.muted))
        below = QRectF(AIR_PX, HEAD_PX, self.width() - 2 * AIR_PX, LINE_PX - 2)
        painter.drawText(below, Qt.AlignmentFlag.AlignVCenter, space)

    def _paint_picture(self, painter: QPainter) -> None:
        picture, now = self.state.picture, tokens()
        if picture is None:
            return
        rows, columns = picture.shape
        turned = np.ascontiguousarray(picture[::-1] | np.uint32(0xFF000000))
        image = QImage(turned.data, columns, rows, 4 * columns, QImage.Format.Format_RGB32)
        area = self._picture_area
        painter.drawImage(area, image)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(colour(now.line), 1))
        painter.drawRect(area)
        run = self.state.run
        if run is not None and self.wrong:
            ys, xs = np.nonzero(run.different)
            painter.setPen(QPen(colour(now.error), 2))
            whole = self._cells(int(xs.min()), int(ys.min()), int(xs.max()), int(ys.max()))
            painter.drawRoundedRect(whole.adjusted(-3, -3, 3, 3) & area.adjusted(-3, -3, 3, 3), 4, 4)
        if self.ring is not None:
            cell = self._cells(*self.ring, *self.ring)
            for width, ink in ((4, now.canvas), (2, now.text)):
                painter.setPen(QPen(colour(ink), width))
                painter.drawRect(cell.adjusted(-2, -2, 2, 2))

    def _cells(self, x_low: int, y_low: int, x_high: int, y_high: int) -> QRectF:
        assert self.state.picture is not None
        area, (rows, columns) = self._picture_area, self.state.picture.shape
        wide, high = area.width() / columns, area.height() / rows
        left, top = area.left() + x_low * wide, area.top() + (rows - 1 - y_high) * high
        return QRectF(left, top, (x_high - x_low + 1) * wide, (y_high - y_low + 1) * high)

    def _paint_lines(self, painter: QPainter) -> None:
        now, told = tokens(), self._told()
        font = self._caption()
        painter.setFont(font)
        painter.setPen(colour(now.text if told else now.muted))
        left, right = (
            Qt.AlignmentFlag.AlignVCenter | side
            for side in (Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignRight)
        )
        if not told:
            painter.drawText(self._line(0), left, _("not run yet"))
            return
        tests, time, divided, kept, differ = told
        above = together(tests, time, painter.fontMetrics(), self._line(0).width())
        for line, side, value in ((0, left, above[0]), (0, right, above[1]), (1, left, kept[0])):
            painter.drawText(self._line(line), side, value)
        font.setBold(bool(self.wrong))
        painter.setFont(font)
        painter.setPen(colour(now.error if self.wrong else now.text))
        below = together(differ, divided, painter.fontMetrics(), self._line(2).width())
        painter.drawText(self._line(2), left, below[0])
        painter.setFont(self._caption())
        painter.setPen(colour(now.text))
        painter.drawText(self._line(2), right, below[1])

    def _line(self, number: int) -> QRectF:
        top = self.height() - LINE_PX * LINES - AIR_PX + number * LINE_PX
        return QRectF(AIR_PX, top, self.width() - 2 * AIR_PX, LINE_PX)

    def _caption(self) -> QFont:
        font = QFont(self.font())
        font.setPixelSize(scaled(CAPTION_PX))
        return font

    # The hand

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The button stays beside the line that is short."""
        super().resizeEvent(event)
        middle = self._line(1).center().y()
        left = self.width() - _BUTTON_PX - AIR_PX + 2
        self.button.setGeometry(left, round(middle) - _BUTTON_PX // 2, _BUTTON_PX, _BUTTON_PX)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """It is chosen, and asked about the pixel."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.chosen.emit(self.method)
            if (cell := self.cell_at(event.position())) is not None:
                self.asked.emit(cell)

    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        """It is stepped."""
        self.stepped.emit(self.method)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The same pixel is ringed in all tiles."""
        self.pointed.emit(self.cell_at(event.position()))

    def leaveEvent(self, event: object) -> None:
        """None is ringed."""
        super().leaveEvent(event)  # type: ignore[arg-type]
        self.pointed.emit(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows go from tile to tile, Enter steps."""
        ways = {
            Qt.Key.Key_Left: (-1, 0),
            Qt.Key.Key_Right: (1, 0),
            Qt.Key.Key_Up: (0, -1),
            Qt.Key.Key_Down: (0, 1),
        }
        if not is_plain(event):
            super().keyPressEvent(event)
        elif event.key() in ways:
            self.moved.emit(*ways[Qt.Key(event.key())])
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.stepped.emit(self.method)
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The ring appears."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The ring goes."""
        super().focusOutEvent(event)
        self.update()


def together(left: Forms, right: Forms, metrics: QFontMetrics, room_px: float) -> tuple[str, str]:
    """What is said at the left and the right of one line: the right text becomes shorter first, then the left
    one; where even that has no room, the right text is left out, for a number without a noun says nothing.
    """
    pairs = [(left[0], short) for short in right]
    pairs += [(short, right[-1]) for short in left[1:]]
    pairs += [(short, "") for short in left]
    fitting = (pair for pair in pairs if metrics.horizontalAdvance("".join(pair)) + AIR_PX / 2 <= room_px)
    return next(fitting, pairs[-1])


def forms_of_tests(n: int) -> Forms:
    """How many tests there were, to the last one and in round numbers."""
    whole = ngettext("{n:,} test", "{n:,} tests", n).format(n=n)
    if n < _MANY:
        return (whole,)
    number = f"{n / 1e6:,.1f} M" if n >= 1e6 else f"{n / 1e3:,.0f} k"
    return whole, _("{number} tests").format(number=number)


def forms_of_time(growth: Growth) -> Forms:
    """How long it takes at ten times the size; where that is foretold it is said to be about so long."""
    text = seconds_text(growth.at_ten, growth.measured)
    return (text,) if growth.measured else (text, f"\N{ALMOST EQUAL TO} {seconds_text(growth.at_ten)}")


def seconds_text(seconds: float, measured: bool = True) -> str:
    """A time to three digits; one that is foretold is said to be about so long."""
    text = f"{seconds * 1e3:.3g} ms" if seconds < 1 else f"{seconds:.3g} s"
    return text if measured else _("about {time}").format(time=text)
