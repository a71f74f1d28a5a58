"""A scene in the light of its lamps: flat, Gouraud, Phong or fast Phong, through the depth buffer."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.shading import gouraud
from workbench.algorithms.shading.illumination import corner_lights
from workbench.algorithms.shading.shadow_boxes import boxed_blockers
from workbench.display.exposure import srgb_encoded
from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.engine.stopping import Stop
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.rendering.gouraud_triangles import LitShare, gouraud_drawn
from workbench.rendering.mapping import Call
from workbench.rendering.scene.corner_light import corner_light
from workbench.rendering.scene.lit_triangles import LitTriangles, blockers_of, lit_shares
from workbench.rendering.scene.render import Picture
from workbench.rendering.scene.viewpoint import Size
from workbench.rendering.triangles import FARTHEST, in_bands

MOST_BLOCKERS = 100_000
"""So many triangles cast shadows at most."""


class Model(NamedTuple):
    """How the model is applied: by N . H in place of V . R, and whether shadows are cast."""

    by_halfway: bool = False
    shadows: bool = False


class Buffers(NamedTuple):
    """The light (h, w) of a picture so far, and the depth there."""

    light: Array
    depth: Array

    @classmethod
    def of(cls, size: Size) -> "Buffers":
        """Those of a new picture."""
        return cls(np.zeros(size[::-1]), np.full(size[::-1], FARTHEST))


def shaded(
    scene: Scene,
    shading: str,
    size: Size,
    window: Rectangle | None = None,
    model: Model = Model(),  # noqa: B008
    stop: Stop | None = None,
) -> Picture:
    """A scene as its camera sees it in its light; as ``render_scene``, coded for the screen.

    Each of red, green and blue is shaded by itself, in linear light. Raises: ValueError, a sentence; Stopped.
    """
    blockers = _boxed(shadow_blockers(scene, model), stop)
    if shading == gouraud.__name__:

        def shares() -> Iterator[LitShare]:
            for lit in lit_shares(scene, size, window):
                lights = [_of_corners(lit, channel, model, blockers, stop) for channel in range(3)]
                yield lit.corners, lit.triangles, np.stack(lights, axis=1)

        return gouraud_drawn(shares, size, stop)
    channels = [Buffers.of(size) for _channel in range(3)]
    for lit in lit_shares(scene, size, window):
        for channel, buffers in enumerate(channels):
            _shade(lit, shading, channel, buffers, model, blockers, stop)
    packed = np.zeros(size[::-1], np.uint32)
    for light, _depth in channels:
        packed = packed << 8 | np.floor(srgb_encoded(light) * 255 + 0.5).astype(np.uint32)
    return packed, channels[0].depth


def shadow_blockers(scene: Scene, model: Model) -> Array:
    """Corners (3 k, 3) of what may take the light away. Raises: ValueError where that is too much."""
    blockers, count = blockers_of(scene, MOST_BLOCKERS) if model.shadows else (np.zeros((0, 3)), 0)
    if count > MOST_BLOCKERS:
        sentence = _(
            "Shadows are cast by up to {most:,} triangles, but there are {count:,}; hide some objects."
        )
        raise ValueError(sentence.format(most=MOST_BLOCKERS, count=count))
    return blockers


def _boxed(blockers: Array, stop: Stop | None) -> Array:
    """Blockers with boxes around them, which take the same light away. Raises: Stopped."""
    from workbench.engine.compiled import collect

    return collect(boxed_blockers, blockers, stop=stop).reshape(-1, 3) if len(blockers) else blockers


def shading_call(
    lit: LitTriangles,
    shading: str,
    buffers: Buffers,
    model: Model,
    blockers: Array,
    channel: int | None = None,
) -> Call:
    """The call that goes on with a picture: red, green or blue, or as if surfaces and lights were white."""
    entry = catalogue.get(shading)
    materials, lights = (lit.materials, lit.lights) if channel is None else lit.in_channel(channel)
    given: dict[str, Any] = {
        "light": buffers.light,
        "vertices": lit.corners,
        "faces": lit.triangles,
        "places": lit.places,
        "normals": lit.normals,
        "materials": materials,
        "eye": lit.eye,
        "lights": lights,
        "by_halfway": model.by_halfway,
        "blockers": blockers,
        "depth": buffers.depth,
    }
    if shading == gouraud.__name__:
        given["intensities"] = _of_corners(lit, channel, model, blockers)
    return Call(entry, tuple(given[name] for name in entry.parameter_names))


def _of_corners(
    lit: LitTriangles, channel: int | None, model: Model, blockers: Array, stop: Stop | None = None
) -> Array:
    """The light (3 t,) of all corners. Raises: Stopped."""
    from workbench.engine.compiled import collect

    materials, lights = (lit.materials, lit.lights) if channel is None else lit.in_channel(channel)
    of_corner = np.repeat(materials, 3, axis=0)
    given = lit.places, lit.normals, of_corner, lit.eye, lights, model.by_halfway
    if channel is None and not len(blockers):
        return corner_light(*given)
    fragments: Array = collect(corner_lights, *given, blockers, stop=stop, compiling=channel is not None)
    return fragments[:, 0]


def _shade(
    lit: LitTriangles,
    shading: str,
    channel: int,
    buffers: Buffers,
    model: Model,
    blockers: Array,
    stop: Stop | None,
) -> None:
    """Go on with red, green or blue, in bands of rows on two threads."""
    from workbench.engine.compiled import paint

    call = shading_call(lit, shading, buffers, model, blockers, channel)
    light, vertices, *rest, depth = call.arguments
    unused = np.zeros((1, 1), np.uint32)

    def shade(low: int, high: int) -> None:
        given = light[low:high], vertices - (0.0, low, 0.0), *rest, depth[low:high]
        paint(call.entry.function, unused, 0, *given)

    in_bands(len(light), shade, stop)
