"""The projection of a scene as a page: its picture, the similar triangles, the matrices, a vertex on its way.

All lengths are in view coordinates: x right, y up, z into the picture, the eye at the origin.
"""

from typing import NamedTuple

import numpy as np

from workbench.algorithms.marks import Ray, Spot, Stroke, Word
from workbench.algorithms.projection import classify, perspective, vanishing_points
from workbench.document.scene.model import Camera, Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.exchange.diagrams import Arrow, Block, Derivation, Drawing, Formulas, Heading, Item, Sentence
from workbench.exchange.formulas.terms import Sign, displayed, matrix
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.contrast_dock import title_of
from workbench.panels.space.eye_view import AXES
from workbench.panels.space.stepped import Vertex
from workbench.rendering.scene.contrast import contrast
from workbench.rendering.scene.edge_picture import edge_picture
from workbench.rendering.scene.viewpoint import Viewpoint, window_around
from workbench.rendering.scene.wireframe import wireframe
from workbench.widgets.formulas.paper import paper_inks

_SIZE = 900, 600
_SEEN_HEIGHT_PT, _TRIANGLES_HEIGHT_PT = 230.0, 150.0
_WIDE, _ROOM = 2.6, 0.12
_COURSE = (("1", "0", "0", "0"), ("0", "1", "0", "0"), ("0", "0", "1", "0"), ("0", "0", "1/d", "0"))


class InView(NamedTuple):
    """A point in view coordinates, and what it is called."""

    x: float
    y: float
    z: float
    name: str = "P"

    @property
    def aside(self) -> str:
        """The one of "x" and "y" that is farther from the line of sight."""
        return "x" if abs(self.x) >= abs(self.y) else "y"


def in_view(camera: Camera, vertex: Vertex | None) -> InView | None:
    """A vertex in view coordinates. Raises: ValueError where the camera sees nothing."""
    if vertex is None:
        return None
    x, y, z, _w = (view_matrix(camera) @ [*vertex.place, 1.0]).tolist()
    return InView(x, y, z, f"R_{vertex.number}")


def derivation(scene: Scene, vertex: Vertex | None) -> Derivation | None:
    """The page of a scene as it is seen; None where nothing of it is. Raises: ValueError."""
    camera = scene.camera
    if not len(wireframe(scene)):
        return None
    view, plane = view_matrix(camera), projection_matrix(camera)
    title, point = title_of(camera), in_view(camera, vertex)
    eye, at = (", ".join(map(displayed, place.xyz)) for place in (camera.eye, camera.look_at))
    blocks: list[Block] = [
        Heading(title),
        _picture(scene, vertex),
        Sentence(_("Seen from $e = ({eye})$ towards $a = ({at})$.").format(eye=eye, at=at)),
        Sentence(classify(plane @ view, view).words),
    ]
    if camera.projection == "perspective":
        blocks += _central(camera, point)
    blocks.append(
        Formulas(
            (
                matrix(plane @ view, name="M"),
                Sign("="),
                matrix(plane, name="P"),
                Sign("·"),
                matrix(view, name="V"),
            )
        )
    )
    if point is not None:
        blocks += [Sentence(f"{stage}: {line}") for stage, line in way(camera, point)]
    return Derivation(title, [*blocks, *_compared(scene)], paper_inks())


# The picture


