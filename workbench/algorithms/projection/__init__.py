"""From space to the plane: parallel and perspective projections, and the views before them."""

from workbench.algorithms.projection.axonometric import axonometric, dimetric, isometric, trimetric
from workbench.algorithms.projection.classification import Classification, classify
from workbench.algorithms.projection.clip_to_view_volume import clip_to_view_volume
from workbench.algorithms.projection.parallel import cabinet, cavalier, oblique, orthographic, parallel_depth
from workbench.algorithms.projection.perspective import perspective, perspective_depth, perspective_from_plane
from workbench.algorithms.projection.project_point import project_point
from workbench.algorithms.projection.vanishing import (
    distance_of,
    vanishing_points,
    with_vanishing_point,
    with_vanishing_points,
)
from workbench.algorithms.projection.view import (
    STANDARD_VIEWS,
    perspective_placement,
    standard_view,
    view,
    view_from_plane,
)

__all__ = [
    "STANDARD_VIEWS",
    "Classification",
    "axonometric",
    "cabinet",
    "cavalier",
    "classify",
    "clip_to_view_volume",
    "dimetric",
    "distance_of",
    "isometric",
    "oblique",
    "orthographic",
    "parallel_depth",
    "perspective",
    "perspective_depth",
    "perspective_from_plane",
    "perspective_placement",
    "project_point",
    "standard_view",
    "trimetric",
    "vanishing_points",
    "view",
    "view_from_plane",
    "with_vanishing_point",
    "with_vanishing_points",
]
