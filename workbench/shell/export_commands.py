"""The rows of the Export menu in the table of commands."""

from workbench.language import _
from workbench.shell.actions import Command


def export_commands() -> tuple[Command, ...]:
    """What File, Export offers, in order."""
    return (
        Command(
            "export_picture",
            _("Export the picture as PNG..."),
            lambda w: w.files.exports.picture(),
            (),
            "image-square",
            _("Every pixel of the sheet, large enough to be seen"),
            "export",
            "document",
        ),
        Command(
            "export_drawing",
            _("Export the figures as SVG..."),
            lambda w: w.files.exports.drawing(),
            (),
            "line-segments",
            _("Exact lines and curves for other drawing programs"),
            "export",
            "document",
        ),
        Command(
            "export_step",
            _("Export this step..."),
            lambda w: w.files.exports.step(),
            (),
            "camera",
            _("What the canvas shows, with its sentence, as PNG, SVG or PDF"),
            "export",
            "document",
            separated=True,
        ),
        Command(
            "export_run",
            _("Export this run..."),
            lambda w: w.files.exports.run(),
            (),
            "files",
            _("Every step as a PNG, as a page of a PDF, or in a GIF that moves"),
            "export",
            "document",
        ),
        Command(
            "export_derivation",
            _("Export the derivation..."),
            lambda w: w.files.exports.derivation(),
            (),
            "article",
            _("A labelled drawing and its matrices, with symbols and numbers, as SVG or PDF"),
            "export",
            "document",
        ),
        Command(
            "export_hand",
            _("Export the hand table..."),
            lambda w: w.files.exports.hand_table(),
            (),
            "table",
            _("A row for each step, as CSV, JSON or HTML"),
            "export",
            "document",
            separated=True,
        ),
        Command(
            "export_points",
            _("Export the points of the curve..."),
            lambda w: w.files.exports.points(),
            (),
            "dots-three",
            _("The chosen points, or all, as a list that can be imported again"),
            "export",
            "document",
        ),
    )
