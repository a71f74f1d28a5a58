"""A scene as a line drawing: its edges without what faces hide, for vector tubes and for SVG."""

from functools import lru_cache

import numpy as np
from msgspec.structs import replace

from workbench.algorithms.visibility import hidden_lines
from workbench.document.model import Rectangle, Sheet, View
from workbench.document.scene.model import Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.engine.at_hand import at_hand
from workbench.geometry.meshes import Array, Index
from workbench.language import _
from workbench.rendering.mapping import box, view_map
from workbench.rendering.scene.edge_picture import EdgePicture
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Size, Viewpoint, window_around
from workbench.rendering.scene.volume import DEPTH_PLANES, LEAST_W, clip_segments, clip_triangles
from workbench.rendering.segments import Segments, cut

MOST_PAIRS = 50_000_000
"""Edges times triangles that are compared for a file: half a second."""
MOST_PAIRS_AT_ONCE, MOST_PAIRS_PLAIN = 2_000_000, 4_000
"""The same while a person waits, compiled and not."""


def line_drawing(scene: Scene) -> Segments:
    """What is seen of every edge (n, 4) as (x0, y0, x1, y1), in view-plane coordinates, and of which of the
    visible objects each is (n,).

    Raises: ValueError, a sentence: there are too many edges and faces, or one is malformed.
    """
    vertices, triangles, edges, owners = before_camera(scene)
    pairs = len(triangles) * len(edges)
    if pairs > MOST_PAIRS:
        said = _(
            "The scene has {edges:,} edges and {count:,} triangles, too many to compare each with "
            "every other. Hide "
            "some of its objects, or take the wireframe with all its lines."
        )
        raise ValueError(said.format(edges=len(edges), count=len(triangles)))
    return _drawn(vertices, triangles, edges, owners, compiling=True)


def scene_strokes(sheet: Sheet) -> list[tuple[float, float, float, float, int]]:
    """The line drawing of a sheet's scene on the device: x0, y0, x1, y1 in pixels, and the colour.

    With all lines where leaving out the hidden ones would take too long. None without a scene.
    """
    if sheet.scene is None:
        return []
    return list(_strokes(sheet.scene, sheet.first_view, (sheet.width_px, sheet.height_px)))


def drawn_at_once(scene: Scene) -> Segments | None:
    """The line drawing, or None where it would keep a person waiting. Raises: ValueError."""
    vertices, triangles, edges, owners = before_camera(scene)
    ready = at_hand(hidden_lines, "collect")
    if len(triangles) * len(edges) > (MOST_PAIRS_AT_ONCE if ready else MOST_PAIRS_PLAIN):
        return None
    return _drawn(vertices, triangles, edges, owners, compiling=False)


def line_picture(lines: Segments, scene: Scene, size: Size, window: Rectangle) -> EdgePicture:
    """The line drawing of a scene in pixels as a picture without faces."""
    numbers = np.array([number for number, thing in enumerate(scene.objects) if thing.visible], np.int64)
    device = Viewpoint.of(scene.camera, size, window, np.zeros((0, 3))).device
    scale, start = np.tile(device.diagonal()[:2], 2), np.tile(device[:2, 2], 2)
    seen = lines.table * scale + start
    return EdgePicture(None, seen, numbers[lines.of], np.zeros((0, 4)), np.zeros(0, np.int64))


@lru_cache(maxsize=4)
def _strokes(scene: Scene, view: View, size: Size) -> tuple[tuple[float, float, float, float, int], ...]:
    try:
        lines = drawn_at_once(scene) or _all_edges(scene)
    except ValueError:
        return ()  # said where the scene is shown
    if not len(lines.table):
        return ()
    if view.window_world == view.viewport_device:  # nobody has chosen a window for the scene
        view = replace(view, window_world=window_around(lines.table.reshape(-1, 2), size))
    device = view_map(view).points(lines.table.reshape(-1, 2)).reshape(-1, 4)
    seen = cut(Segments(device, lines.of), box(view.viewport_device))
    materials = {material.id: material.colour for material in scene.materials}
    colours = [materials[thing.material] for thing in scene.objects if thing.visible]
    strokes = zip(seen.table.tolist(), seen.of.tolist(), strict=True)
    return tuple((x0, y0, x1, y1, colours[of]) for (x0, y0, x1, y1), of in strokes)


def _all_edges(scene: Scene) -> Segments:
    vertices, _triangles, edges, owners = before_camera(scene)
    return Segments(vertices[edges][..., :2].reshape(-1, 4), owners)


def _drawn(vertices: Array, triangles: Index, edges: Index, owners: Index, compiling: bool) -> Segments:
    from workbench.engine.compiled import collect

    rows = collect(hidden_lines, vertices, triangles, edges, compiling=compiling).reshape(-1, 5)
    return Segments(rows[:, :4], owners[rows[:, 4].astype(np.int64)])


def before_camera(scene: Scene) -> tuple[Array, Index, Index, Index]:
    """What lies between the near and the far plane: points of the view plane with their depths (n, 3), the
    triangles (t, 3) and the edges (e, 2) over them, and the object of each edge (e,)."""
    matrix = projection_matrix(scene.camera) @ view_matrix(scene.camera)
    points, triangles, edges = [np.zeros((0, 3))], [np.zeros((0, 3), np.int64)], [np.zeros((0, 2), np.int64)]
    owners, count = [np.zeros(0, np.int64)], 0
    for number, (mesh, (cut_up, _faces), _material, lasting) in enumerate(placed(scene)):
        homogeneous = mesh.vertices @ matrix[:, :3].T + matrix[:, 3]
        corners, kept, _of = clip_triangles(homogeneous, cut_up, DEPTH_PLANES)
        begin, end, _of = clip_segments(homogeneous, lasting.edges, DEPTH_PLANES)
        good = (begin[:, 3] > LEAST_W) & (end[:, 3] > LEAST_W)
        begin, end = begin[good], end[good]
        used, kept = np.unique(kept, return_inverse=True)
        both = np.concatenate([corners[used], begin, end])
        points.append(both[:, :3] / both[:, 3:])
        triangles.append(kept.reshape(-1, 3) + count)
        first = count + len(used) + np.arange(len(begin))
        edges.append(np.stack([first, first + len(begin)], axis=1))
        owners.append(np.full(len(begin), number))
        count += len(both)
    return np.concatenate(points), np.concatenate(triangles), np.concatenate(edges), np.concatenate(owners)