def _picture(scene: Scene, vertex: Vertex | None) -> Drawing:
    """The edges that are seen, those hidden dotted, with vanishing points and what runs together there."""
    camera = scene.camera
    flat = wireframe(scene).reshape(-1, 2)
    points = vanishing_points(projection_matrix(camera) @ view_matrix(camera))
    there = [point for point in points if point is not None]
    whole = np.concatenate([flat, there]) if there else flat
    if (np.ptp(whole, axis=0) > 3.5 * np.ptp(flat, axis=0).max()).any():
        whole = flat
    window = window_around(whole, _SIZE)
    picture = edge_picture(scene, _SIZE, window)
    viewpoint = Viewpoint.of(camera, _SIZE, window, np.zeros((0, 3)))
    items: list[Item] = [_segment(row, "muted", "dot") for row in picture.hidden.tolist()]
    items += [_segment(row, "text", "solid") for row in picture.seen.tolist()]
    device = viewpoint.device
    for axis, point in enumerate(points):
        if point is None:
            continue
        x, y = (point[k] * device[k, k] + device[k, 2] for k in (0, 1))
        if 0 <= x <= _SIZE[0] and 0 <= y <= _SIZE[1]:
            ink = ("data2", "data4", "data3")[axis]
            for corner in _outermost(picture.seen, np.array([x, y])):
                items.append(Stroke(np.array([corner, (x, y)]), ink, "hair", "dash"))  # type: ignore[arg-type]
            items += [
                Spot(x, y, ink, "square"),  # type: ignore[arg-type]
                Word(f"VP_{AXES[axis]} ({displayed(point[0])}, {displayed(point[1])})", x, y, "text", 0, -1),
            ]
    if vertex is not None:
        x, y, _z, w = viewpoint.homogeneous(np.array([vertex.place]))[0]
        if w > 0:
            place = x / w * device[0, 0] + device[0, 2], y / w * device[1, 1] + device[1, 2]
            items += [Spot(*place, "accent", "ring"), Word(f"R_{vertex.number}'", *place, "text", 1, 1)]
    return Drawing((0.0, 0.0, float(_SIZE[0]), float(_SIZE[1])), items, _SEEN_HEIGHT_PT)


def _segment(row: list[float], ink: str, pattern: str) -> Stroke:
    weight = "thin" if pattern == "solid" else "hair"
    return Stroke(np.array(row).reshape(2, 2), ink, weight, pattern)  # type: ignore[arg-type]


def _outermost(segments: Array, at: Array) -> Array:
    """The two ends between whose lines to ``at`` all others lie."""
    ends = segments.reshape(-1, 2)
    way_ = ends - at
    middle = way_.mean(axis=0)
    turns = np.arctan2(middle[0] * way_[:, 1] - middle[1] * way_[:, 0], way_ @ middle)
    return ends[[int(turns.argmin()), int(turns.argmax())]]


# Similar triangles


def similar_triangles(
    d: float, point: InView, aspect: float, height: float = _TRIANGLES_HEIGHT_PT, axis: str = ""
) -> Drawing:
    """Seen from above or from the side, whichever shows more: the eye at the origin, z to the right, x or y
    up, or the one that ``axis`` names; the plane at ``d``, a point, its image. ``aspect``: width to height.
    """
    axis = axis or point.aside
    x, z = getattr(point, axis), point.z
    right = max(z, d, 1e-9) * (1 + 2 * _ROOM)
    half = max(abs(x), 1e-3 * right) * (1 + 4 * _ROOM)
    half = max(half, abs(x * d / z) * (1 + 4 * _ROOM) if z > 0 else 0.0)
    left = -_ROOM * right
    if (right - left) < 2 * half * aspect:
        right = left + 2 * half * aspect
    half = (right - left) / (2 * aspect)
    items: list[Item] = [
        Arrow(np.array([(left, 0.0), (right, 0.0)]), "muted"),
        Word("z", right, 0.0, "muted", -1, -1),
        Stroke(np.array([(d, -half), (d, half)]), "accent", "medium"),
        Word(_("plane"), d, half, "accent", 1, -1),
        Spot(0.0, 0.0, "text", "ring", "large"),
        Word(_("eye"), 0.0, 0.0, "text", 0, -1),
    ]
    if z > 0:
        image = x * d / z
        items += [
            Stroke(np.array([(0.0, 0.0), (z, x)]), "accent", "thin"),
            Stroke(np.array([(z, 0.0), (z, x)]), "data2", "medium"),
            Stroke(np.array([(d, 0.0), (d, image)]), "data3", "bold"),
            Spot(d, image, "data3"),
            Spot(z, x, "data2", "square"),
            Word(f"{axis}_p", d, image / 2, "data3", -1, 0),
            Word(axis, z, x / 2, "data2", 1, 0),
            Word(point.name, z, x, "text", 1, 1 if x >= 0 else -1),
            Word("d", d / 2, 0.0, "muted", 0, -1),
        ]
    else:
        items += [Ray(0.0, 0.0, z, x, "error", "thin", "dot"), Spot(z, x, "error", "cross")]
    return Drawing((left, -half, right, half), items, height)


