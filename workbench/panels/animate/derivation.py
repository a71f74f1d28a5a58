"""A track as a page: what a key-frame system does, a labelled drawing of the motion, how a frame is made."""

import numpy as np

from workbench.algorithms.animation.easing_words import easing_formula, way_text
from workbench.algorithms.animation.easings import eased
from workbench.algorithms.marks import Spot, Stroke, Word
from workbench.algorithms.numerals import numeral
from workbench.document.model import AnyFigure, Sheet
from workbench.document.motion.evaluation import at
from workbench.document.motion.groups import value_of
from workbench.document.motion.model import EASINGS, SPLINE, Key, Track
from workbench.document.motion.tracks import group_moved, motion_of
from workbench.exchange.diagrams import Axes, Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.language import _
from workbench.panels.animate.names import easing_titles, label_of
from workbench.panels.animate.path import alone, path_of
from workbench.panels.stage.outline import outline
from workbench.rendering.subjects.track import Interval
from workbench.widgets.formulas.paper import paper_inks

_HEIGHT_PT = 170.0
_MARGIN = 0.12
_MOST_NAMED = 12


def derivation(
    sheet: Sheet, track: Track, figure: AnyFigure | None, around: Interval | None, frame: int
) -> Derivation | None:
    """The page of a track, with ``figure`` drawn on its way, between the keys ``around`` a frame; None for a
    track of one key or that moves nothing."""
    if around is None or group_moved(sheet, track) is None:
        return None
    title = _("Key frames and in-betweens")
    blocks: list[Block] = [
        Heading(f"{title}: {label_of(sheet, track.target)}"),
        Sentence(
            _(
                "The animator sets key frames, in which a value is given: frames {frames} here. The system "
                "works out every frame between them, the in-betweens."
            ).format(frames=", ".join(str(key.frame) for key in track.keys))
        ),
    ]
    if figure is not None:
        own = alone(sheet, figure)
        drawn = _way(own, {key.frame for key in track.keys}, frame) if own.motion is not None else None
        blocks += [] if drawn is None else [drawn]
    blocks += _one_frame(sheet, track, around, frame)
    blocks.append(_graph(sheet, track, frame))
    blocks += [
        Sentence(
            _(
                "With a straight line in time the spacing is even; with an easing the same values are passed "
                "at other times, so that the motion starts or stops slowly."
            )
        ),
        Sentence(
            _(
                "Morphing is the same for a shape: both outlines get equally many vertices, and "
                "each vertex moves "
                "from its place in one key to its place in the next."
            )
        ),
        Sentence(
            _(
                "Advantage: {keys} keys give {frames} frames of this value. The animator draws what matters, "
                "the computer the rest, and a key that is changed changes all frames around it."
            ).format(keys=len(track.keys), frames=track.keys[-1].frame - track.keys[0].frame + 1)
        ),
    ]
    return Derivation(title, blocks, paper_inks())


def _way(own: Sheet, keyed: set[int], frame: int) -> Drawing | None:
    """The path with a mark for each frame, the figure in the track's keys and in the frame."""
    path = path_of(own)
    if len(path) < motion_of(own).frames or not np.ptp(path, axis=0).any():
        return None
    items: list[Item] = [Stroke(path, "muted", "hair")]
    items += [Spot(x, y, "muted", "dot", "small") for x, y in path.tolist()]
    corners = [path]
    keyed = {number for number in keyed if number < len(path)}
    for number in sorted({*keyed, frame}):
        seen, ink = at(own, number), "data1" if number in keyed else "data2"
        curves = outline(seen, seen.figures[0])
        for curve in curves:
            items.append(Stroke(curve, ink, "medium", "solid" if number in keyed else "dash"))  # type: ignore[arg-type]
            corners.append(curve)
        x, y = path[number].tolist()
        top = max((float(curve[:, 1].max()) for curve in curves), default=y)
        items.append(Word(f"k = {number}", x, top, "text", 0 if number in keyed else 1, 1))
    every = np.concatenate(corners)
    return Drawing(_around(every), items, _HEIGHT_PT)


def _graph(sheet: Sheet, track: Track, frame: int) -> Drawing:
    """The first number of the track over the frames, its keys named."""
    group = group_moved(sheet, track)
    frames = range(track.keys[0].frame, track.keys[-1].frame + 1)
    numbers = [0.0 if group is None else value_of(at(sheet, each), group)[0] for each in frames]
    curve = np.column_stack([np.array(frames, np.float64), numbers])
    items: list[Item] = [Axes("k", "P"), Stroke(curve, "data1", "medium")]
    for place, key in enumerate(track.keys):
        x, y = float(key.frame), float(key.value[0])
        items.append(Spot(x, y, "data1"))
        if len(track.keys) <= _MOST_NAMED:
            beside = [other.value[0] for other in track.keys[max(place - 1, 0) : place + 2]]
            items.append(
                Word(f"P_{{{place}}} = {numeral(y)}", x, y, "text", 0, -1 if y == min(beside) else 1)
            )
    if frame in frames:
        x, y = curve[frame - frames[0]].tolist()
        items.append(Spot(x, y, "data2", "ring", "large"))
    return Drawing(_around(curve), items, _HEIGHT_PT)


def _around(points: np.ndarray) -> tuple[float, float, float, float]:
    """A window around points, with a margin."""
    low, high = points.min(axis=0), points.max(axis=0)
    room = np.maximum(_MARGIN * (high - low), 0.5)
    (xmin, ymin), (xmax, ymax) = (low - room).tolist(), (high + room).tolist()
    return xmin, ymin, xmax, ymax


def _one_frame(sheet: Sheet, track: Track, around: tuple[Key, Key], frame: int) -> list[Block]:
    """The formula, and with numbers for the frame where it is an in-between of numbers."""
    first, second = around
    blocks: list[Block] = [
        Sentence(
            _(
                "Between two keys: $P(t) = P_k + t (P_{k+1} - P_k)$, "
                "with $t = j / (n + 1)$ in in-between $j$ of $n$."
            )
        )
    ]
    group = group_moved(sheet, track)
    n, j = second.frame - first.frame - 1, frame - first.frame
    if group is None or group.kind != "numbers" or not 0 < j <= n or first.easing == SPLINE:
        return blocks
    code, t = EASINGS.index(first.easing), j / (n + 1)
    part = eased(code, *first.handles, t)
    blocks += [
        Sentence(
            _("Frame {frame} is in-between {j} of {n}: t = {j} / {whole} = {t}.").format(
                frame=frame, j=j, n=n, whole=n + 1, t=numeral(t)
            )
        ),
        Sentence(
            _("Eased ({easing}): {formula} = {part}.").format(
                easing=easing_titles()[first.easing], formula=easing_formula(code, t), part=numeral(part)
            )
        ),
    ]
    for a, b, value in zip(first.value, second.value, value_of(at(sheet, frame), group), strict=True):
        blocks.append(Sentence(f"P = {way_text(a, b, part)} = {numeral(value)}"))
    return blocks
