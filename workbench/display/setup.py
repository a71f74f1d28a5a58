"""From a picture or a display list to a tube with its beam, as a person has set it up."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.clipping.liang_barsky import liang_barsky
from workbench.display.monitor import BLANKING, IN_THE_MIDDLE, Knobs, level_current
from workbench.display.phosphor import Phosphor, names
from workbench.display.raster_beam import RasterBeam
from workbench.display.retrace import RetracingBeam
from workbench.display.stroke_timeline import StrokeTable
from workbench.display.timings import RasterTiming
from workbench.display.tube import Tube
from workbench.display.vector_beam import VectorBeam
from workbench.display.vector_timing import VectorTiming
from workbench.language import _

FACE_WIDTH_MM = 240.0
MOST_PX = 2048, 1536
"""As many as the finest tubes that were sold; more take a picture too long to be scanned."""

PICTURE_SHARE = 0.9
"""The picture takes this much of the face each way; the rest is the dark rim of an underscanned tube."""

COLOUR_TUBE = "P22"
_SPOT_OF_LINE_PITCH = 0.36
VECTOR_SPOT_MM = 0.5
_LEAST_SPOT_PX = 0.7
WHITE = 1.5
"""Luminance of a white field: lines one pixel wide, which the spot spreads, then come out near 1."""

_LINE_PEAK = 1.6
_FULL_RATE_HZ = 60.0

DeviceStroke = tuple[float, float, float, float, int]
"""x0, y0, x1, y1 in device pixels and the colour 0xRRGGBB."""

DeviceStrokes = Sequence[DeviceStroke] | NDArray[np.float64]
"""Any number of them; (n, 5) as an array."""


@dataclass(frozen=True, slots=True)
class TubeSetup:
    """What can be chosen: phosphor (or the colour tube), refresh rate, persistence factor, vector display.

    ``timing`` are the speeds of a display of one's own, which go before those of ``vector_display``.
    ``gamma`` is the exponent of the gun: its current is the drive, 0 to 1, to this power. ``knobs`` are those
    of a monitor.
    """

    phosphor: str = "P31"
    refresh_hz: float = 60.0
    persistence: float = 1.0
    vector_display: str = "teaching"
    gamma: float = 2.2
    knobs: Knobs = IN_THE_MIDDLE
    timing: VectorTiming | None = None

    @property
    def speeds(self) -> VectorTiming:
        """Those of the vector display. Raises LookupError where it is not known."""
        return self.timing or VectorTiming.named(self.vector_display)

    def guns(self) -> tuple[Phosphor, ...]:
        """One gun, or red, green and blue of a colour tube. Raises LookupError for an unknown phosphor."""
        wanted = ("P22R", "P22G", "P22B") if self.phosphor == COLOUR_TUBE else (self.phosphor,)
        return tuple(Phosphor.named(name).stretched(self.persistence) for name in wanted)

    def check(self) -> None:
        """Raises LookupError when the phosphor or the vector display is not known."""
        self.guns()
        self.speeds  # noqa: B018 - looked up, or refused

    def current(self, level: int) -> float:
        """The beam current of a channel, 0 to 255, by the law of the gun: 1 for white at the usual knobs."""
        return level_current(level / 255.0, self.knobs, self.gamma)

    @property
    def blanked_current(self) -> float:
        """What the beam still has while it is blanked: nothing, unless brightness is turned up."""
        return level_current(BLANKING, self.knobs, self.gamma)

    @property
    def refresh(self) -> Fraction:
        """The refresh rate as the decimal number that was typed."""
        return Fraction(str(self.refresh_hz))


def too_many_pixels(picture_px: tuple[int, int]) -> str:
    """Why a tube does not scan a picture of so many pixels, "" when it does."""
    width, height = picture_px
    if width * height <= MOST_PX[0] * MOST_PX[1]:
        return ""
    return _(
        "A picture of {width} \u00d7 {height} pixels is more than a tube can show, and slow to change; "
        "choose a size such as {most_width} \u00d7 {most_height}."
    ).format(width=width, height=height, most_width=MOST_PX[0], most_height=MOST_PX[1])


def phosphor_choices() -> tuple[str, ...]:
    """What ``TubeSetup.phosphor`` may be; the three phosphors of a colour tube count as one."""
    single = tuple(name for name in names() if not name.startswith(COLOUR_TUBE))
    return (*single, COLOUR_TUBE)


def face_mm(picture_px: tuple[int, int]) -> tuple[float, float]:
    """Size of the face for a picture of so many pixels: as wide as high as the picture, within reason."""
    aspect = min(max(picture_px[1] / picture_px[0], 0.6), 1.1)
    return FACE_WIDTH_MM, FACE_WIDTH_MM * aspect


def area_mm(picture_px: tuple[int, int]) -> tuple[float, float, float, float]:
    """Where on the face the picture lies: left, bottom, right, top; its pixels are square."""
    width, height = face_mm(picture_px)
    pitch = PICTURE_SHARE * min(width / picture_px[0], height / picture_px[1])
    half_x, half_y = 0.5 * pitch * picture_px[0], 0.5 * pitch * picture_px[1]
    return width / 2 - half_x, height / 2 - half_y, width / 2 + half_x, height / 2 + half_y


def mm_of(x: float, y: float, picture_px: tuple[int, int]) -> tuple[float, float]:
    """Where on the face a place of the picture lies, from pixels to millimetres."""
    left, bottom, right, _top = area_mm(picture_px)
    pitch = (right - left) / picture_px[0]
    return left + (x + 0.5) * pitch, bottom + (y + 0.5) * pitch


def units_per_px(picture_px: tuple[int, int], timing: VectorTiming) -> float:
    """Units of a vector display's deflection, which has ``timing.grid`` across the face, per pixel."""
    left, _bottom, right, _top = area_mm(picture_px)
    return (right - left) / picture_px[0] * timing.grid / face_mm(picture_px)[0]


