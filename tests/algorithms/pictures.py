"""Small pictures as text, top row first."""

from collections.abc import Iterable


def drawn(pixels: Iterable[tuple[int, ...]], width: int, height: int) -> list[str]:
    """The pixels as rows of text: # where one is, . elsewhere; a pixel that comes twice shows as 2."""
    rows = [["."] * width for _ in range(height)]
    for x, y, *_ in pixels:
        rows[y][x] = "#" if rows[y][x] == "." else "2"
    return ["".join(row) for row in reversed(rows)]
