"""What ray casting shows of its blocks."""

from workbench.algorithms.entry import View
from workbench.algorithms.visibility.surface_words import listed
from workbench.algorithms.visibility.surfaces import Surface, covers, depth_at

COLUMNS = ("x", "y", "tried", "met", "nearest z", "seen")
_OFFERED = 6


def met(surfaces: list[Surface], numbers: list[int], x: int, y: int) -> list[tuple[int, float]]:
    """The surfaces that the ray meets, and where, from the nearest on."""
    hits = [(depth_at(surfaces[n], x, y), n) for n in numbers if covers(surfaces[n], x, y)]
    return [(n, z) for z, n in sorted(hits)]


def offered(numbers: list[int]) -> tuple[str | int, ...]:
    """The surfaces to choose from, and none; nothing where they are too many."""
    return (*numbers, "none") if len(numbers) <= _OFFERED else ()


VIEW_FUNCTIONS = (listed, met, offered)

_GIVE = "Give the pixel the colour of the nearest"
_TABLES = {"Surfaces that the ray meets": ("met(surfaces, numbers, x, y)", ("surface", "z"))}

VIEWS = (
    View(
        block="Find where the ray meets the surface",
        when="hit",
        sentence="The ray meets surface {number} at z = {z}.",
    ),
    View(
        block="Find where the ray meets the surface",
        sentence="The ray misses surface {number}.",
    ),
    View(
        block=_GIVE,
        when="seen == -1",
        candidates="((x, y),)",
        rejected="((x, y),)",
        row="(x, y, len(numbers), '–', '–', 'none')",
        considers="(x, y)",
        tables=_TABLES,
        options="offered(numbers)",
        answer="'none'",
        sentence="The ray through {(x, y)} meets none of {len(numbers)} surfaces.",
    ),
    View(
        block=_GIVE,
        candidates="((x, y),)",
        chosen="((x, y),)",
        row="(x, y, len(numbers), listed([n for n, _z in met(surfaces, numbers, x, y)]), nearest, seen)",
        considers="(x, y)",
        tables=_TABLES,
        options="offered(numbers)",
        answer="seen",
        sentence="The ray through {(x, y)} meets surface {seen} first, at z = {nearest}.",
    ),
)