def currents_of_image(image: NDArray[np.uint32], guns: int, setup: TubeSetup) -> NDArray[np.float64]:
    """Beam currents (guns, rows, columns), 0 to 1, of a picture 0xRRGGBB, whose channels drive the grid.

    A single gun follows the strongest channel, so that every colour stays readable on one phosphor.
    """
    levels = np.array([setup.current(v) for v in range(256)])
    red, green, blue = (((image >> shift) & 0xFF).astype(np.uint8) for shift in (16, 8, 0))
    if guns == 3:
        return np.stack([levels[channel] for channel in (red, green, blue)])
    # The law of the gun grows with the level, so the strongest channel alone is looked up
    strongest: NDArray[np.float64] = levels[np.maximum(np.maximum(red, green), blue)]
    return strongest[None]


def currents_of_colour(colour: int, guns: int, setup: TubeSetup) -> tuple[float, ...]:
    """Beam currents of one colour 0xRRGGBB."""
    currents = tuple(setup.current((colour >> shift) & 0xFF) for shift in (16, 8, 0))
    return currents if guns == 3 else (max(currents),)


def raster_tube(
    image: NDArray[np.uint32],
    size_px: tuple[int, int],
    setup: TubeSetup,
    precision: Any = np.float32,
    timing: RasterTiming | None = None,
    picture_px: tuple[int, int] | None = None,
    *,
    window_mm: tuple[float, float, float, float] | None = None,
    gun: int | None = None,
    shift_mm: tuple[float, float] = (0.0, 0.0),
) -> tuple[Tube, RasterBeam]:
    """A tube with ``size_px`` pixels that scans ``image`` (h, w); a white field is a little above 1.

    Without a ``timing`` it is blanked as VGA and refreshed as set up. ``picture_px`` is the picture that
    gives the face its shape, where the image has more or fewer pixels than that.
    ``window_mm`` (left, bottom, right, top) is the part of the face that is looked at, by default all of it.
    With ``gun`` that gun of a colour tube is there alone; its picture lies ``shift_mm`` beside its place.
    """
    height, width = image.shape
    picture = picture_px or (width, height)
    left, bottom, right, top = area_mm(picture)
    face = window_mm or (0.0, 0.0, *face_mm(picture))
    size_mm = face[2] - face[0], face[3] - face[1]
    spot = max(_SPOT_OF_LINE_PITCH * (top - bottom) / height, 0.4 * size_mm[1] / size_px[1])
    guns = setup.guns()
    currents = currents_of_image(image, len(guns), setup)
    if gun is not None:
        guns, currents = guns[gun : gun + 1], currents[gun : gun + 1]
    tube = Tube(size_px, size_mm, guns, spot_mm=spot, reach=4.0, precision=precision)
    timing = timing or RasterTiming.synthesised(width, height, setup.refresh)
    pixel = tube.pitch_mm[0] * tube.pitch_mm[1]
    share = (right - left) * (top - bottom) / (width * height) / pixel
    x, y = shift_mm[0] - face[0], shift_mm[1] - face[1]
    area, power = (left + x, bottom + y, right + x, top + y), float(WHITE * timing.clocks_per_frame * share)
    if setup.blanked_current > 0.0:
        return tube, RetracingBeam(tube, timing, currents, area, power, setup.blanked_current)
    return tube, RasterBeam(tube, timing, currents, area, power)


