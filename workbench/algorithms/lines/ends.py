"""The end points that every line algorithm takes, with the example of the course."""

from workbench.algorithms.entry import Parameter

LOW, HIGH = -32768, 32767

# Curves are drawn by the lines that they are flattened into.
DRAWS = ("line", "polyline", "curve")

END_POINTS = (
    Parameter("x0", "x_0", "int", 20, LOW, HIGH, "px", "first end point, column"),
    Parameter("y0", "y_0", "int", 10, LOW, HIGH, "px", "first end point, row"),
    Parameter("x1", "x_1", "int", 30, LOW, HIGH, "px", "second end point, column"),
    Parameter("y1", "y_1", "int", 18, LOW, HIGH, "px", "second end point, row"),
)

# The box of a line that never leaves its end points.
EXTENT = "min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)"
