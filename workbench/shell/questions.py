"""The twelve questions that a first course asks, in our own words, and where each can be worked on."""

from typing import NamedTuple

from workbench.language import _


class Question(NamedTuple):
    """One question: ``workspace`` and ``example`` say where it is worked on, ``step`` and ``frame`` what is
    seen there; ``dock`` names the dock that comes forward there, ``page`` the page where it is not that of
    the example."""

    number: int
    text: str
    topic: str
    workspace: str
    example: str
    step: int = 0
    dock: str = ""
    frame: int = 0
    page: str = ""


def questions() -> tuple[Question, ...]:
    """All twelve, in the order of the paper."""
    return (
        Question(
            1,
            _("How does a scene in space become flat, and why is it divided by depth?"),
            _("Projection"),
            "space",
            "space-house",
            3,
            "derivation",
        ),
        Question(
            2,
            _("How does a depth buffer decide what is seen, and what does it cost?"),
            _("Surfaces"),
            "space",
            "overlapping-triangles",
            684,
            "source",
        ),
        Question(
            3,
            _("How is a polygon filled row by row, and how does a fill grow from a seed?"),
            _("Filling"),
            "fill",
            "triangle",
            4,
        ),
        Question(
            4,
            _("How does a window onto the world land in a viewport on the screen?"),
            _("Viewing"),
            "view",
            "view-house",
            12,
        ),
        Question(
            5,
            _("What does perspective give up that parallel projection keeps?"),
            _("Projection"),
            "space",
            "space-street",
            dock="contrast",
        ),
        Question(
            6,
            _("How does a cathode-ray tube turn a beam of electrons into light?"),
            _("Display"),
            "display",
            "house",
            dock="gun_part",
            page="gun",
        ),
        Question(
            7,
            _("Deciding what is hidden: surface against surface, or pixel by pixel?"),
            _("Surfaces"),
            "space",
            "arena-ring",
            6,
            "question_7",
        ),
        Question(
            8,
            _("Through its points or only near them: which spline does which?"),
            _("Curves"),
            "curves",
            "curve-interpolation",
        ),
        Question(
            9,
            _("How do a few key frames become a smooth motion?"),
            _("Animation"),
            "animate",
            "animate-ball",
            7,
            frame=34,
        ),
        Question(
            10,
            _("Row by row or stroke by stroke: how do raster and random scan draw?"),
            _("Display"),
            "display",
            "raster-or-random",
        ),
        Question(
            11,
            _("How does a DDA walk along a line, and where does its rounding show?"),
            _("Lines"),
            "draw",
            "slopes",
            1,
        ),
        Question(
            12,
            _("How is a picture turned about a point that is not the origin?"),
            _("Transformation"),
            "transform",
            "transform-pivot",
            15,
        ),
    )


def algorithms_for(number: int) -> list[str]:
    """What the algorithms are called that say that they serve this question, in teaching order."""
    from workbench.algorithms import catalogue

    return [_(entry.title) for entry in catalogue.serving(number)]
