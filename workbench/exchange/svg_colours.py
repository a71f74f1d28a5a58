"""Colours of SVG, and those of a sheet's palette."""

import svgelements

from workbench.document.model import Sheet


def colour_of(text: str) -> int | None:
    """A colour as 0xRRGGBB; None where nothing is painted. What cannot be understood is black."""
    word = text.strip()
    if word in ("none", "transparent"):
        return None
    try:
        found = svgelements.Color(word).rgb
    except (ValueError, TypeError, AttributeError, IndexError):
        return 0
    return 0 if found is None else int(found) & 0xFFFFFF


def nearest_colour(colour: int, sheet: Sheet) -> int:
    """The palette index nearest to 0xRRGGBB; the background's only where no other has that very colour."""

    def distance(index: int) -> tuple[int, bool]:
        own = sheet.palette[index]
        apart = sum(((own >> shift & 255) - (colour >> shift & 255)) ** 2 for shift in (0, 8, 16))
        return apart + (index == sheet.background and apart > 0) * 10**6, index == sheet.background

    return min(range(len(sheet.palette)), key=distance)


def written(colour: int) -> str:
    """0xRRGGBB as SVG writes it."""
    return f"#{colour:06x}"
