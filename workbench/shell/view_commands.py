"""The commands of the menu View: where one is, and how it looks."""

from functools import partial
from typing import TYPE_CHECKING

from workbench.language import _
from workbench.shell.actions import Command
from workbench.shell.theme import choose_theme, choose_type

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


def _on_canvas(name: str, window: "MainWindow") -> None:
    """Let the middle of the workspace zoom, if it can."""
    for panel in window.panels(window.place)[:1]:
        for action in panel.actions():
            if action.objectName().endswith(f".{name}") and action.isEnabled():
                action.trigger()
                return
    window.say_status(_("There is nothing here to zoom; go to a workspace with a canvas."))


def view_commands() -> tuple[Command, ...]:
    """Home and the list of commands, theme and type, zoom, and what stands beside what."""
    return (
        Command(
            "home",
            _("Home"),
            lambda w: w.show_page("home"),
            ("Ctrl+H",),
            "house",
            _("Recent pictures, examples and questions"),
            "view",
        ),
        Command(
            "palette",
            _("Find a command..."),
            lambda w: w.show_palette(),
            ("Ctrl+K",),
            "magnifying-glass",
            _("Type a few letters of any command"),
            "view",
        ),
        Command(
            "light_theme",
            _("Light theme"),
            lambda w: choose_theme(w, "light"),
            (),
            "sun",
            _("Dark text on a light background"),
            "view",
            separated=True,
        ),
        Command(
            "dark_theme",
            _("Dark theme"),
            lambda w: choose_theme(w, "dark"),
            (),
            "moon",
            _("Light text on a dark background"),
            "view",
        ),
        Command(
            "larger_type",
            _("Larger type"),
            lambda w: choose_type(w, not w.settings.get("large_text")),
            (),
            "text-aa",
            _("All text a quarter larger, or as before"),
            "view",
        ),
        Command(
            "zoom_in",
            _("Zoom in"),
            partial(_on_canvas, "zoom_in"),
            (),
            "magnifying-glass-plus",
            _("Show the picture larger, as the wheel does"),
            "view",
            "document",
            separated=True,
            focused_key="Ctrl++",
        ),
        Command(
            "zoom_out",
            _("Zoom out"),
            partial(_on_canvas, "zoom_out"),
            (),
            "magnifying-glass-minus",
            _("Show the picture smaller"),
            "view",
            "document",
            focused_key="Ctrl+-",
        ),
        Command(
            "fit",
            _("Fit the picture"),
            partial(_on_canvas, "fit"),
            (),
            "frame-corners",
            _("Show the whole picture, as large as there is room"),
            "view",
            "document",
            focused_key="Ctrl+0",
        ),
        Command(
            "swap",
            _("Swap canvas and tube"),
            lambda w: w.views.swap(),
            ("T",),
            "swap",
            _("Show the tube large and the canvas small, or back"),
            "view",
            "document",
            separated=True,
        ),
        Command(
            "read",
            _("Read"),
            lambda w: w.views.read(),
            ("R",),
            "book-open",
            _("Give source and tables half of the window, side by side, or bring the docks back"),
            "view",
            "document",
        ),
        Command(
            "alone",
            _("Focused view alone"),
            lambda w: w.views.toggle_alone(),
            ("F11",),
            "corners-out",
            _("Show only the view that has the focus; the same key brings the rest back"),
            "view",
        ),
        Command(
            "reset",
            _("Reset workspace"),
            lambda w: w.reset_workspace(),
            (),
            "layout",
            _("Put every dock, and every line between panes, back where it was originally"),
            "view",
        ),
    )
