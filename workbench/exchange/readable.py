"""The table of everything that can be read: kind, as ``reading.Job`` names it, suffixes, title."""

from pathlib import Path
from typing import Literal, NamedTuple

from workbench.language import _


class Readable(NamedTuple):
    """One kind of file that can be read, under any of its suffixes."""

    kind: Literal["picture", "drawing", "points", "mesh"]
    suffixes: tuple[str, ...]

    @property
    def title(self) -> str:
        """What such files are called in a list."""
        return {
            "picture": _("Pictures of the workbench"),
            "drawing": _("Drawings"),
            "points": _("Lists of points"),
            "mesh": _("Meshes"),
        }[self.kind]


READABLE = (
    Readable("picture", (".gwb",)),
    Readable("drawing", (".svg",)),
    Readable("points", (".csv", ".tsv", ".txt")),
    Readable("mesh", (".obj", ".off", ".ply", ".stl", ".glb")),
)
SUFFIXES = tuple(suffix for each in READABLE for suffix in each.suffixes)


def kind_of(path: Path) -> str:
    """The kind that the suffix of a name says; empty when nothing of that name can be read."""
    return next((each.kind for each in READABLE if path.suffix.lower() in each.suffixes), "")
