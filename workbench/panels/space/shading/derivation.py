"""The light of a pixel as an exam answer: ambient, diffuse and specular, with the numbers put in."""

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Spot, Stroke, Word, closed
from workbench.algorithms.shading import fast_phong, gouraud, illuminate
from workbench.algorithms.shading.directions import halfway, mirrored, towards, unit, vector
from workbench.algorithms.shading.illumination import Arriving, arriving
from workbench.algorithms.visibility.back_faces import SpaceVector
from workbench.exchange.diagrams import Axes, Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.exchange.formulas.terms import displayed
from workbench.geometry.meshes import Array, Index
from workbench.language import _
from workbench.rendering.scene.lit_pixel import LitPixel, LitPoint, lit_pixel
from workbench.rendering.subjects.shading import Lighting
from workbench.widgets.formulas.paper import paper_inks

_PICTURE_PT = 190.0


def derivation(
    stepped: Lighting, shading: str, x: int, y: int, lights: tuple[str, ...], light: float
) -> Derivation | None:
    """The page of a pixel that the picture gives this ``light``; None where nothing is lit there.

    ``lights`` are what the lights are called.
    """
    pixel = lit_pixel(stepped.lit, shading, x, y)
    if pixel is None:
        return None
    name = _(catalogue.get(shading).title)
    title = _("{shading}: the light of pixel ({x}, {y})").format(shading=name, x=x, y=y)
    k_a, k_d, k_s, n = map(_short, pixel.material.tolist())
    product = "N · H" if stepped.model.by_halfway else "V · R"
    blocks: list[Block] = [
        Heading(title),
        _picture(stepped.lit.corners, stepped.lit.triangles, pixel, x, y),
        Sentence(_("$I = k_a + Σ f_j I_j (k_d (N · L_j) + k_s ({product})^n)$").format(product=product)),
        Sentence(
            _(
                "$k_a = {k_a}$ with the ambient light in it, $k_d = {k_d}$, $k_s = {k_s}$, $n = {n}$; a "
                "light behind the surface or in shadow adds nothing."
            ).format(k_a=k_a, k_d=k_d, k_s=k_s, n=n)
        ),
    ]
    totals = []
    for number, point in enumerate(pixel.points):
        if len(pixel.points) > 1:
            blocks.append(Heading(_("Corner {n}").format(n=number + 1)))
        sentences, total = _of_point(point, pixel.material, stepped, lights)
        blocks += map(Sentence, sentences)
        totals.append(total)
    blocks += map(Sentence, _ended(shading, pixel, totals, light))
    return Derivation(title, blocks, paper_inks())


def _picture(vertices: Array, faces: Index, pixel: LitPixel, x: int, y: int) -> Drawing:
    """The triangles on the device, that of the pixel strong."""
    rings = vertices[faces][..., :2]
    items: list[Item] = [Axes("x", "y")]
    items += [Stroke(closed(ring), "muted", "hair") for ring in rings]
    items += [
        Stroke(closed(rings[pixel.face]), "accent", "medium"),
        Spot(float(x), float(y), "text", "ring", "large"),
        Word(f"({x}, {y})", float(x), float(y), "text", 1, 1),
    ]
    (left, low), (right, high) = rings.reshape(-1, 2).min(axis=0), rings.reshape(-1, 2).max(axis=0)
    return Drawing((float(left) - 1, float(low) - 1, float(right) + 1, float(high) + 1), items, _PICTURE_PT)