def similar_lines(d: float, point: InView) -> list[str]:
    """The derivation as an exam answer has it, each line a sentence with formulas between dollar signs."""
    x, y, z = map(displayed, point[:3])
    shown_d = displayed(d)
    lines = [
        _("Similar triangles: $x_p / d = x / z$, so $x_p = x · d / z = x / (z/d)$, and $y_p = y / (z/d)$."),
        _("Dividing by $z/d$ is what $w = z/d$ in the last row does: $(x, y, z, w) → (x/w, y/w, z/w)$."),
    ]
    if not point.z > 0:
        lines.append(
            _(
                "$w = {z} / {d}$ is not positive: there is no image, since the point is not in "
                "front of the eye."
            ).format(z=z, d=shown_d)
        )
        return lines
    w = point.z / d
    lines.append(
        _(
            "$w = {z} / {d} = {w}$, $x_p = {x} / {w} = {xp}$, $y_p = {y} / {w} = {yp}$, $z_p = d = {d}$."
        ).format(
            x=x, y=y, z=z, d=shown_d, w=displayed(w), xp=displayed(point.x / w), yp=displayed(point.y / w)
        )
    )
    return lines


def limit_lines(d: float, point: InView) -> list[str]:
    """What becomes of w as the centre goes to infinity: with the plane at z = 0, and as the paper has it."""
    return [
        _(
            "Plane at $z = 0$, centre at $z = -d$: $w = 1 + z/d$ tends to 1, and the limit is the "
            "parallel projection."
        ),
        _(
            "Centre at the origin, plane at $z = d$: $w = z/d = {w}$ tends to 0, and the limit divides "
            "by zero."
        ).format(w=displayed(point.z / d)),
    ]


def _central(camera: Camera, point: InView | None) -> list[Block]:
    d = camera.distance
    point = point or InView(1.0, 1.0, 2 * d)
    column = ((point.x, "x"), (point.y, "y"), (point.z, "z"), (1.0, "1"))
    result = (*column[:3], (point.z / d, "z/d"))
    before, after = (
        matrix([[value] for value, _symbol in each], [[symbol] for _value, symbol in each])
        for each in (column, result)
    )
    course = matrix(perspective(d), _COURSE, name="P(d)")
    return [
        Heading(_("By similar triangles")),
        similar_triangles(d, point, _WIDE),
        *map(Sentence, similar_lines(d, point)),
        Formulas((after, Sign("="), course, Sign("·"), before), "symbols"),
        *map(Sentence, limit_lines(d, point)),
        Sentence(
            _("For hidden surfaces row 3 keeps depth instead, from 0 at the near plane to 1 at the far one:")
        ),
    ]


def way(camera: Camera, point: InView) -> list[tuple[str, str]]:
    """The stages of a point and its arithmetic, in formulas."""
    plane = projection_matrix(camera)
    x, y, z, w = (plane @ [*point[:3], 1.0]).tolist()
    rows = [(_("View"), f"${point.name} = ({', '.join(map(displayed, point[:3]))})$")]
    rows.append((_("Projection"), f"$({', '.join(map(displayed, (x, y, z, w)))})$"))
    if w > 0:
        there = ", ".join(displayed(value / w) for value in (x, y, z))
        rows.append((_("Divided by w"), f"$({there})$"))
    return rows


# Compared


def _compared(scene: Scene) -> list[Block]:
    both = contrast(scene)
    if both is None:
        return []
    blocks: list[Block] = [Heading(_("Parallel and perspective, measured on this scene"))]
    for row in both.rows:
        said = _("{feature}. Parallel: {parallel}. Perspective: {perspective}.").format(
            feature=row.feature, parallel=row.parallel, perspective=row.perspective
        )
        blocks.append(Sentence(f"{said} {row.but}".strip()))
    return blocks
