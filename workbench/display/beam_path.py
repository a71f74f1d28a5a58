"""The way of a raster beam over the tube, as it is drawn in a book: lines, and the retraces between them."""

from typing import Literal, NamedTuple

from workbench.display.timings import RasterTiming

Kind = Literal["line", "horizontal", "vertical"]
Point = tuple[float, float]


class Stretch(NamedTuple):
    """A straight part of the way, in pixels from the picture's upper left corner; fields count from 0."""

    kind: Kind
    field: int
    begin: Point
    end: Point


def beam_path(timing: RasterTiming, most_lines: int = 48) -> list[Stretch]:
    """The way in a frame; of more than ``most_lines`` of a field every second, third, ... is drawn."""
    width, height = float(timing.h_active), float(timing.v_active)
    path: list[Stretch] = []
    for field in range(timing.fields):
        rows = range(field, timing.v_active, timing.fields)
        drawn = [row + 0.5 for row in rows[:: max(1, -(-len(rows) // most_lines))]]
        for row, following in zip(drawn, [*drawn[1:], None], strict=True):
            path.append(Stretch("line", field, (0.0, row), (width, row)))
            if following is not None:
                path.append(Stretch("horizontal", field, (width, row), (0.0, following)))
        path += _back_to_the_top(timing, field, width, height)
    return path


def _back_to_the_top(timing: RasterTiming, field: int, width: float, height: float) -> list[Stretch]:
    """The line oscillator runs on while the beam rises, so that it goes up in a zig-zag."""
    turns = max(2 * timing.v_sync // timing.fields, 1)
    ways = []
    for turn in range(turns):
        ends = [(width if (turn + k) % 2 == 0 else 0.0, height * (1.0 - (turn + k) / turns)) for k in (0, 1)]
        ways.append(Stretch("vertical", field, ends[0], ends[1]))
    return ways


class Segment(NamedTuple):
    """A part of a line (in clocks) or of a frame (in lines), of one of ``KINDS``."""

    kind: str
    start: float
    length: float


KINDS = ("active", "front_porch", "sync", "back_porch")


def line_segments(timing: RasterTiming) -> list[Segment]:
    """The parts of a line, in pixel clocks, in their order."""
    return _in_a_row([(kind, float(getattr(timing, f"h_{kind}"))) for kind in KINDS])


def frame_segments(timing: RasterTiming) -> list[Segment]:
    """The parts of a frame, in lines, in their order; interlaced, those of one field and then of the other.

    A field begins with its first line that is seen.
    """
    parts: list[tuple[str, float]] = []
    for field in range(timing.fields):
        seen = len(range(field, timing.v_active, timing.fields))
        whole = -(-timing.v_total // timing.fields) if field == 0 else timing.v_total // timing.fields
        sync, front = (each / timing.fields for each in (timing.v_sync, timing.v_front_porch))
        back = whole - seen - sync - front
        parts += zip(KINDS, (float(seen), front, sync, back), strict=True)
    return _in_a_row(parts)


def _in_a_row(parts: list[tuple[str, float]]) -> list[Segment]:
    segments, start = [], 0.0
    for kind, length in parts:
        segments.append(Segment(kind, start, length))
        start += length
    return segments
