"""Sheets with motion, made by hand and by hypothesis."""

from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document.model import Circle, Document, Sheet
from workbench.document.motion.model import EASINGS, Key, Motion, Track
from workbench.document.samples.figures import document_of, points_at, polygon

_PUNCTUATION = str.maketrans("", "", "/*._")
HOUSE = [(2.0, 1.0), (8.0, 1.0), (8.0, 6.0), (5.0, 9.0), (2.0, 6.0)]


def still() -> Document:
    """A circle f1 with its point p1, and a house f2 of five corners."""
    circle = Circle("", points_at((10, 10)), "midpoint_circle", 1, "Ball", radius_world=4.0)
    return document_of("Motion", 40, 30, [circle, polygon([HOUSE], 2, "House")])


def with_tracks(document: Document, *tracks: Track, frames: int = 49) -> Document:
    sheet = replace(document.sheets[0], motion=Motion(frames, 24.0, tracks))
    return replace(document, sheets=(sheet,))


def sheet_of(*tracks: Track) -> Sheet:
    return with_tracks(still(), *tracks).sheets[0]


def track(
    target: str, *keys: tuple[int, tuple[float, ...]], easing: str = "linear", **shape: float | str
) -> Track:
    """A track with keys (frame, value)."""
    made = (Key(f"k{target.translate(_PUNCTUATION)}-{f}-", f, value, easing, **shape) for f, value in keys)  # type: ignore[arg-type]
    return Track(f"a{target.translate(_PUNCTUATION)}-", target, tuple(made))


_halves = st.integers(-40, 40).map(lambda number: number / 2)


@st.composite
def keyed_numbers(draw: st.DrawFn) -> Track:
    """A track on the circle's radius or x with one to six keys, each with an easing of its own."""
    target = draw(st.sampled_from(["f1/radius_world", "f1/p1/x"]))
    frames = sorted(draw(st.sets(st.integers(0, 30), min_size=1, max_size=6)))
    shape = st.floats(0.0, 1.0)
    keys = tuple(
        Key(
            f"k{number}-",
            frame,
            (abs(draw(_halves)),),
            draw(st.sampled_from(EASINGS)),
            *(draw(shape) for _number in range(7)),
        )
        for number, frame in enumerate(frames)
    )
    return Track("a1-", target, keys)
