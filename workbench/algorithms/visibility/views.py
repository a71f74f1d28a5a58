"""What the depth buffer shows of its blocks."""

from workbench.algorithms.entry import View

_ROW = "(left + k, y, z_here, stored, won)"
_PIXEL = "((left + k, y),)"

VIEWS = (
    View(
        block="Find the rows that the triangle covers",
        when="first_row >= row_end",
        sentence="Triangle {face} reaches from y = {y_low} to {y_high}: it covers none of these rows.",
    ),
    View(
        block="Find the rows that the triangle covers",
        sentence="Triangle {face} reaches from y = {y_low} to {y_high}: rows {first_row} to {row_end - 1}.",
    ),
    View(
        block="Find the plane's normal",
        when="C == 0.0",
        sentence="C = {C}: triangle {face} is seen edge on and covers no pixel.",
    ),
    View(
        block="Find the plane's normal",
        sentence="Triangle {face}: A = {A}, B = {B}, C = {C}, so z changes by −A/C = {dz_dx} per column "
        "and by −B/C = {dz_dy} per row.",
    ),
    View(
        block="Compare with the stored depth",
        when="won == 1",
        candidates=_PIXEL,
        chosen=_PIXEL,
        row=_ROW,
        considers="(left + k, y)",
        sentence="At {(left + k, y)} z = {z} + {k} · ({dz_dx}) = {z_here}, nearer than the stored "
        "{stored}: the pixel takes colour {colour}.",
    ),
    View(
        block="Compare with the stored depth",
        candidates=_PIXEL,
        rejected=_PIXEL,
        row=_ROW,
        considers="(left + k, y)",
        sentence="At {(left + k, y)} z = {z} + {k} · ({dz_dx}) = {z_here}, not nearer than the "
        "stored {stored}: the pixel stays as it is.",
    ),
)
