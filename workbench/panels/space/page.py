"""The pages of Space.

The scene as it is seen, with the camera of whoever looks around, is ``seen_scene(session.state,
session.sheet)``.
"""

from workbench.language import _
from workbench.panels.stage.workspace_page import PageRow


def pages() -> tuple[PageRow, ...]:
    """In the order of the switch."""
    return (
        PageRow(
            "space",
            _("Projection"),
            _("How the scene gets into the picture: projections, their matrices, vanishing points"),
            "workbench.panels.space.projection_page:ProjectionPage",
        ),
        PageRow(
            "visibility",
            _("Visibility"),
            _("Which surface is seen: a method for hidden surfaces, step by step"),
            "workbench.panels.space.visibility.page:VisibilityPage",
        ),
        PageRow(
            "shading",
            _("Shading"),
            _("How a scene is lit: flat, Gouraud, Phong and fast Phong shading, lights and materials"),
            "workbench.panels.space.shading.page:ShadingPage",
        ),
        PageRow(
            "arena",
            _("Hidden surfaces"),
            _("Every method for hidden surfaces on one scene: what each shows, where it errs, what it costs"),
            "workbench.panels.space.arena.page:ArenaPage",
        ),
    )