def _of_point(
    point: LitPoint, material: Array, stepped: Lighting, names: tuple[str, ...]
) -> tuple[list[str], float]:
    """The light of a point, step by step, and what it comes to."""
    eye, lights, by_halfway = stepped.lit.eye, stepped.lit.lights, stepped.model.by_halfway
    blockers = stepped.blockers
    N, P = unit(vector(point.normal)), vector(point.place)
    V = unit(towards(eye, P))
    told = [
        _("$P = {P}$, $N = {N}$, $V = {V}$.").format(P=_written(P), N=_written(N), V=_written(V)),
        _("Ambient: $k_a = {value}$.").format(value=_short(float(material[0]))),
    ]
    total, sums = float(material[0]), [_short(float(material[0]))]
    rows = list(illuminate(point.place, point.normal, eye, lights, material, by_halfway, blockers))
    for number, diffuse, specular, _so_far in rows:
        total += diffuse + specular
        came = arriving(lights, number, P, blockers)
        name = names[number] if number < len(names) else _("light {n}").format(n=number + 1)
        cosine = N.x * came.L.x + N.y * came.L.y + N.z * came.L.z
        if cosine <= 0.0 or came.intensity == 0.0:
            why = (
                _("it is behind the surface: $N · L = {cosine}$")
                if cosine <= 0.0
                else _("nothing of it comes")
            )
            told.append(f"{name}: {why.format(cosine=_short(cosine))}.")
            continue
        told += _of_light(name, came, N, V, material, by_halfway, (diffuse, specular))
        sums += [_short(diffuse), _short(specular)]
    told.append(_("$I = {sum} = {total}$").format(sum=" + ".join(sums), total=_short(total)))
    return told, total


def _of_light(
    name: str,
    came: Arriving,
    N: SpaceVector,
    V: SpaceVector,
    material: Array,
    by_halfway: bool,
    adds: tuple[float, float],
) -> list[str]:
    """What one light adds: the direction, then the diffuse part, then the specular one."""
    k_d, k_s, n = (_short(float(value)) for value in material[1:])
    cosine = N.x * came.L.x + N.y * came.L.y + N.z * came.L.z
    if by_halfway:
        H = halfway(came.L, V)
        mirror, how = N.x * H.x + N.y * H.y + N.z * H.z, f"H = {_written(H)}$, $N · H"
    else:
        R = mirrored(came.L, N)
        mirror, how = V.x * R.x + V.y * R.y + V.z * R.z, f"R = 2 (N · L) N − L = {_written(R)}$, $V · R"
    intensity = _short(came.intensity)
    return [
        _("{name}: $L = {L}$, $d = {d}$, $f = {f}$, so $f I = {intensity}$ arrives.").format(
            name=name, L=_written(came.L), d=_short(came.d), f=_short(came.f), intensity=intensity
        ),
        _(
            "Diffuse: $N · L = {cosine}$, $k_d f I (N · L) = {k_d} · {intensity} · {cosine} = {value}$."
        ).format(cosine=_short(cosine), k_d=k_d, intensity=intensity, value=_short(adds[0])),
        _(
            "Specular: ${how} = {mirror}$, $k_s f I ({mirror})^n = {k_s} · {intensity} · {mirror}^{{{n}}} = "
            "{value}$."
        ).format(
            how=how,
            mirror=_short(max(mirror, 0.0)),
            k_s=k_s,
            intensity=intensity,
            n=n,
            value=_short(adds[1]),
        ),
    ]


def _ended(shading: str, pixel: LitPixel, totals: list[float], light: float) -> list[str]:
    """How the light of the points becomes that of the pixel."""
    if shading == gouraud.__name__:
        shares = [point.share for point in pixel.points]
        parts = " + ".join(
            f"{_short(share)} · {_short(total)}" for share, total in zip(shares, totals, strict=True)
        )
        return [
            _("Along the edges and the scan line light is spread evenly: ${parts} = {light}$.").format(
                parts=parts, light=_short(float(np.dot(shares, totals)))
            )
        ]
    if shading == fast_phong.__name__:
        return [
            _("Fast Phong comes near to this by a series: the picture has ${light}$.").format(
                light=_short(light)
            )
        ]
    return [_("The picture has ${light}$ there.").format(light=_short(light))]


def _short(value: float) -> str:
    """A number with four decimals at most, as an exam answer has it."""
    return displayed(round(value, 4))


def _written(a: SpaceVector) -> str:
    return f"({_short(a.x)}, {_short(a.y)}, {_short(a.z)})"
