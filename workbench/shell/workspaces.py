"""The workspaces, in the order of the course: each an arrangement of panels over one session."""

from collections.abc import Mapping, Sequence
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from workbench.language import _

if TYPE_CHECKING:
    from workbench.panels.animate.panel import AnimatePanel
    from workbench.panels.clip.panel import ClipPanel
    from workbench.panels.curves.panel import CurvesPanel
    from workbench.panels.display.panel import DisplayPanel
    from workbench.panels.draw.panel import DrawPanel
    from workbench.panels.fill.panel import FillPanel
    from workbench.panels.panel import Panel
    from workbench.panels.shared.compare import ComparePanel
    from workbench.panels.shared.inspector import InspectorPanel
    from workbench.panels.shared.tube_dock import TubePanel
    from workbench.panels.shared.why import WhyPanel
    from workbench.panels.space.panel import SpacePanel
    from workbench.panels.stage.workspace_page import PageRow
    from workbench.panels.transform.panel import TransformPanel
    from workbench.panels.viewing.panel import ViewingPanel

    # Every panel there is conforms.
    PANELS: tuple[type[Panel], ...] = (
        AnimatePanel,
        ClipPanel,
        ComparePanel,
        CurvesPanel,
        DisplayPanel,
        DrawPanel,
        FillPanel,
        InspectorPanel,
        SpacePanel,
        TransformPanel,
        TubePanel,
        ViewingPanel,
        WhyPanel,
    )

P = TypeVar("P")


class Workspace(NamedTuple):
    """One workspace. ``panels`` are "module:class", the first of which fills the middle; they are made when
    the workspace is first shown. ``steps`` tells whether the step bar belongs to it, ``topics`` which
    algorithms it is about, ``lower`` which docks begin in the lower group of the side column. ``pages`` are
    those of its pages that have a run of their own, by the name of that run; ``switch`` is the "module:table"
    of the rows of its switch, if it has one.
    """

    slug: str
    title: str
    tooltip: str
    icon: str
    panels: tuple[str, ...]
    steps: bool = False
    topics: tuple[str, ...] = ()
    lower: tuple[str, ...] = ()
    pages: Mapping[str, str] = {}
    switch: str = ""

    @property
    def modules(self) -> tuple[str, ...]:
        """The modules that its panels come from."""
        return tuple(panel.partition(":")[0] for panel in self.panels)

    def rows(self) -> "Sequence[PageRow]":
        """Those of its switch, in order."""
        return _named(self.switch)() if self.switch else ()


def panel_class(panel: str) -> "type[Panel]":
    """The class behind "module:class"."""
    kind: type[Panel] = _named(panel)
    return kind


def _named(what: str) -> Any:
    module, __, name = what.partition(":")
    return getattr(import_module(module), name)


def join(panels: "Sequence[Panel]") -> None:
    """Let the panel in the middle of a workspace point at the pixels that the others name, open the example
    that they are asked for, and say whether their buttons step.
    """
    stepping = panels[0].stepping
    for panel in panels:
        if stepping is not None and panel.step_bar is not None:
            stepping.connect(panel.step_bar.show_buttons)
        if panel.pointing is not None:
            panel.pointing.connect(panels[0].point_at)
        if panel.example_wanted is not None:
            panel.example_wanted.connect(partial(_show_example, panels[0]))


def _show_example(middle: "Panel") -> None:
    # Workspaces share the panels beside the middle: only the one that is seen answers
    if middle.center.isVisible():
        middle.show_example()


def panel_of(panels: "Sequence[Panel]", kind: type[P]) -> P:
    """The panel of this class among those of a workspace. LookupError: it has none."""
    for panel in panels:
        if isinstance(panel, kind):
            return panel
    raise LookupError(f"no {kind.__name__} here")


def _same(*slugs: str) -> Mapping[str, str]:
    """Pages whose runs have their names."""
    return {slug: slug for slug in slugs}


def titles() -> dict[str, str]:
    """What each workspace is called, by its slug."""
    return {each.slug: each.title for each in workspaces()}


