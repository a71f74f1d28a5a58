"""The polynomial that a B-spline is within one knot span."""

from typing import Any

from numpy.typing import NDArray


def bezier_of_span(
    points: NDArray[Any],
    knots: NDArray[Any],
    degree: int,
    span: int,
    controls: NDArray[Any],
    work: NDArray[Any],
) -> None:
    """Write the Bézier control points of one span into ``controls``; all are (degree + 1, 2).

    Each is de Boor's construction with j of its levels at the span's right end and the others at the left
    one: the curve's blossom. The span must not be empty. Source: Ramshaw, Blossoms are polar forms, 1989.
    """
    first = span - degree
    for j in range(degree + 1):
        for i in range(degree + 1):
            work[i, 0] = points[first + i, 0]
            work[i, 1] = points[first + i, 1]
        for r in range(1, degree + 1):
            u = knots[span] if r <= degree - j else knots[span + 1]
            for i in range(degree, r - 1, -1):
                left = knots[first + i]
                alpha = (u - left) / (knots[span + i + 1 - r] - left)
                work[i, 0] = (1.0 - alpha) * work[i - 1, 0] + alpha * work[i, 0]
                work[i, 1] = (1.0 - alpha) * work[i - 1, 1] + alpha * work[i, 1]
        controls[j, 0] = work[degree, 0]
        controls[j, 1] = work[degree, 1]


def span_polynomial(
    points: NDArray[Any],
    knots: NDArray[Any],
    degree: int,
    span: int,
    powers: NDArray[Any],
    work: NDArray[Any],
) -> None:
    """Write the factors of v^0 to v^degree into ``powers``, with v from -1/2 to 1/2 along the span.

    From the middle of the span the powers stay small, and so do the rounding errors: they are the k-th
    differences of de Casteljau's level with k + 1 points at 1/2, times the binomial. ``work`` is
    (3, degree + 1, 2).
    """
    controls = work[0]
    bezier_of_span(points, knots, degree, span, controls, work[1])
    binomial = 1.0
    for k in range(degree, -1, -1):
        differences = work[2]
        for i in range(k + 1):
            differences[i, 0] = controls[i, 0]
            differences[i, 1] = controls[i, 1]
        for length in range(k, 0, -1):
            for i in range(length):
                differences[i, 0] = differences[i + 1, 0] - differences[i, 0]
                differences[i, 1] = differences[i + 1, 1] - differences[i, 1]
        powers[k, 0] = binomial * differences[0, 0]
        powers[k, 1] = binomial * differences[0, 1]
        binomial = binomial * k / (degree - k + 1)
        for i in range(k):
            controls[i, 0] = 0.5 * (controls[i, 0] + controls[i + 1, 0])
            controls[i, 1] = 0.5 * (controls[i, 1] + controls[i + 1, 1])
