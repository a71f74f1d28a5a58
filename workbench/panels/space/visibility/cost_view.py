"""What the method that is stepped gives and what it costs, each with a number of this scene."""

from collections.abc import Callable
from functools import partial

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QWidget

from workbench.language import _, ngettext, reason_of
from workbench.panels.space.visibility.depth_run import DepthRun
from workbench.panels.space.visibility.method_words import MethodMeasures, method_words, what_holds
from workbench.rendering.mapping import Call
from workbench.rendering.scene.arena import run_methods
from workbench.rendering.scene.depth_measures import DepthMeasures, distance_of, least_distance, measured
from workbench.rendering.scene.fragments import NOTHING
from workbench.rendering.scene.line_calls import HIDDEN_LINES
from workbench.rendering.subjects.visibility import (
    DEPTH_BUFFER,
    NOT_ROUNDED,
    OCTREES,
    backwards,
    depth_call,
    window_of,
)
from workbench.session.answers import Answers

_BYTE, _DOUBLE = 8, 64
_SCREEN = 1920, 1080
_FORMULA_BITS = 16


class CostView(QScrollArea):
    """Measures only while it is seen, on a thread of its own."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._question = 0
        self._run: DepthRun | None = None
        self._asked: tuple[Call, str] | None = None
        self.measures: DepthMeasures | None = None
        self._method = DEPTH_BUFFER
        self._other: MethodMeasures | None = None
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setContentsMargins(12, 8, 12, 8)
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.words.setAccessibleName(_("Gains and costs, measured"))
        self.setWidget(self.words)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    def refresh(self, run: DepthRun | None, method: str = DEPTH_BUFFER) -> None:
        """Follow the run of a method."""
        self._run, self._method = run, method
        if run is None or not len(run.fragments):
            self._question += 1
            self._asked = self.measures = self._other = None
            nothing = _("No surface covers a pixel, so there is nothing to measure.")
            elsewhere = _("On the page Visibility the method that is stepped is measured on this scene.")
            self.words.setText(elsewhere if run is None else nothing)
        elif method in (HIDDEN_LINES, *OCTREES):
            self._question += 1
            self._asked = self.measures = self._other = None
            self.words.setText(what_holds(method))
        elif self.isVisible() and not self._is_asked(run.call, method):
            self._ask(run)
        else:
            self._tell()

    def _is_asked(self, call: Call, method: str) -> bool:
        return self._asked is not None and self._asked[0] is call and self._asked[1] == method

    def showEvent(self, event: QShowEvent) -> None:
        """Measure when it is seen."""
        super().showEvent(event)
        self.refresh(self._run, self._method)

    def _ask(self, run: DepthRun) -> None:
        self._question += 1
        self._asked, self.measures, self._other = (run.call, self._method), None, None
        self.words.setText(_("Measuring…"))
        work: Callable[[], object] = partial(_let_loose, self._question, run, self._method)
        if self._method == DEPTH_BUFFER:
            work = partial(_measured, self._question, *_calls(run))
        self._answers.ask(work, "measures of hidden surfaces")

    def _take(self, answer: tuple[int, DepthMeasures | MethodMeasures | str]) -> None:
        question, measures = answer
        if question != self._question:
            return
        if isinstance(measures, DepthMeasures):
            self.measures = measures
        elif isinstance(measures, MethodMeasures):
            self._other = measures
        else:
            self.words.setText(measures)
        self._tell()

    def _tell(self) -> None:
        if self._run is not None and self.measures is not None:
            self.words.setText(_told(self._run, self.measures))
        elif self._other is not None:
            self.words.setText(method_words(self._other))


def _calls(run: DepthRun) -> tuple[Call, Call, Call]:
    """The run, the same in the other order, and the same without rounding."""
    other = {"backwards": not backwards(run.subject)}, {"bits": NOT_ROUNDED}
    reverse, unrounded = (
        depth_call(run.sheet, replace(run.subject, arguments={**run.subject.arguments, **each}))
        for each in other
    )
    assert reverse is not None
    assert unrounded is not None
    return run.call, reverse, unrounded


def _let_loose(question: int, run: DepthRun, method: str) -> tuple[int, MethodMeasures | str]:
    scene = run.sheet.scene
    assert scene is not None
    try:
        runs = run_methods(scene, run.size, window_of(run.sheet), (method, DEPTH_BUFFER))
    except ValueError as problem:
        return question, reason_of(problem)
    return question, MethodMeasures(*runs)


def _measured(question: int, *calls: Call) -> tuple[int, DepthMeasures]:
    return question, measured(*calls)


Told = tuple[str, tuple[tuple[str, str], ...]]


def gains_and_costs(run: DepthRun, found: DepthMeasures) -> tuple[Told, Told]:
    """What the course says for and against the depth buffer, each with a number of this scene, rich text."""
    gives = (
        (_("Any order"), _other_order(found)),
        (_("Handles piercing"), _piercing(found)),
        (
            _("Time roughly linear"),
            _("{triangles} triangles, {fragments:,} fragments: one comparison each.").format(
                triangles=found.triangles, fragments=found.fragments
            ),
        ),
    )
    costs = (
        (_("Memory"), _memory(run)),
        (_("Rounded depths"), _rounded(run, found)),
        (
            _("Wasted work"),
            _("{lost:,} of {writes:,} writes were overwritten; {refused:,} fragments were refused.").format(
                lost=found.overwritten,
                writes=found.overwritten + found.covered,
                refused=found.fragments - found.overwritten - found.covered,
            ),
        ),
        (_("Aliasing"), _aliasing(run)),
        (
            _("No transparency"),
            _("{n:,} of {covered:,} covered pixels have more than one surface, but show only one.").format(
                n=found.layered, covered=found.covered
            ),
        ),
    )
    return (_("Advantages"), gives), (_("Limits"), costs)


def _told(run: DepthRun, found: DepthMeasures) -> str:
    parts = []
    for title, rows in gains_and_costs(run, found):
        lines = "".join(f"<p><b>{head}.</b> {text}</p>" for head, text in rows)
        parts.append(f"<h4>{title}</h4>{lines}")
    return "".join(parts)


def _aliasing(run: DepthRun) -> str:
    """How many pixels have a border of surfaces beside them: there the picture has steps."""
    seen = run.fragments.seen(run.size)
    border = np.zeros(seen.shape, bool)
    for axis in (0, 1):
        unlike = np.diff(seen, axis=axis) != 0
        ahead = np.zeros(seen.shape, bool)
        ahead[tuple(slice(None, -1) if k == axis else slice(None) for k in (0, 1))] = unlike
        border |= ahead | np.roll(ahead, 1, axis)
    count = int((border & (seen != NOTHING)).sum())
    text = _(
        "{n:,} of {covered:,} covered pixels lie at a border; each shows one surface, so borders are stepped."
    )
    return text.format(n=count, covered=int((seen != NOTHING).sum()))


def _other_order(found: DepthMeasures) -> str:
    if not found.other_order:
        return _("Drawn in the opposite order, all {covered:,} pixels are the same.").format(
            covered=found.covered
        )
    text = ngettext(
        "Drawn in the opposite order, {n:,} of {covered:,} pixels differs: its depths are equal.",
        "Drawn in the opposite order, {n:,} of {covered:,} pixels differ: their depths are equal.",
        found.other_order,
    )
    return text.format(n=found.other_order, covered=found.covered)


def _piercing(found: DepthMeasures) -> str:
    text = ngettext(
        "{n} pair of triangles pierces; each pixel shows the nearer one, and nothing was cut.",
        "{n} pairs of triangles pierce; each pixel shows the nearer one, and nothing was cut.",
        found.piercing,
    )
    return text.format(n=found.piercing) if found.piercing else _("No two triangles of this scene pierce.")


def _memory(run: DepthRun) -> str:
    width, height = run.size
    bits = run.bits or _DOUBLE
    here, screen = (-(-w * h * bits // _BYTE) for w, h in (run.size, _SCREEN))
    text = _("{width} × {height} depths of {bits} bits are {here:,} bytes; {w} × {h} take {mb:.1f} MB.")
    return text.format(
        width=width, height=height, bits=bits, here=here, w=_SCREEN[0], h=_SCREEN[1], mb=screen / 1e6
    )


def _rounded(run: DepthRun, found: DepthMeasures) -> str:
    """How many pixels are wrong, and the formula that says where."""
    assert run.sheet.scene is not None
    camera, bits = run.sheet.scene.camera, run.bits or _FORMULA_BITS
    wrong = (
        _("With {bits} bits {n:,} of {covered:,} pixels show another triangle than without rounding.").format(
            bits=bits, n=found.rounded, covered=found.covered
        )
        if run.bits
        else _("Depths are not rounded now; with few bits, surfaces close to one another cause z-fighting.")
    )
    if camera.projection == "matrix":
        return wrong  # it has a formula of its own
    deepest = float(run.fragments.z.max()) / run.farthest
    z, apart = distance_of(camera, deepest), least_distance(camera, deepest, bits)
    formula = (
        "Δz = z² (f − n) / (f n (2<sup>b</sup> − 1))"
        if camera.projection == "perspective"
        else "Δz = (f − n) / (2<sup>b</sup> − 1)"
    )
    where = _(
        "{formula}: at z = {z:.4g}, b = {bits}, surfaces less than {apart:.3g} apart may show z-fighting."
    )
    return f"{wrong} {where.format(formula=formula, z=z, bits=bits, apart=apart)}"