def workspaces() -> tuple[Workspace, ...]:
    """Those that exist."""
    inspector = "workbench.panels.shared.inspector:InspectorPanel"
    why = "workbench.panels.shared.why:WhyPanel"
    compare = "workbench.panels.shared.compare:ComparePanel"
    tube = "workbench.panels.shared.tube_dock:TubePanel"
    return (
        Workspace(
            "draw",
            _("Draw"),
            _("Lines, circles and ellipses, pixel by pixel"),
            "pencil-line",
            ("workbench.panels.draw.panel:DrawPanel", inspector, compare, why, tube),
            steps=True,
            topics=("lines", "circles"),
            lower=("tube", "compare", "distance"),
        ),
        Workspace(
            "fill",
            _("Fill"),
            _("Polygons by scan lines, areas from a seed, inside and outside"),
            "paint-bucket",
            ("workbench.panels.fill.panel:FillPanel", inspector, compare, why, tube),
            steps=True,
            topics=("polygons", "seed_fill"),
            lower=("tube", "compare", "depth"),
        ),
        Workspace(
            "clip",
            _("Clip"),
            _("What a window keeps of lines, polygons and points"),
            "crop",
            ("workbench.panels.clip.panel:ClipPanel", inspector, compare, why, tube),
            steps=True,
            topics=("clipping", "lines", "polygons"),
            lower=("compare", "tube"),
        ),
        Workspace(
            "transform",
            _("Transform"),
            _("Figures moved, turned, scaled, mirrored and sheared, and the matrices that do it"),
            "arrows-clockwise",
            ("workbench.panels.transform.panel:TransformPanel", inspector, tube),
            steps=True,
            topics=("transforms",),
            lower=("hand_table", "source", "about", "whole", "tube"),
            pages={"transform": "plane", "transform_space": "space"},
            switch="workbench.panels.transform.chain_pages:pages",
        ),
        Workspace(
            "view",
            _("View"),
            _("A window onto the world, and the viewport on the device that shows it"),
            "browsers",
            ("workbench.panels.viewing.panel:ViewingPanel", inspector, tube),
            steps=True,
            topics=("viewing", "clipping"),
            lower=("hand_table", "point", "source", "variables", "about", "tube"),
        ),
        Workspace(
            "curves",
            _("Curves"),
            _("Bézier curves, B-splines and splines through points, with their constructions"),
            "line-segments",
            ("workbench.panels.curves.panel:CurvesPanel", inspector, compare, why, tube),
            steps=True,
            topics=("curves", "lines"),
            lower=("basis", "insight", "kinds", "continuity", "curvature", "hodograph", "tube"),
        ),
        Workspace(
            "space",
            _("Space"),
            _("A scene in three dimensions: projections, their matrices, and what the eye sees"),
            "cube",
            ("workbench.panels.space.panel:SpacePanel", inspector),
            steps=True,
            topics=("projection", "visibility", "shading", "solids"),
            lower=("hand_table", "fragments", "depth_cost", "growth", "variables"),
            pages=_same("space", "visibility", "shading", "arena"),
            switch="workbench.panels.space.page:pages",
        ),
        Workspace(
            "animate",
            _("Animate"),
            _("Key frames, the frames between them, and how they get their speed"),
            "film-strip",
            ("workbench.panels.animate.panel:AnimatePanel", inspector, tube),
            steps=True,
            topics=("animation", "visibility"),
            lower=("hand_table", "source", "variables", "about", "tube"),
        ),
        Workspace(
            "display",
            _("Display"),
            _("Cathode-ray tubes: what the beam does, raster and random scan, and what the eye sees of it"),
            "monitor",
            ("workbench.panels.display.panel:DisplayPanel", inspector),
            steps=True,
            topics=("scanning", "colour", "visibility"),
            lower=("hand_table", "variables", "about"),
            pages=_same("display", "gun", "raster", "vector", "comparison", "flicker", "colour"),
            switch="workbench.panels.display.page:pages",
        ),
    )
