"""Every command of the window in one table: what it is called, its keys, where it is found, what it does.

Menus, tool bar, command palette and key table are all made from this table. ``KEYS_ELSEWHERE`` lists the keys
that belong to one part of the window only, so that the key table is whole and clashes are seen.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtGui import QKeySequence

from workbench.language import _
from workbench.shell.timeline_keys import timeline_keys

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


@dataclass(frozen=True, slots=True)
class Command:
    """One command. ``needs`` is "document", "run" or "answer" (a wrong one): what waits until one is there;
    ``separated`` draws a line above it in its menu. ``focused_key`` is a key that parts of the
    window answer while they have the focus: the menu tells it.
    """

    id: str
    text: str
    handler: "Callable[[MainWindow], object]"
    keys: tuple[str, ...] = ()
    icon: str = ""
    tooltip: str = ""
    menu: str = ""
    needs: str = ""
    separated: bool = False
    focused_key: str = ""


def key_text(key: str) -> str:
    """A key as this system writes it."""
    return QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)


def menu_titles() -> tuple[tuple[str, str], ...]:
    """Id and title of each menu, in order."""
    return (
        ("file", _("&File")),
        ("edit", _("&Edit")),
        ("run", _("&Run")),
        ("view", _("&View")),
        ("help", _("&Help")),
    )


def submenu_titles() -> tuple[tuple[str, str, str], ...]:
    """Id and title of each menu inside another, and the command that it follows."""
    return (("export", _("Export"), "save_as"), ("sheets", _("Sheets"), "reset"))


def commands() -> tuple[Command, ...]:
    """The table."""
    from workbench.shell.edit_commands import edit_commands  # made of these rows' kind
    from workbench.shell.export_commands import export_commands
    from workbench.shell.sheets import sheet_commands
    from workbench.shell.view_commands import view_commands

    return (
        Command(
            "new",
            _("New"),
            lambda w: w.files.new(),
            ("Ctrl+N",),
            "file-plus",
            _("Start an empty picture"),
            "file",
            "document",
        ),
        Command(
            "open",
            _("Open..."),
            lambda w: w.files.open(),
            ("Ctrl+O",),
            "folder-open",
            _("Open a picture from a file"),
            "file",
            "document",
        ),
        Command(
            "import",
            _("Import..."),
            lambda w: w.files.bring_in(),
            (),
            "download-simple",
            _("Bring sheets, a drawing or a list of points into this picture"),
            "file",
            "document",
        ),
        Command(
            "save",
            _("Save"),
            lambda w: w.files.save(),
            ("Ctrl+S",),
            "floppy-disk",
            _("Save the picture in its file"),
            "file",
            "document",
            separated=True,
        ),
        Command(
            "save_as",
            _("Save as..."),
            lambda w: w.files.save_as(),
            ("Ctrl+Shift+S",),
            "",
            _("Save the picture in another file"),
            "file",
            "document",
        ),
        *export_commands(),
        Command(
            "quit",
            _("Quit"),
            lambda w: w.close(),
            ("Ctrl+Q",),
            "sign-out",
            _("Close the window; you are asked about unsaved changes"),
            "file",
            separated=True,
        ),
        *edit_commands(),
        Command(
            "settings",
            _("Settings"),
            lambda w: w.show_page("settings"),
            ("Ctrl+,",),
            "gear",
            _("Theme, type size, calm, ask first"),
            "edit",
            separated=True,
        ),
        Command(
            "first",
            _("First step"),
            lambda w: w.run_do("first"),
            (),
            "skip-back",
            _("Go to the start of the run"),
            "run",
            "run",
        ),
        Command(
            "back",
            _("Step back"),
            lambda w: w.run_do("back"),
            (",",),
            "caret-left",
            _("Go one step back"),
            "run",
            "run",
        ),
        Command(
            "forward",
            _("Step forward"),
            lambda w: w.run_do("forward"),
            (".",),
            "caret-right",
            _("Go one step forward"),
            "run",
            "run",
        ),
        Command(
            "last",
            _("Last step"),
            lambda w: w.run_do("last"),
            (),
            "skip-forward",
            _("Go to the end of the run"),
            "run",
            "run",
        ),
        Command(
            "play",
            _("Play or pause"),
            lambda w: w.session.frames.stop() if w.session.frames.playing else w.run_do("toggle_play"),
            (),
            "play",
            _("Go on step by step, or stop; frames that play stop too"),
            "run",
            "run",
            focused_key="Space",
        ),
        Command(
            "detail",
            _("Step or every line"),
            lambda w: w.toggle_detail(),
            ("D",),
            "list-numbers",
            _("Switch between rows of the hand table and every line"),
            "run",
            "run",
            separated=True,
        ),
        Command(
            "ask_first",
            _("Ask first"),
            lambda w: w.toggle_ask_first(),
            ("A",),
            "question",
            _("Choose the next pixel yourself before it is shown"),
            "run",
            "document",
        ),
        Command(
            "try_again",
            _("Try again"),
            lambda w: w.run_do("try_again"),
            ("Shift+A",),
            "",
            _("Clear the wrong answer and answer again"),
            "run",
            "answer",
        ),
        Command(
            "show_answer",
            _("Show it"),
            lambda w: w.run_do("show_answer"),
            ("Shift+I",),
            "",
            _("Show the step that was asked for"),
            "run",
            "answer",
        ),
        *view_commands(),
        *sheet_commands(),
        Command(
            "help",
            _("Help"),
            lambda w: w.show_page("help"),
            ("F1",),
            "question",
            _("How to begin, and what you can do here"),
            "help",
        ),
        Command(
            "keys",
            _("Keys"),
            lambda w: w.show_page("keys"),
            ("?",),
            "keyboard",
            _("All keys in one table"),
            "help",
        ),
        Command(
            "hints",
            _("Show the hints again"),
            lambda w: w.show_hints_again(),
            (),
            "lightbulb",
            _("Point out the canvas, step bar and source once more"),
            "help",
            "document",
        ),
        Command(
            "about",
            _("About"),
            lambda w: w.show_page("about"),
            (),
            "info",
            _("Version, licence, and a diagnosis to copy"),
            "help",
            separated=True,
        ),
    )


def keys_elsewhere() -> tuple[tuple[str, str, str], ...]:
    """Keys that one part of the window answers while it has the focus: part, key, what it does."""
    stepping = _("Step bar, or canvas with nothing selected")
    canvas, curves = _("Canvas"), _("Canvas of Curves")
    box, view = _("Transform box"), _("Pictures of View")
    space = _("Pictures of Projection in Space")
    return (
        (stepping, "Space", _("Play or pause")),
        (stepping, "Left", _("Step back")),
        (stepping, "Right", _("Step forward")),
        (stepping, "Home", _("First step")),
        (stepping, "End", _("Last step")),
        (_("Step bar, when asked first with choices"), "1, 2, 3, 4, 5, 6", _("Choose what comes next")),
        (_("Canvas with a selection"), "Left, Right, Up, Down", _("Move by one pixel; with Shift by ten")),
        (canvas, "V", _("Select")),
        (canvas, "L", _("Draw lines")),
        (canvas, "O", _("Draw circles")),
        (canvas, "E", _("Draw ellipses")),
        (canvas, "P", _("Draw polylines")),
        (canvas, "C", _("Move the keyboard cursor from cell to cell; Enter acts where it is")),
        (canvas, "Ctrl+D", _("Duplicate what is selected")),
        (canvas, "Ctrl+A", _("Select all")),
        (canvas, "Ctrl+G, Ctrl+Shift+G", _("Group, ungroup")),
        (canvas, "Alt", _("Held while clicking: select one of a group, as a double click does")),
        (canvas, "Ctrl+T", _("Box that moves, rotates, scales and shears what is selected")),
        (canvas, "Shift+H, Shift+V", _("Flip horizontally, vertically")),
        (box, "], [", _("Rotate by 1 degree; with Alt also Left and Right, with Alt and Shift by 15")),
        (box, "Left, Right, Up, Down", _("Move by one unit; with Shift by ten; Ctrl scales")),
        (box, "Tab", _("Go to the next handle, which the arrows then drag")),
        (box, "Shift", _("Held while dragging: 15 degrees, one ratio, one axis")),
        (box, "Ctrl", _("Held while dragging: scale and shear about the pivot")),
        (box, "Alt", _("Held while dragging a side: shear")),
        (canvas, "Ctrl+]", _("Bring forwards")),
        (canvas, "Ctrl+[", _("Send backwards")),
        (canvas, "Ctrl++", _("Zoom in, as the wheel does")),
        (canvas, "Ctrl+-", _("Zoom out")),
        (canvas, "Ctrl+0", _("Fit the picture")),
        (canvas, "Ctrl+1", _("Show one cell per pixel of the screen")),
        (canvas, "Ctrl+Shift+C", _("Copy the picture")),
        (canvas, "Delete", _("Remove what is selected")),
        (canvas, "Esc", _("Stop drawing, or deselect")),
        (view, "Left, Right, Up, Down", _("Move the window or the viewport; with Shift farther")),
        (view, "Alt+Left, Alt+Right, Alt+Up, Alt+Down", _("Make it larger or smaller")),
        (view, "V, W, K, P, H", _("Select, draw a window, a clip window, send a point, pan")),
        (space, "1, 3, 7", _("Look from the front, the right, the top; with Ctrl from the opposite side")),
        (space, "5", _("Switch between perspective and parallel projection")),
        (space, "Shift+Left, Shift+Right, Shift+Up, Shift+Down", _("Turn by 5 degrees; with Ctrl, pan")),
        (space, "+, -", _("Zoom in, out")),
        (space, "Shift+N, N", _("Name this view; go to the next named view")),
        (curves, "P", _("Pen; at the end of an open curve it continues that curve")),
        (curves, "F", _("Draw freehand, and fit a curve")),
        (curves, "M", _("Nearest point of the curve")),
        (curves, "Backspace", _("Remove the last point of the pen")),
        (curves, "Ctrl", _("Held while dragging: along eight directions only")),
        (curves, "Shift", _("Held while clicking: choose several points")),
        (curves, "Insert", _("Insert a point at u; so does a double click on the curve")),
        (curves, "X, J", _("Split at u; join two curves")),
        (curves, "], [", _("Raise, lower the degree")),
        (curves, "Shift+C, Shift+S, Shift+Y", _("Make the joint a corner, smooth, symmetric")),
        (curves, "Shift+O, Shift+R", _("Close or open; reverse the direction")),
        (curves, "U, K, N", _("Construction at u; curvature comb; snap to pixels")),
        *timeline_keys(),
    )
