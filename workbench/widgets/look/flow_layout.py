"""Widgets in a row that goes on in further rows where it has no room: none of them is ever cut."""

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QSize, Qt
from PySide6.QtWidgets import QFrame, QLayout, QLayoutItem, QScrollArea, QSizePolicy, QWidget

_SPARE_PX = 12  # less than half a row is not worth a scroll bar


class FlowLayout(QLayout):
    """Each item is as wide as it wishes. In each row what can grow shares what is left."""

    def __init__(self, parent: QWidget | None = None, across: int = 16, down: int = 6) -> None:
        super().__init__(parent)
        self._items: list[QLayoutItem] = []
        self._across, self._down = across, down
        self.setContentsMargins(0, 0, 0, 0)

    def addItem(self, item: QLayoutItem) -> None:
        """At the end."""
        self._items.append(item)

    def count(self) -> int:
        """How many there are."""
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        """The item of this number; None where there is none."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        """Take an item out."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self) -> Qt.Orientation:
        """It takes no more than it needs."""
        return Qt.Orientation(0)

    def hasHeightForWidth(self) -> bool:
        """In less width it has more rows."""
        return True

    def heightForWidth(self, width: int) -> int:
        """All rows at this width."""
        return self._arrange(QRect(0, 0, width, 0), False)

    def setGeometry(self, rect: QRect) -> None:
        """Place the items."""
        super().setGeometry(rect)
        self._arrange(rect, True)

    def sizeHint(self) -> QSize:
        """All in one row."""
        sizes = [item.sizeHint() for item in self._seen()]
        width = sum(size.width() for size in sizes) + self._across * max(len(sizes) - 1, 0)
        return QSize(width, max((size.height() for size in sizes), default=0))

    def minimumSize(self) -> QSize:
        """As wide as the widest item."""
        sizes = [item.minimumSize() for item in self._seen()]
        return QSize(
            max((size.width() for size in sizes), default=0),
            max((size.height() for size in sizes), default=0),
        )

    def _seen(self) -> list[QLayoutItem]:
        return [item for item in self._items if not item.isEmpty()]

    def _rows(self, width: int) -> list[list[QLayoutItem]]:
        rows: list[list[QLayoutItem]] = []
        left = 0
        for item in self._seen():
            wish = item.sizeHint().width()
            if rows and left >= wish + self._across:
                rows[-1].append(item)
                left -= wish + self._across
            else:
                rows.append([item])
                left = width - wish
        return rows

    def _arrange(self, rect: QRect, placing: bool) -> int:
        """Place the rows, or only find out how high they are together."""
        y = rect.y()
        for row in self._rows(rect.width()):
            height = max(item.sizeHint().height() for item in row)
            if placing:
                self._place(row, QRect(rect.x(), y, rect.width(), height))
            y += height + self._down
        return max(y - rect.y() - self._down, 0)

    def whole_rows(self, width: int, most: int) -> int:
        """The height of those rows at this width that end within ``most``, of the first in any case."""
        bottom, height = -self._down, 0
        for row in self._rows(width):
            bottom += self._down + max(item.sizeHint().height() for item in row)
            if height and bottom > most:
                break
            height = bottom
        return height

    def _place(self, row: list[QLayoutItem], rect: QRect) -> None:
        wishes = [item.sizeHint().width() for item in row]
        left = rect.width() - sum(wishes) - self._across * (len(row) - 1)
        growing = [k for k, item in enumerate(row) if item.expandingDirections() & Qt.Orientation.Horizontal]
        for k in growing:
            wishes[k] += max(left, 0) // len(growing)
        x = rect.x()
        for item, wish in zip(row, wishes, strict=True):
            width = min(wish, rect.width())
            item.setGeometry(QRect(QPoint(x, rect.y()), QSize(width, rect.height())))
            x += width + self._across


def flowing(widget: QWidget, across: int = 16, down: int = 6) -> FlowLayout:
    """Let a widget lay its parts out so; it is as high as their rows and never holds its window wide."""
    layout = FlowLayout(widget, across, down)
    policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
    policy.setHeightForWidth(True)
    widget.setSizePolicy(policy)
    return layout


class FlowArea(QScrollArea):
    """A strip that flows, as high as its rows; on a low page it takes a part of the height, and scrolls."""

    def __init__(self, strip: QWidget, most: float = 0.34) -> None:
        super().__init__()
        self._strip, self._most = strip, most
        self._room: tuple[int, int] | None = None
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(strip)
        self.viewport().setAutoFillBackground(False)
        strip.setAutoFillBackground(False)

    def fit(self, width: int, page_height: int) -> None:
        """Take the height that the strip needs in so much width, on a page so high; from then on also when
        its parts become others.
        """
        self._room = width, page_height
        needed, most = self._strip.heightForWidth(width), int(self._most * page_height)
        scrolls = needed > most + _SPARE_PX
        policy = Qt.ScrollBarPolicy
        # Asked for its height beside the bar, a strip that had one would keep it
        self.setVerticalScrollBarPolicy(policy.ScrollBarAsNeeded if scrolls else policy.ScrollBarAlwaysOff)
        if scrolls:
            beside = self.verticalScrollBar().sizeHint().width()
            flow = self._strip.layout()
            assert isinstance(flow, FlowLayout)
            needed = flow.whole_rows(width - beside, most)
        self.setFixedHeight(max(needed, self._strip.minimumSizeHint().height()))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A part that has grown may begin another row."""
        answer = super().eventFilter(watched, event)
        if event.type() == QEvent.Type.LayoutRequest and watched is self._strip and self._room is not None:
            self.fit(*self._room)
        return answer
