"""How the cells of a picture lie on the screen: zoom and pan, in whole screen pixels."""

import math
from dataclasses import dataclass, replace

MAGNIFIED = (1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 160)
REDUCED = (2, 3, 4, 6, 8, 12, 16, 24, 32)
LEVELS = (*(1 / n for n in reversed(REDUCED)), *(float(n) for n in MAGNIFIED))


@dataclass(frozen=True, slots=True)
class Area:
    """A part of the screen in screen pixels, y downwards; right and bottom are one past the last."""

    left: int
    top: int
    right: int
    bottom: int

    @property
    def width(self) -> int:
        """In screen pixels, at least 1."""
        return max(1, self.right - self.left)

    @property
    def height(self) -> int:
        """In screen pixels, at least 1."""
        return max(1, self.bottom - self.top)

    @property
    def centre(self) -> tuple[float, float]:
        """Its middle, in screen pixels."""
        return (self.left + self.right) / 2, (self.top + self.bottom) / 2


@dataclass(frozen=True, slots=True)
class CanvasView:
    """``cell`` screen pixels for one cell: a whole number, or 1/n of one when the picture is reduced.

    ``left`` and ``bottom`` are the screen pixels of the picture's left and lower edge, which are the device
    coordinates -0.5.
    """

    cell: float = 1.0
    left: int = 0
    bottom: int = 0

    def to_screen(self, x: float, y: float) -> tuple[float, float]:
        """Screen position of a device point."""
        return self.left + (x + 0.5) * self.cell, self.bottom - (y + 0.5) * self.cell

    def to_device(self, screen_x: float, screen_y: float) -> tuple[float, float]:
        """Device point under a screen position."""
        return (screen_x - self.left) / self.cell - 0.5, (self.bottom - screen_y) / self.cell - 0.5

    def cell_box(self, x: int, y: int) -> tuple[int, int, int]:
        """Left, top and side of a cell in whole screen pixels (side at least 1)."""
        return (
            math.floor(self.left + x * self.cell),
            math.floor(self.bottom - (y + 1) * self.cell),
            max(1, math.floor(self.cell)),
        )

    def visible(self, area: Area, width: int, height: int) -> tuple[int, int, int, int] | None:
        """First and last column and row of a width x height picture seen in ``area``; None if none."""
        x0, y1 = self.to_device(area.left, area.top)
        x1, y0 = self.to_device(area.right, area.bottom)
        columns = max(0, math.floor(x0 + 0.5)), min(width - 1, math.ceil(x1 - 0.5))
        rows = max(0, math.floor(y0 + 0.5)), min(height - 1, math.ceil(y1 - 0.5))
        if columns[0] > columns[1] or rows[0] > rows[1]:
            return None
        return columns[0], columns[1], rows[0], rows[1]

    def at_scale(self, cell: float, screen_x: float, screen_y: float) -> "CanvasView":
        """Another zoom; the device point under the screen position stays there, to a screen pixel."""
        x, y = self.to_device(screen_x, screen_y)
        return CanvasView(cell, round(screen_x - (x + 0.5) * cell), round(screen_y + (y + 0.5) * cell))

    def zoomed(self, steps: int, screen_x: float, screen_y: float, least: float = 0.0) -> "CanvasView":
        """``steps`` levels nearer (negative: farther, down to ``least``), about a screen position."""
        nearest = min(range(len(LEVELS)), key=lambda i: abs(math.log(LEVELS[i] / self.cell)))
        level = LEVELS[min(len(LEVELS) - 1, max(0, nearest + steps))]
        if steps < 0:
            level = min(self.cell, next((each for each in LEVELS if each >= max(level, least)), self.cell))
        return self if level == self.cell else self.at_scale(level, screen_x, screen_y)

    def pinched(self, factor: float, screen_x: float, screen_y: float, least: float = 0.0) -> "CanvasView":
        """Nearer or farther by about ``factor``, down to ``least``, in whole cells, about a screen place."""
        wanted = min(LEVELS[-1], max(LEVELS[0], min(least, self.cell), self.cell * factor))
        cell = float(round(wanted)) if wanted >= 1 else 1 / round(1 / wanted)
        if cell == self.cell and factor != 1:
            cell = min(LEVELS[-1], cell + 1) if factor > 1 and cell >= 1 else cell
            cell = cell - 1 if factor < 1 and cell > 1 else cell
        return self.at_scale(cell, screen_x, screen_y)

    def moved(self, right: int, down: int) -> "CanvasView":
        """Panned by whole screen pixels."""
        return replace(self, left=self.left + right, bottom=self.bottom + down)

    def kept_near(self, area: Area, width: int, height: int, margin: int) -> "CanvasView":
        """Panned back so far that at least ``margin`` screen pixels of the picture stay in ``area``."""
        left = max(area.left + margin - round(width * self.cell), min(area.right - margin, self.left))
        bottom = max(area.top + margin, min(area.bottom - margin + round(height * self.cell), self.bottom))
        return replace(self, left=left, bottom=bottom)


def fitted(
    area: Area, width: float, height: float, margin: int, largest: int = MAGNIFIED[-1], in_cells: bool = True
) -> CanvasView:
    """The whole picture in the middle of ``area``, as large as whole cells or, else, the room allow."""
    room = min((area.width - 2 * margin) / width, (area.height - 2 * margin) / height)
    if not in_cells:
        return centred(area, width, height, min(float(largest), max(room, LEVELS[0])))
    cell = float(min(largest, math.floor(room))) if room >= 1 else 1 / math.ceil(1 / max(room, 1 / 64))
    return centred(area, width, height, cell)


def centred(area: Area, width: float, height: float, cell: float) -> CanvasView:
    """The middle of the picture in the middle of ``area``, at the given zoom."""
    middle_x, middle_y = area.centre
    return CanvasView(cell, round(middle_x - width * cell / 2), round(middle_y + height * cell / 2))


def label_step(cell: float, room: float) -> int:
    """Cells between axis numbers: 1, 2 or 5 times a power of ten, ``room`` screen pixels or more apart."""
    power = 1
    while True:
        for factor in (1, 2, 5):
            if factor * power * cell >= room:
                return factor * power
        power *= 10
