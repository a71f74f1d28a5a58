"""The rows of the Export menu in the table of commands."""

from workbench.language import _
from workbench.shell.actions import Command
from workbench.shell.scene_exports import export_mesh, export_scene_picture, export_wireframe


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
        Command(
            "export_scene",
            _("Export the scene as PNG..."),
            export_scene_picture,
            (),
            "cube",
            _("The scene of Space as it is seen now, 1280 by 960 pixels"),
            "export",
            "document",
            separated=True,
        ),
        Command(
            "export_wireframe",
            _("Export the edges of the scene as SVG..."),
            export_wireframe,
            (),
            "line-segments",
            _("Every edge of the scene as it is seen now, as lines"),
            "export",
            "document",
        ),
        Command(
            "export_mesh",
            _("Export the mesh..."),
            export_mesh,
            (),
            "polygon",
            _("The chosen object, or all of the scene, as OBJ, PLY or STL"),
            "export",
            "document",
        ),
    )