def vector_tube(
    picture_px: tuple[int, int], size_px: tuple[int, int], setup: TubeSetup, precision: Any = np.float32
) -> Tube:
    """A tube for a display list of a picture of ``picture_px`` pixels; ``vector_beam`` makes its beam."""
    size_mm = face_mm(picture_px)
    spot = max(VECTOR_SPOT_MM, _LEAST_SPOT_PX * size_mm[0] / size_px[0])
    return Tube(size_px, size_mm, setup.guns(), spot_mm=spot, reach=4.0, precision=precision)


def _where_lit(tube: Tube, strokes: StrokeTable) -> StrokeTable:
    """Of each stroke what the spot can light the face from; those that cannot are left out."""
    margin = tube.reach * tube.spot_mm
    low, high = np.full(2, -margin), np.array(tube.size_mm) + margin
    lit = np.ones(len(strokes.ends), np.bool_)
    ends = strokes.ends.copy()
    beyond = ((ends < low) | (ends > high)).reshape(-1, 4)
    for number in np.unique(np.nonzero(beyond)[0]).tolist():
        parts = list(liang_barsky(*ends[number].ravel().tolist(), *low.tolist(), *high.tolist()))
        lit[number] = bool(parts)
        if parts:
            ends[number] = np.reshape(parts[0], (2, 2))
    return StrokeTable(ends, strokes.currents) if lit.all() else StrokeTable(ends[lit], strokes.currents[lit])


def vector_beam(
    tube: Tube, strokes: DeviceStrokes, picture_px: tuple[int, int], setup: TubeSetup
) -> VectorBeam:
    """The beam that draws ``strokes``; a long one refreshed 60 times a second is a little above white.

    It goes only where the spot can light the face: the rest of a stroke takes no time.
    """
    pitch = mm_of(1.0, 0.0, picture_px)[0] - mm_of(0.0, 0.0, picture_px)[0]
    timing = setup.speeds
    rows = np.array(strokes, np.float64).reshape(-1, 5)
    ends = rows[:, :4].reshape(-1, 2, 2) * pitch + mm_of(0.0, 0.0, picture_px)
    colours, which = np.unique(rows[:, 4].astype(np.int64), return_inverse=True)
    guns = len(tube.guns)
    known = np.array([currents_of_colour(colour, guns, setup) for colour in colours.tolist()])
    drawn = _where_lit(tube, StrokeTable(ends, known.reshape(-1, guns)[which.reshape(-1)]))
    shortest_ps = int(Fraction(10**12) / setup.refresh)
    # Energy per length times sqrt(2 pi) spots is the energy across a long stroke; one pixel gets its share.
    speed_mm_s = tube.size_mm[0] / timing.grid / (timing.ps_per_unit * 1e-12)
    pixel = tube.pitch_mm[0] * tube.pitch_mm[1]
    power = _LINE_PEAK * (2.0 * np.pi) ** 0.5 * tube.spot_mm * speed_mm_s / (_FULL_RATE_HZ * pixel)
    blanked = setup.blanked_current
    return VectorBeam(tube, drawn, timing, float(power), shortest_ps, blanked)


def drawing_tube(
    strokes: DeviceStrokes, picture_px: tuple[int, int], size_px: tuple[int, int], setup: TubeSetup
) -> tuple[Tube, VectorBeam]:
    """A ``vector_tube`` and the ``vector_beam`` that draws ``strokes`` on it."""
    tube = vector_tube(picture_px, size_px, setup)
    return tube, vector_beam(tube, strokes, picture_px, setup)
