"""Keeps tubes showing what a session holds: its sheet, and the tube's settings."""

from dataclasses import replace as replace_field
from fractions import Fraction
from functools import partial

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QTimer

from workbench.display.monitor import Knobs
from workbench.display.setup import TubeSetup, too_many_pixels
from workbench.document.model import AnyFigure, Sheet
from workbench.document.state import LONGEST_TIME_S, Look, TubeSettings, as_seen
from workbench.panels.shared.lighting import Lighting
from workbench.panels.stage.picture import without
from workbench.rendering.display_program import tube_strokes
from workbench.rendering.scene.backdrop import whole_picture
from workbench.session.session import Session
from workbench.widgets.tube.refusal import Refusal
from workbench.widgets.tube.view import TubeView

_SETTLE_MS = 120
_NOTHING = np.zeros((3, 4), np.uint32)


def setup_of(settings: TubeSettings) -> TubeSetup:
    """The settings of a session as the display takes them; a name that is not known becomes the usual one."""
    asked = TubeSetup(
        settings.phosphor,
        settings.refresh_hz,
        settings.persistence,
        settings.vector_display,
        knobs=Knobs(settings.brightness, settings.contrast),
    )
    try:
        asked.check()
    except LookupError:
        usual = TubeSetup()
        return replace_field(asked, phosphor=usual.phosphor, vector_display=usual.vector_display)
    return asked


def picture_of(session: Session, sheet: Sheet, lit: bool) -> NDArray[np.uint32] | None:
    """The frame buffer (h, w) of figures and scene, ``lit`` or not; None while a large sheet is worked on."""
    return session.ahead.of(sheet, "picture", partial(whole_picture, sheet), lit)


class TubeFeed(QObject):
    """Feeds ``views`` from ``session``; a view that is hidden is fed when it is shown.

    The tube's time goes into the session's state when that is saved, and comes from it when it is opened. A
    change is fed at once, those that follow on its heels, as under a drag, when they have come to rest.
    """

    def __init__(self, session: Session, views: list[TubeView], parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._views = session, views
        self._fed: dict[TubeView, tuple[Sheet, AnyFigure | None, Look | None, bool, object]] = {}
        self._refusals = {view: Refusal(view) for view in views}
        self._times = dict.fromkeys(views, 0.0)
        self._resting = QTimer(self)
        self._resting.setSingleShot(True)
        self._resting.setInterval(_SETTLE_MS)
        self._resting.timeout.connect(self.feed)
        self._lighting = Lighting(self._again, self)
        session.changed.connect(self._changed)
        for told in (
            session.state_changed,
            session.run.asked,
            session.unfolding.grown,
            session.ahead.arrived,
        ):
            told.connect(self.feed)
        session.storing.connect(self._keep_time)
        for view in views:
            view.shown.connect(self.feed)

    def _again(self) -> None:
        """A run that is made of the picture follows what can be lit by now, as the tube does."""
        self._session.flush()
        self.feed()

    def _changed(self) -> None:
        if not self._resting.isActive():
            self.feed()
        self._resting.start()

    def _keep_time(self) -> None:
        """Put the time of the tube that is seen into the session's state."""
        seen = next((view for view in self._views if view.sight.now), None)
        if seen is not None:
            time_s = min(float(seen.seconds()), LONGEST_TIME_S)
            for view in self._views:
                if view.sight.now:
                    self._times[view] = time_s
            self._session.update_state(tube=replace(self._session.state.tube, time_s=time_s))

    @property
    def _asked(self) -> AnyFigure | None:
        """The figure whose next pixel is asked for: until its run is at its end the tube does not tell."""
        session = self._session
        return session.shown_figure if session.run.ask_first and not session.run.ended else None

    @property
    def _scanned(self) -> object:
        """What beside the sheet decides what a raster tube is given, to be compared."""
        return None

    def _scan(self, view: TubeView, sheet: Sheet, lit: bool) -> bool:
        """Give a raster tube the picture of a sheet; False while that is worked on."""
        refused = too_many_pixels((sheet.width_px, sheet.height_px))
        self._refusals[view].say(refused)
        image = picture_of(self._session, sheet, lit) if not refused else _NOTHING
        if image is not None:
            view.set_image(image)
        return image is not None

    def _draw(self, view: TubeView, sheet: Sheet) -> bool:
        """Give a vector tube the strokes of a sheet; False while they are worked on."""
        strokes = self._session.ahead.of(sheet, "strokes", partial(tube_strokes, sheet))
        if strokes is not None:
            view.set_strokes(strokes, (sheet.width_px, sheet.height_px))
        return strokes is not None

    def feed(self) -> None:
        """Bring every visible view up to date."""
        sheet, settings, asked = self._session.shown, self._session.state.tube, self._asked
        scanned = self._scanned
        if not any(view.sight.now for view in self._views):
            return
        look, lit = self._session.state.looks.get(sheet.id), self._lighting.lit(sheet)
        setup = setup_of(settings)
        for view in self._views:
            if not view.sight.now:
                continue
            view.set_setup(setup)
            view.set_slow_motion(settings.slow_motion)
            view.set_paused(settings.paused)
            if settings.time_s != self._times[view]:
                self._times[view] = settings.time_s
                view.set_seconds(Fraction(settings.time_s))
            fed = self._fed.get(view)
            shaped = look, lit, scanned
            if fed is not None and fed[0] is sheet and fed[1] is asked and fed[2:] == shaped:
                continue
            shown = as_seen(self._session.state, sheet if asked is None else without(sheet, asked))
            if self._scan(view, shown, lit) if view.scans else self._draw(view, shown):
                self._fed[view] = sheet, asked, *shaped
