"""What lies under the transport: the tracks, or the curve of the chosen one, over the same frames."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QStackedWidget

from workbench.document.model import Sheet
from workbench.panels.animate.key_edits import KeyEdits
from workbench.panels.animate.names import easing_titles
from workbench.panels.animate.track_curve import curve_of
from workbench.session.session import Session
from workbench.widgets.timeline.curve_editor import CurveEditor
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.key_editor import KeyEditor
from workbench.widgets.timeline.rows import TimelineShown
from workbench.widgets.timeline.timeline import Timeline

_TRACKS_PX, _LOW_TRACKS_PX = 170, 100
_CURVES_PX, _LOW_CURVES_PX, _LOW_PX = 240, 140, 460


class TimelinePages(QStackedWidget):
    """Two pages that share frames and chosen keys. ``turned``: the other page is seen, the curves or not."""

    turned = Signal(bool)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.axis = FrameAxis(self)
        easings = easing_titles().items()
        self.tracks, self.curves = Timeline(self.axis, easings), CurveEditor(self.axis, easings)
        self.keys = KeyEdits(session, self.axis, self)
        for page in (self.tracks, self.curves):
            self.addWidget(page)
            self._connect(page)
        self.curves.keys_moved.connect(self._move)
        self.curves.handles_wanted.connect(self.keys.bend_all)
        self.curves.said.connect(self.keys.said)

    def _connect(self, page: KeyEditor) -> None:
        keys, frames = self.keys, self._session.frames
        page.frame_wanted.connect(frames.show)
        page.play_wanted.connect(frames.toggle)
        page.keys_dragged.connect(keys.drag)
        page.keys_scaled.connect(keys.scale)
        page.keys_dropped.connect(keys.drop)
        page.keys_put_back.connect(keys.take_back)
        page.deletion_wanted.connect(keys.delete)
        page.copy_wanted.connect(keys.copy)
        page.paste_wanted.connect(keys.paste)
        page.easing_wanted.connect(keys.ease)
        page.page_wanted.connect(lambda: self.show_curves(page is self.tracks))

    def _move(self, by: int, place: int, amount: float) -> None:
        self.keys.move(self.curves.shown.chosen, by, place, amount)

    @property
    def page(self) -> KeyEditor:
        """The page that is seen."""
        return self.curves if self.currentWidget() is self.curves else self.tracks

    def show_curves(self, on: bool) -> None:
        """Turn to the curves, or to the tracks; the focus goes along."""
        focused = self.page.hasFocus()
        if on != (self.page is self.curves):
            self.setCurrentWidget(self.curves if on else self.tracks)
            if focused:
                self.page.setFocus()
            self.turned.emit(on)

    def fit(self) -> None:
        """Show all frames, and on the page of the curves all values."""
        self.curves.fit_all()

    def fit_height(self, of: int) -> None:
        """Take as much of the height ``of`` all as the page needs; the canvas keeps most of it."""
        heights = (_CURVES_PX, _LOW_CURVES_PX) if self.page is self.curves else (_TRACKS_PX, _LOW_TRACKS_PX)
        self.setFixedHeight(heights[of < _LOW_PX])

    def show_frame(self, sheet: Sheet, shown: TimelineShown) -> None:
        """Show the tracks of a sheet in a frame on the page that is seen."""
        self.page.show_tracks(shown)
        if self.page is self.curves:
            self.curves.show_curve(shown.chosen, curve_of(sheet, shown.chosen))
