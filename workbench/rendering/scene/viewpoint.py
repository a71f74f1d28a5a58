"""From the world to the device: camera, window, viewport, and where the viewer is."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.viewing import window_to_viewport
from workbench.algorithms.visibility.whole_scene import places_on_device
from workbench.document.model import Rectangle, whole_sheet
from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array, Index
from workbench.language import _
from workbench.rendering.limits import REACH_PX
from workbench.rendering.scene.volume import DEPTH_PLANES, LEAST_W, clip_triangles, side_planes
from workbench.rendering.triangles import written_in_shares

_MARGIN = 0.05
_MOST_SIDE_PX = 1 << 14
_AT_ONCE = 1 << 16  # triangles: what is worked out on the way takes little memory

Size = tuple[int, int]


class Drawn(NamedTuple):
    """Device triangles: corners (n, 3), x and y in pixels on a grid of 1/4096, z 0 to 1; triangles (t, 3);
    and for each (t,) the number of the triangle that it is a part of, None where none was cut or left out."""

    corners: Array
    triangles: Index
    owners: Index | None

    def of_owners(self, rows: NDArray[Any]) -> NDArray[Any]:
        """The rows (m, ...) of the triangles that were to be drawn, for those that are: (t, ...)."""
        return rows if self.owners is None else rows[self.owners]


class Viewpoint(NamedTuple):
    """``matrix`` (4, 4) from the world to the view plane, x, y and depth to be divided by w; the window that
    is seen of the view plane; the size of the picture."""

    matrix: Array
    window: Rectangle
    size: Size

    @classmethod
    def of(cls, camera: Camera, size: Size, window: Rectangle | None, points_world: Array) -> "Viewpoint":
        """Where ``camera`` sees from; without a window all points (n, 3) fit in. Raises: ValueError."""
        refuse_size(size)
        matrix = projection_matrix(camera) @ view_matrix(camera)
        return cls(matrix, window or _around(matrix, points_world, size), size)

    @property
    def viewer(self) -> Array:
        """The centre of projection in the world, (x, y, z, 1), or where parallel projectors come from,
        (x, y, z, 0)."""
        x, y, z, w = self.matrix
        rows = np.stack([x, y, w])
        minors = [(-1) ** k * np.linalg.det(np.delete(rows, k, axis=1)) for k in range(4)]
        place = np.array(minors)
        if abs(place[3]) > 1e-12 * np.abs(place).max():
            place /= place[3]
            return place
        place[3] = 0.0
        return -place if z @ place > 0 else place

    @property
    def device(self) -> Array:
        """From the view plane to pixels (3, 3)."""
        return window_to_viewport(_sides(self.window), _sides(whole_sheet(*self.size)), True)

    def homogeneous(self, points_world: Array) -> Array:
        """Points (n, 3) on the view plane, as (x, y, z, w) before the division."""
        placed: Array = points_world @ self.matrix[:, :3].T
        placed += self.matrix[:, 3]
        return placed

    def drawn(self, points_world: Array, triangles: Index, around: Array) -> Drawn:
        """What of the triangles lies before the camera, on the device.

        ``around`` (k, 3): the corners of something convex that all points lie in. Where it is before the
        camera as a whole, ``triangles`` are themselves those that are drawn.
        """
        box, planes = self.homogeneous(around), np.concatenate([DEPTH_PLANES, self._reach()])
        if not ((box @ planes.T < 0).any() or (box[:, 3] <= LEAST_W).any()):
            corners = self._on_device(points_world, self.matrix)
            return Drawn(corners, triangles, None)
        points, parts, owners = _clipped(self.homogeneous(points_world), triangles, planes)
        used = np.zeros(len(points), bool)
        used[parts.ravel()] = True
        number = np.cumsum(used) - 1
        for first in range(0, len(parts), _AT_ONCE):
            parts[first : first + _AT_ONCE] = number[parts[first : first + _AT_ONCE]]
        return Drawn(self._on_device(points[used], np.eye(4)), parts, owners)

    def _on_device(self, points: Array, matrix: Array) -> Array:
        """Points (n, 3), or (n, 4) with their w, as ``Drawn`` has its corners, once ``matrix`` is applied."""
        places, device = np.empty((len(points), 3)), self.device
        scales = *device[0, [0, 2]].tolist(), *device[1, [1, 2]].tolist()

        def share(first: int, end: int) -> tuple[Any, ...]:
            return places[first:end], points[first:end], matrix, *scales

        written_in_shares(len(points), places_on_device, share)
        return places

    def _reach(self) -> Array:
        """The planes beyond which nothing is drawn: far outside of the picture, so that few are cut there."""
        xmin, ymin, xmax, ymax = _sides(self.window)
        per_pixel = max((xmax - xmin) / self.size[0], (ymax - ymin) / self.size[1])
        beyond = REACH_PX * per_pixel
        return side_planes(xmin - beyond, ymin - beyond, xmax + beyond, ymax + beyond)


def _clipped(points: Array, triangles: Index, planes: Array) -> tuple[Array, Index, Index]:
    """As ``clip_triangles``, without what is too near the eye; as each plane copies all that is given to be
    clipped, only what a plane may cut is."""
    outside = [points @ plane < 0 for plane in planes]
    too_near = points[:, 3] <= LEAST_W
    asked, gone = np.empty(len(triangles), bool), np.zeros(len(triangles), bool)
    for first in range(0, len(triangles), _AT_ONCE):
        share = slice(first, first + _AT_ONCE)
        asked[share] = too_near[triangles[share]].any(axis=1)
        for beyond in outside:
            corners = beyond[triangles[share]]
            asked[share] |= corners.any(axis=1)
            gone[share] |= corners.all(axis=1)
    asked &= ~gone
    points, cut, cut_owners = clip_triangles(points, triangles[asked], planes)
    good = (points[:, 3] > LEAST_W)[cut].all(axis=1)
    counts = np.where(gone, 0, 1)
    counts[asked] = np.bincount(cut_owners[good], minlength=int(asked.sum()))
    owners = np.repeat(np.arange(len(triangles)), counts)
    parts = triangles[owners]
    parts[asked[owners]] = cut[good]  # both in the order of the triangles
    return points, parts, owners


def refuse_size(size: Size) -> None:
    """Raises: ValueError, a sentence, where no picture can be so large."""
    width, height = size
    if not (1 <= width <= _MOST_SIDE_PX and 1 <= height <= _MOST_SIDE_PX):
        sentence = _("A picture of {width} x {height} pixels cannot be drawn; give sides from 1 to {most}.")
        raise ValueError(sentence.format(width=width, height=height, most=_MOST_SIDE_PX))


def _around(matrix: Array, points_world: Array, size: Size) -> Rectangle:
    """The window that shows all points before the camera; a small one where none is."""
    placed = points_world @ matrix[:, :3].T + matrix[:, 3]
    w = placed[:, 3]
    before = (w > LEAST_W) & (placed[:, 2] >= 0) & (placed[:, 2] <= w)
    flat = placed[before, :2] / w[before, None]
    if not len(flat):
        return Rectangle(-1.0, -1.0, 1.0, 1.0)
    return window_around(flat, size)


def window_around(flat: Array, size: Size) -> Rectangle:
    """A window in the proportions of a picture that shows points (n, 2) of the view plane, and a margin."""
    low, high = flat.min(axis=0), flat.max(axis=0)
    middle = (low + high) / 2
    width, height = size
    per_pixel = max(float((high - low)[0]) / width, float((high - low)[1]) / height, 1e-9) * (1 + 2 * _MARGIN)
    (x, y), half_x, half_y = middle.tolist(), per_pixel * width / 2, per_pixel * height / 2
    return Rectangle(x - half_x, y - half_y, x + half_x, y + half_y)


def _sides(rectangle: Rectangle) -> tuple[float, float, float, float]:
    return rectangle.xmin, rectangle.ymin, rectangle.xmax, rectangle.ymax
