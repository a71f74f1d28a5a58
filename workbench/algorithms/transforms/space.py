"""The transformations of space as matrices.

All are (4, 4) float64, homogeneous, for points as columns. The frame is right-handed; a rotation is
counter-clockwise when one looks along the axis towards the origin. Quarter turns are exact.
"""

import numpy as np

from workbench.algorithms.transforms.chain import Matrix
from workbench.geometry.angles import cosine_and_sine

Row = tuple[float, float, float, float]


def translation_3d(tx: float, ty: float, tz: float) -> Matrix:
    """x' = x + tx, y' = y + ty, z' = z + tz."""
    return _affine((1, 0, 0, tx), (0, 1, 0, ty), (0, 0, 1, tz))


def scaling_3d(sx: float, sy: float, sz: float) -> Matrix:
    """x' = sx x, y' = sy y, z' = sz z: the origin stays."""
    return _affine((sx, 0, 0, 0), (0, sy, 0, 0), (0, 0, sz, 0))


def scaling_about_3d(sx: float, sy: float, sz: float, xp: float, yp: float, zp: float) -> Matrix:
    """The same with the fixed point (xp, yp, zp)."""
    return _affine((sx, 0, 0, xp * (1 - sx)), (0, sy, 0, yp * (1 - sy)), (0, 0, sz, zp * (1 - sz)))


def rotation_x(theta: float) -> Matrix:
    """By ``theta`` about the x axis: y turns towards z."""
    cos, sin = cosine_and_sine(theta)
    return _affine((1, 0, 0, 0), (0, cos, -sin, 0), (0, sin, cos, 0))


def rotation_y(theta: float) -> Matrix:
    """By ``theta`` about the y axis: z turns towards x."""
    cos, sin = cosine_and_sine(theta)
    return _affine((cos, 0, sin, 0), (0, 1, 0, 0), (-sin, 0, cos, 0))


def rotation_z(theta: float) -> Matrix:
    """By ``theta`` about the z axis: x turns towards y."""
    cos, sin = cosine_and_sine(theta)
    return _affine((cos, -sin, 0, 0), (sin, cos, 0, 0), (0, 0, 1, 0))


def reflection_3d(x: float, y: float, z: float, nx: float, ny: float, nz: float) -> Matrix:
    """In the plane through (x, y, z) with the normal (nx, ny, nz), of any length.

    Raises: ValueError when the normal is zero or not finite.
    """
    normal = np.array([nx, ny, nz], np.float64)
    largest = np.abs(normal).max()
    if not (np.isfinite(normal).all() and largest > 0.0):
        raise ValueError(f"The normal {(nx, ny, nz)} has no direction; give one that is finite and not zero.")
    normal /= largest
    share = 2 * normal / (normal @ normal)
    linear = np.eye(3) - np.outer(share, normal)
    offset = share * (normal @ np.array([x, y, z], np.float64))
    return np.vstack([np.column_stack([linear, offset]), (0, 0, 0, 1)]) + 0.0


def shear_3d(
    sh_xy: float = 0.0,
    sh_xz: float = 0.0,
    sh_yx: float = 0.0,
    sh_yz: float = 0.0,
    sh_zx: float = 0.0,
    sh_zy: float = 0.0,
    x_ref: float = 0.0,
    y_ref: float = 0.0,
    z_ref: float = 0.0,
) -> Matrix:
    """x' = x + sh_xy (y - y_ref) + sh_xz (z - z_ref), and y' and z' likewise.

    The z-axis shear of the books has sh_xz and sh_yz alone.
    """
    return _affine(
        (1, sh_xy, sh_xz, -sh_xy * y_ref - sh_xz * z_ref),
        (sh_yx, 1, sh_yz, -sh_yx * x_ref - sh_yz * z_ref),
        (sh_zx, sh_zy, 1, -sh_zx * x_ref - sh_zy * y_ref),
    )


def _affine(first: Row, second: Row, third: Row) -> Matrix:
    """The matrix with these rows and 0 0 0 1, no zero of it negative."""
    return np.array([first, second, third, (0, 0, 0, 1)], np.float64) + 0.0
