"""The Animate panel: the picture in a frame, and under it the timeline with its tracks."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import Qt, Signal, SignalInstance
from PySide6.QtGui import QHideEvent, QKeyEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from workbench.document.motion.evaluation import in_frame
from workbench.document.motion.model import Track
from workbench.document.motion.tracks import motion_of, track_on
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.language import _
from workbench.panels.animate.asking import answer_at, asked_axis
from workbench.panels.animate.between_dock import BetweenDock
from workbench.panels.animate.card import AnimateCard
from workbench.panels.animate.derivation import derivation
from workbench.panels.animate.morph_dock import MorphDock
from workbench.panels.animate.names import held_text, value_text
from workbench.panels.animate.physics_dock import PhysicsDock
from workbench.panels.animate.rows import rows_of
from workbench.panels.animate.timeline_pages import TimelinePages
from workbench.panels.animate.turning_dock import TurningDock
from workbench.panels.animate.view import ON_PATH, USUAL_REACH, AnimateView
from workbench.panels.panel import DockPart, SwapPlace
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.stage.gesture import Modifiers
from workbench.panels.stage.stepped import SteppedPanel
from workbench.panels.stage.tools import CircleTool, LineTool, PolygonTool, PolylineTool, SelectTool
from workbench.rendering.subjects.track import KIND, Interval, aimed, keys_stepped
from workbench.session.session import Session
from workbench.widgets.timeline.rows import TimelineShown
from workbench.widgets.timeline.transport import Transport

EXAMPLE = "animate-ball"
_MANY = 24


class AnimatePanel(SteppedPanel):
    """Canvas, tools and card over the transport and the timeline. What is stepped is the chosen track."""

    slug = "animate"
    first_tool = "circle"
    usual = Subject(KIND)
    view: AnimateView
    _stepping = Signal(bool)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        kinds = (SelectTool, CircleTool, PolygonTool, LineTool, PolylineTool)
        super().__init__(session, [kind(session) for kind in kinds], parent)
        self.title = _("Animate")
        self.card: AnimateCard = AnimateCard(session, self.canvas)
        self.view = AnimateView(session, self.canvas, self.second, self.card)
        self.transport, self.between = Transport(session), BetweenDock()
        self.morph, self.turning, self.physics = MorphDock(), TurningDock(), PhysicsDock()
        self.pages = TimelinePages(session)
        self.timeline, self.curves, self.keys = self.pages.tracks, self.pages.curves, self.pages.keys
        self.chosen = ""
        self._active = ""
        self._steps = False
        self.keys.said.connect(self.hover_text)
        self.keys.done.connect(self.refresh_soon)
        self._connect_timeline()
        self.start(
            _("Nothing moves yet. Draw a figure, turn auto-key on, and move it in another frame."),
            [
                ("frame_play", _("Play the frames"), "play", "", session.frames.toggle),
                ("set_key", _("Set a key here"), "key", "K", self._key_here),
                ("auto_key", _("Auto-key on or off"), "record", "", self.transport.auto_key.toggle),
                ("fit_frames", _("Show all frames"), "arrows-out-line-horizontal", "", self.pages.fit),
                ("curves", _("Curve of the track, or the tracks"), "chart-line", "", self._turn_page),
                ("copy_keys", _("Copy the chosen keys"), "copy", "", self.keys.copy),
                ("paste_keys", _("Paste keys here"), "clipboard-text", "", self.keys.paste),
                ("even_speed", _("Make the speed along the path constant"), "path", "", self._even_speed),
                ("insert_time", _("Insert a frame here"), "plus", "", self.keys.insert_time),
                ("remove_time", _("Remove this frame"), "minus", "", self.keys.remove_time),
                ("step_track", _("Step through the in-betweens"), "list-numbers", "", self._step_track),
            ],
        )
        self.card.fold()

    def _connect_timeline(self) -> None:
        transport, between = self.transport, self.between
        frames = self.session.frames
        for page in (self.timeline, self.curves):
            page.track_chosen.connect(self._choose_track)
            page.key_wanted.connect(self._set_key)
            page.reach_wanted.connect(self._set_reach)
        self.timeline.scrolled.connect(self.refresh_soon)
        self.pages.turned.connect(self._page_turned)
        transport.curves.toggled.connect(self.pages.show_curves)
        transport.said.connect(self.hover_text)
        transport.length_wanted.connect(lambda count: self.keys.set_motion(frames=count))
        transport.rate_wanted.connect(lambda rate: self.keys.set_motion(rate=rate))
        transport.ghosts_toggled.connect(lambda on: self._set_reach(USUAL_REACH if on else 0))
        transport.zoom_wanted.connect(lambda factor: self.pages.axis.zoom(factor, frames.number))
        transport.leaving_wanted.connect(lambda: self._step(False))
        between.easing_wanted.connect(lambda easing: self.keys.ease_interval(between.key, easing))
        between.handles_dragged.connect(lambda *handles: self.keys.bend(between.key, handles))
        between.handles_dropped.connect(self.keys.drop)
        between.handles_put_back.connect(self.keys.take_back)
        between.curve.said.connect(self.hover_text)
        between.stepping_wanted.connect(self._step_track)
        self.morph.shift_wanted.connect(lambda shift: self.keys.turn_outline(self.morph.key, shift))
        self.morph.shift_dropped.connect(self.keys.drop)
        self.morph.held.connect(self.session.hold_runs)
        self.turning.turning_wanted.connect(lambda way: self.keys.turn_by(self.turning.key, way))
        self.physics.area_wanted.connect(self.keys.keep_area)
        for dock, slug in (
            (self.morph, "animate-letter"),
            (self.turning, "animate-turn"),
            (self.physics, EXAMPLE),
        ):
            dock.example_wanted.connect(partial(self.session.open_example, slug))
        frames.played.connect(self.refresh_soon)
        frames.settled.connect(self._aim_run)
        for told in (self.session.changed, self.session.opened):
            told.connect(self._aim_run)
        run = self.session.run
        run.moved.connect(self._follow_run)
        for told in (run.asked, run.played):
            told.connect(self._look_at_run)

    def begin(
        self, middle: QWidget, card: QWidget, invitation: str, commands: Sequence[PanelCommand]
    ) -> None:
        """The timeline lies under the canvas, and stays there when the tube takes its place."""
        both = QWidget()
        column = QVBoxLayout(both)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(SwapPlace(middle), 1)
        column.addWidget(self.transport)
        column.addWidget(self.pages)
        super().begin(both, card, invitation, commands)
        self.setFocusProxy(self.canvas)

    def docks(self) -> list[DockPart]:
        """The in-between of the frame that is shown, what morphs and turns are made of, and physics."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return [
            ("between", _("In-between"), self.between, right),
            ("morphing", _("Morph"), self.morph, right),
            ("turning", _("Turn"), self.turning, right),
            ("physics", _("Physics"), self.physics, right),
        ]

    def derivation(self) -> Derivation | None:
        """The page of the chosen track: what keys and in-betweens are, drawn and with its numbers."""
        session, track = self.session, self._track()
        if track is None:
            return None
        figure, frame = session.active_figure, session.frames.number
        return derivation(session.sheet, track, figure, self._keys_stepped(track), frame)

    def _take_tool_when_empty(self) -> None:
        """As everywhere; what moves in a scene is no reason to draw."""
        if self.session.sheet.scene is None:
            super()._take_tool_when_empty()

    @property
    def invitation(self) -> str:
        """The usual one: with every tool nothing moves yet."""
        return ""

    def show_example(self) -> None:
        """Open the bouncing ball."""
        self.session.open_example(EXAMPLE)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The canvas keeps most of the height."""
        super().resizeEvent(event)
        self.pages.fit_height(self.height())

    def _turn_page(self) -> None:
        self.transport.curves.toggle()

    def _page_turned(self, curves: bool) -> None:
        self.transport.curves.setChecked(curves)
        self.pages.fit_height(self.height())
        self.refresh_soon()

    # What is shown

    def _serves_here(self) -> bool:
        """Whether anything moves; a scene is something to see, too."""
        sheet = self.session.sheet
        return sheet.scene is not None or bool(motion_of(sheet).tracks)

    def show_now(self) -> None:
        """Canvas, timeline and in-between as the session is now."""
        track = self._track()
        self.view.target = track.target if track is not None else ""
        super().show_now()
        sheet, frames = self.session.sheet, self.session.frames
        shown = frames.sheet
        chosen = track.target if track is not None else ""
        rows = rows_of(sheet)
        known = self.timeline.shown.tracks is rows
        seen = self.timeline.seen if known else [row.target for row in rows[:_MANY]]
        values = {target: value_text(shown, target) for target in {*seen, chosen} if target}
        self.pages.show_frame(
            sheet, TimelineShown(rows, frames.count, frames.number, self.view.reach, chosen, values)
        )
        self.transport.refresh()
        around = None if track is None else self._keys_stepped(track)
        for dock in (self.between, self.morph, self.turning, self.physics):
            if dock.isVisible() and not frames.playing:
                dock.show_interval(sheet, shown, track, around, frames.number)
        if sheet.motion is not None and not frames.playing:
            told = held_text(sheet, in_frame(sheet, frames.number).held)
            if told:
                self.hover_text.emit(told)

    def _track(self) -> Track | None:
        """The chosen track, until a figure that has others becomes the active one; then its first one."""
        sheet, active = self.session.sheet, self._active_id
        tracks = motion_of(sheet).tracks
        own = next((each for each in tracks if active and each.target.startswith(f"{active}/")), None)
        if own is None or active == self._active:
            return track_on(sheet, self.chosen) or own or next(iter(tracks), None)
        return own

    def _keys_stepped(self, track: Track) -> Interval | None:
        """The keys around the frame; at a key those before or after it, as the run has them."""
        session = self.session
        return keys_stepped(session.sheet, session.state.subject, track.target, session.frames.number)

    @property
    def _active_id(self) -> str:
        active = self.session.active_figure
        return "" if active is None else active.id

    def _choose_track(self, target: str) -> None:
        name = target.split("/")[0]
        if any(figure.id == name for figure in self.session.sheet.figures):
            self.session.update_state(active=name, selection=self.session.sheet.together((name,)))
        self.chosen, self._active = target, self._active_id
        self._aim_run()
        self.refresh_soon()

    def _set_reach(self, reach: int) -> None:
        self.view.reach = reach
        self.transport.ghosts.blockSignals(True)
        self.transport.ghosts.setChecked(reach > 0)
        self.transport.ghosts.blockSignals(False)
        self.refresh_soon()

    # What is done to keys

    def _key_here(self) -> None:
        track, frame = self._track(), self.session.frames.number
        if track is not None:
            self._set_key(track.target, frame)
        elif (figure := self.session.active_figure) is not None:
            target = f"{figure.id}/points_world"
            if len(figure.points_world) == 1:
                target = f"{figure.id}/{figure.points_world[0].id}/*"
            self._set_key(target, frame)

    def _even_speed(self) -> None:
        if (track := self._track()) is not None:
            self.keys.even_speed(track.target)

    def _set_key(self, target: str, frame: int) -> None:
        self.chosen, self._active = target, self._active_id
        self.keys.set(target, frame)

    # What is stepped

    @property
    def stepping(self) -> SignalInstance:
        """Whether an in-between is stepped; else the sentence tells of the frame that is shown."""
        return self._stepping

    def _step(self, on: bool) -> None:
        """Step the run by buttons of its own, or go from frame to frame."""
        run = self.session.run
        if not on:
            run.pause()
            run.set_ask_first(False)
            run.set_detail(False)
        self._steps = on
        self.transport.set_stepping(on)
        self._stepping.emit(on)

    def _aim_run(self, *_changed: object) -> None:
        """Let the run be that of the chosen track, at the step that shows the frame.

        Whoever steps by line, or is asked, stays where that is.
        """
        session, track = self.session, self._track()
        if track is None or not self.isVisible() or session.frames.playing:
            return
        now, run = session.state.subject, session.run
        subject, step = aimed(session.sheet, now, track.target, session.frames.number)
        if not run.detail and not run.ask_first:
            session.update_state(subject=subject, step=step)
        elif not subject.is_of(now):
            session.update_state(subject=subject, step=0)

    def _step_track(self) -> None:
        self.session.frames.stop()
        self._aim_run()
        self._step(True)
        if self.session.state.step == 0:
            self.session.run.forward()

    def _look_at_run(self, *_now: object) -> None:
        """A run that asks, or plays by itself, is stepped."""
        run = self.session.run
        if self.isVisible() and not self._steps and (run.ask_first or run.playing):
            self._step(True)
        if self.isVisible() and asked_axis(self.session) is not None and run.answered is None:
            self.hover_text.emit(_("Where will it be in the next frame? Click there, or choose the value."))

    def showEvent(self, event: QShowEvent) -> None:
        """The run is that of the frame that is shown."""
        super().showEvent(event)
        self._step(self.session.run.ask_first or self.session.run.detail)
        self._aim_run()

    def hideEvent(self, event: QHideEvent) -> None:
        """Elsewhere everything is stepped by its buttons."""
        super().hideEvent(event)
        self._stepping.emit(True)

    @property
    def _answering(self) -> bool:
        """Also where a place in the next frame is asked for."""
        return super()._answering or asked_axis(self.session) is not None

    def clicked(self, x: int, y: int) -> None:
        """With *Ask first* a click tells where the figure is in the next frame."""
        if not answer_at(self.session, x, y):
            super().clicked(x, y)

    def _follow_run(self) -> None:
        """The frame that a step works out is shown, once the run is where it is going."""
        lead = self.session.run
        if self.isVisible() and lead.subject is not None and lead.subject != self.session.subject:
            self._aim_run()  # a late word of a run whose keys have been moved meanwhile
            return
        run = self.view.stepped_run()
        if not self.isVisible() or run is None or run.step is None or run.number == 0 or run.entry is None:
            return
        if run.target != run.number or self.session.frames.playing:
            return
        headings = run.entry.columns
        if "frame" in headings and len(run.step.row) == len(headings):
            frame = int(run.step.row[headings.index("frame")])
            subject = self.session.state.subject
            target = str(subject.arguments.get("target", ""))
            if aimed(self.session.sheet, subject, target, frame) == (subject, run.step.number):
                self.session.frames.show(frame)
            else:  # a late word of a run whose keys have been moved meanwhile
                self._aim_run()

    def _press_handle(self, address: str, modifiers: Modifiers) -> None:
        """A mark of the path is taken hold of in its own frame; dragged, it gets a key there."""
        figure = self.session.active_figure
        if address.startswith(ON_PATH) and figure is not None:
            self.session.frames.show(int(address.removeprefix(ON_PATH)))
            address = f"{self.session.sheet.id}/{figure.id}/{self.view.held_point}/x"
        super()._press_handle(address, modifiers)

    def _arrow(self, dx: int, dy: int, modifiers: Modifiers) -> None:
        """Arrows move what is selected; with nothing selected they go from frame to frame."""
        if self.selected():
            super()._arrow(dx, dy, modifiers)
        elif dx:
            self.session.frames.show(self.session.frames.number + dx)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Home, End and Space are for the frames."""
        frames = self.session.frames
        ends = {Qt.Key.Key_Home: 0, Qt.Key.Key_End: frames.count - 1}
        plain = not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        key = Qt.Key(event.key())
        if plain and key in ends:
            frames.show(ends[key])
        elif plain and key == Qt.Key.Key_Space:
            frames.toggle()
        else:
            super().keyPressEvent(event)
