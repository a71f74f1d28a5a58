"""Pictures of every place in the program, without a screen: one PNG for each theme and scale.

A scale is fixed when Qt starts, so each is shot by a process of its own, in a fresh profile.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from workbench.language import _
from workbench.shell.tour_animate import animate_scenes
from workbench.shell.tour_curves import curve_scenes
from workbench.shell.tour_display import display_scenes
from workbench.shell.tour_space import space_scenes
from workbench.shell.tour_transform import transform_scenes
from workbench.shell.tour_viewing import viewing_scenes
from workbench.shell.workspaces import panel_of

if TYPE_CHECKING:
    from PySide6.QtGui import QPixmap

    from workbench.shell.window import MainWindow

THEMES = ("light", "dark")
_SETTLE_MS = 700
_LIMIT_MS = 120_000
_REGION_2 = 14
_SCALES = (0.5, 4.0)
_SIZES = ((320, 240), (7680, 4320))


class _Words(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        sys.stderr.write(f"tour: {message}\n")
        raise SystemExit(2)


def main(argv: Sequence[str]) -> int:
    """``tour DIR --theme light,dark --scale 1,1.5,2 --size WxH``; the exit status."""
    words = _Words(prog="graphics-workbench tour", description=_("A picture of every place in the program."))
    words.add_argument("folder", type=Path, help=_("the folder for the pictures"))
    words.add_argument("--theme", type=_themes, default=("light", "dark"))
    words.add_argument("--scale", type=_scales, default=(1.0,))
    words.add_argument("--size", type=_size, default=(1280, 680))
    words.add_argument("--here", action="store_true", help=argparse.SUPPRESS)
    try:
        given = words.parse_args(argv)
    except SystemExit as end:
        return int(end.code or 0)
    if given.here:
        return _shoot(given.folder, given.theme, given.scale[0], given.size)
    try:
        given.folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        said = _("tour: the folder {path} cannot be made: {error}")
        sys.stderr.write(said.format(path=given.folder, error=error.strerror) + "\n")
        return 2
    try:
        for scale in given.scale:
            status = _in_a_process_of_its_own(given.folder, given.theme, scale, given.size)
            if status:
                return status
    except OSError as error:
        sys.stderr.write(
            _("tour: its settings cannot be kept while it runs: {error}").format(error=error) + "\n"
        )
        return 1
    return 0


def _in_a_process_of_its_own(folder: Path, themes: Sequence[str], scale: float, size: tuple[int, int]) -> int:
    command = [sys.executable, "-m", "workbench", "tour", str(folder.resolve()), "--here"]
    command += ["--theme", ",".join(themes), "--scale", f"{scale:g}", "--size", f"{size[0]}x{size[1]}"]
    with tempfile.TemporaryDirectory(prefix="graphics-workbench-") as profile:
        environment = {
            **os.environ,
            "GRAPHICS_WORKBENCH_PROFILE": profile,
            "QT_QPA_PLATFORM": "offscreen",
            "QT_SCALE_FACTOR": f"{scale:g}",
            "PYTHONPATH": os.pathsep.join(filter(None, (_parent(), os.environ.get("PYTHONPATH", "")))),
        }
        return subprocess.run(command, env=environment, check=False).returncode


def _parent() -> str:
    return str(Path(__file__).resolve().parents[2])


def _png(pixmap: QPixmap) -> bytes:
    from PySide6.QtCore import QBuffer, QIODevice

    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    pixmap.save(buffer, "PNG")
    return bytes(buffer.data().data())


def _shoot(folder: Path, themes: Sequence[str], scale: float, size: tuple[int, int]) -> int:
    """Take every picture at the scale that this process was started with."""
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from workbench.document.storage.saving import SavingError, replace_file
    from workbench.shell.settled import when_settled
    from workbench.shell.start import Building, make_window

    application = QApplication(["Graphics Workbench"])
    window = make_window()
    window.settings.set("hints", False)
    window.resize(*size)
    building = Building(window, warms=False)
    steps = [(theme, name, act) for theme in themes for name, act in scenes()]

    def leave() -> None:
        theme, name, _act = steps.pop(0)
        path = folder / f"{name}-{theme}-{size[0]}x{size[1]}@{scale:g}.png"
        try:
            replace_file(path, _png(window.grab()))
            print(path, flush=True)
        except (SavingError, OSError) as error:
            reason = str(error) if isinstance(error, SavingError) else error.strerror
            sys.stderr.write(f"tour: {reason}\n")
            application.exit(1)
            return
        patience.start()
        visit()

    def visit() -> None:
        if not steps:
            application.quit()
            return
        theme, _name, act = steps[0]
        window.arriving = None  # a scene finds the panels made once it has entered their workspace
        window.messages.dismiss()
        if window.views.swapped:
            window.views.swap()
        window.go("home")
        window.themes.choose(theme)
        window.resize(*size)
        act(window)
        QTimer.singleShot(_SETTLE_MS, lambda: when_settled(window, leave))

    def give_up() -> None:
        sys.stderr.write(_("tour: not done in time; the pictures so far are kept.") + "\n")
        application.exit(1)

    building.built.connect(visit)
    window.first_frame.connect(building.start)
    patience = QTimer()
    patience.setSingleShot(True)
    patience.setInterval(_LIMIT_MS)
    patience.timeout.connect(give_up)
    patience.start()
    window.show()
    status = application.exec()
    building.end()
    return status


def scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("home", lambda window: window.go("home")),
        ("draw", _draw),
        ("draw-stepped", lambda window: _draw(window, 5)),
        ("draw-compared", _compared),
        ("draw-side-by-side", lambda window: _compared(window, beside=True)),
        ("draw-about", _about),
        ("draw-ellipse", _ellipse),
        ("draw-drift", _drift),
        ("draw-tube", _swapped),
        ("draw-hint", _hint),
        ("draw-question", _question),
        ("draw-empty", _empty),
        ("fill-triangle", lambda window: _fill(window, "triangle", 4)),
        ("fill-letters", lambda window: _fill(window, "letters", 9)),
        ("fill-interiors", _inside),
        ("fill-pond", lambda window: _fill(window, "pond", 700)),
        ("fill-heat", lambda window: _fill(window, "missed", 150, heat=True)),
        ("fill-leak", lambda window: _fill(window, "leak", 900)),
        ("fill-overflow", lambda window: _fill(window, "overflow", 1500)),
        ("fill-depth", _depth),
        ("fill-why", _why),
        ("fill-empty", lambda window: _empty(window, "fill")),
        ("fill-compare", _fill_compared),
        ("clip-lines", lambda window: _clip(window, "clip", 1)),
        ("clip-interval", lambda window: _clip(window, "clip", 3, 3, "liang_barsky")),
        ("clip-fork", lambda window: _clip(window, "clip-fork", 14)),
        ("clip-lab", lambda window: _clip(window, "clip-lab", 0)),
        ("clip-asked", _clip_asked),
        ("clip-empty", lambda window: _empty(window, "clip")),
        *transform_scenes(),
        *viewing_scenes(),
        *animate_scenes(),
        *curve_scenes(),
        *space_scenes(),
        ("display", _display),
        ("display-beam", _beam),
        *display_scenes(),
        ("palette", _palette),
        ("settings", lambda window: window.go("settings")),
        ("keys", lambda window: window.go("keys")),
        ("help", lambda window: window.go("help")),
        ("about", lambda window: window.go("about")),
    ]


def _draw(window: MainWindow, step: int = 0) -> None:
    window.open_example("line")
    figures = window.session.sheet.figures
    window.session.update_state(active=figures[0].id, selection=(figures[0].id,), step=step)


def _swapped(window: MainWindow) -> None:
    _draw(window, 6)
    window.views.swap()


def _compared(window: MainWindow, beside: bool = False) -> None:
    """A line that passes half way between pixels, by two algorithms that fall to different sides."""
    from workbench.document.edits import add_figure
    from workbench.document.model import Line, WorldPoint
    from workbench.document.samples.examples import blank_sheet
    from workbench.panels.draw.panel import DrawPanel

    session = window.session
    session.new(blank_sheet(40, 28))
    line = Line("f1", (WorldPoint("p1", 34, 24), WorldPoint("p2", 6, 3)), "bresenham_line", 1)
    other = Line("f2", (WorldPoint("p3", 36, 20), WorldPoint("p4", 4, 4)), "bresenham_line", 2)
    for figure in (line, other):
        session.apply(add_figure(session.sheet.id, figure), _("Draw a line"))
    session.undo_stack.setClean()
    window.go("draw")
    session.update_state(active="f2", selection=("f2",), compare="dda_line")
    panel_of(window.panels("draw"), DrawPanel).card.side_by_side.setChecked(beside)


def _ellipse(window: MainWindow) -> None:
    """The step at which an ellipse goes over from one region to the other."""
    window.open_example("circles")
    session = window.session
    ellipse = session.sheet.figures[-1].id
    session.update_state(active=ellipse, selection=(ellipse,), step=_REGION_2)
    window.arrangements.bring_forward("hand_table")


def _about(window: MainWindow) -> None:
    window.open_example("line")
    window.arrangements.bring_forward("about")


def _drift(window: MainWindow) -> None:
    """A long line in fixed point, and how far it drifts from the ideal one."""
    from workbench.document.edits import add_figure
    from workbench.document.model import Line, WorldPoint
    from workbench.document.samples.examples import blank_sheet
    from workbench.panels.draw.panel import DrawPanel

    session = window.session
    session.new(blank_sheet(220, 140))
    line = Line("f1", (WorldPoint("p1", 6, 20), WorldPoint("p2", 213, 117)), "dda_line_fixed", 1)
    session.apply(add_figure(session.sheet.id, line), _("Draw a line"))
    session.undo_stack.setClean()
    window.go("draw")
    session.update_state(active="f1", selection=("f1",), compare="dda_line")
    panel_of(window.panels("draw"), DrawPanel).card.side_by_side.setChecked(False)
    window.arrangements.bring_forward("distance")


def _beam(window: MainWindow) -> None:
    """So slow that the beam is caught in the middle of a line."""
    from msgspec.structs import replace

    window.open_example("house")
    tube = replace(window.session.state.tube, slow_motion=20_000.0, phosphor="P7")
    window.session.update_state(tube=tube)
    window.enter("display", lambda: window.panels("display")[0].show_page())


def _fill(window: MainWindow, slug: str, step: int, heat: bool = False) -> None:
    from workbench.panels.fill.panel import FillPanel

    window.open_example(slug)
    front = window.session.sheet.figures[-1].id
    window.session.update_state(active=front, selection=(front,), step=step)
    panel = panel_of(window.panels("fill"), FillPanel)
    panel.choose_tool("select")
    window.session.update_state(selection=(front,))
    panel.card.heat.setChecked(heat)


def _inside(window: MainWindow) -> None:
    from workbench.panels.fill.panel import FillPanel

    _fill(window, "two-interiors", 0)
    panel = panel_of(window.panels("fill"), FillPanel)
    panel.choose_tool("inside")
    panel.inside.point = (25.0, 20.0)
    panel.refresh()


def _depth(window: MainWindow) -> None:
    _fill(window, "missed", 100)
    window.arrangements.bring_forward("depth")


def _why(window: MainWindow) -> None:
    _fill(window, "missed", 60)
    window.session.update_state(pixel=(8, 6))


def _hint(window: MainWindow) -> None:
    _draw(window)
    window.show_hints_again()
    window.settings.set("hints", False)


def _question(window: MainWindow) -> None:
    from workbench.document.edits import move_figures

    _draw(window, 3)
    session = window.session
    session.apply(move_figures(session.state.selection, 0, 1), _("Move"))
    session.update_state(step=3)
    window.files.unless_unsaved(lambda: None)
    session.undo_stack.setClean()


def _empty(window: MainWindow, workspace: str = "draw") -> None:
    window.session.new()
    window.go(workspace)


def _display(window: MainWindow) -> None:
    window.open_example("house")
    window.enter("display", lambda: window.panels("display")[0].show_page())


def _fill_compared(window: MainWindow) -> None:
    _fill(window, "triangle", 4)
    window.session.update_state(compare="boundary_fill_4")
    window.arrangements.bring_forward("compare")


def _clip(window: MainWindow, slug: str, step: int, number: int = -1, clipper: str = "") -> None:
    from workbench.document.edits import set_clipper

    window.open_example(slug)
    session = window.session
    if clipper:
        session.apply(set_clipper(session.sheet.id, clipper), _("Choose the clipper"))
        session.undo_stack.setClean()
    session.update_state(active=session.sheet.figures[number].id, step=step)


def _clip_asked(window: MainWindow) -> None:
    _clip(window, "clip", 1)
    window.session.update_state(ask_first=True)


def _palette(window: MainWindow) -> None:
    _draw(window, 2)
    window.show_palette()


def _themes(text: str) -> tuple[str, ...]:
    chosen = tuple(text.split(","))
    for each in chosen:
        if each not in THEMES:
            raise argparse.ArgumentTypeError(
                _("{each} is not a theme; give light, dark or both").format(each=each)
            )
    return chosen


def _scales(text: str) -> tuple[float, ...]:
    try:
        chosen = tuple(float(each) for each in text.split(","))
    except ValueError:
        chosen = ()
    if not chosen or not all(_SCALES[0] <= each <= _SCALES[1] for each in chosen):
        raise argparse.ArgumentTypeError(_("{text} is not a list of scales like 1,1.5,2").format(text=text))
    return chosen


def _size(text: str) -> tuple[int, int]:
    width, __, height = text.partition("x")
    if width.isdecimal() and height.isdecimal():
        size = int(width), int(height)
        if all(low <= value <= high for low, value, high in zip(_SIZES[0], size, _SIZES[1], strict=True)):
            return size
    raise argparse.ArgumentTypeError(_("{text} is not a size like 1280x680").format(text=text))
