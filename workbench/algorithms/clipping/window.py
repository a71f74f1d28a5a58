"""The window that is clipped to, and the line of the course's example, as the clipping texts take them; and
what holds of every text that clips lines.

A point on the window's edge is inside. A window without area, a polygon of fewer than three points and
numbers that are not finite are refused before they come here, by the document's check; the command line
refuses the numbers alone. The texts come to an end on such windows and polygons too, and on a line of no
length.
"""

from workbench.algorithms.entry import Parameter

_LOW, _HIGH = -1e12, 1e12

WINDOW = (
    Parameter("xmin", "x_{min}", "float", 0.0, _LOW, _HIGH, "px", "left edge of the window"),
    Parameter("ymin", "y_{min}", "float", 0.0, _LOW, _HIGH, "px", "bottom edge of the window"),
    Parameter("xmax", "x_{max}", "float", 30.0, _LOW, _HIGH, "px", "right edge of the window"),
    Parameter("ymax", "y_{max}", "float", 20.0, _LOW, _HIGH, "px", "top edge of the window"),
)

LINE = (
    Parameter("x0", "x_0", "float", 10.0, _LOW, _HIGH, "px", "first end point, column"),
    Parameter("y0", "y_0", "float", 30.0, _LOW, _HIGH, "px", "first end point, row"),
    Parameter("x1", "x_1", "float", 40.0, _LOW, _HIGH, "px", "second end point, column"),
    Parameter("y1", "y_1", "float", 0.0, _LOW, _HIGH, "px", "second end point, row"),
)

POINT = (
    Parameter("x", "x", "float", 12.0, _LOW, _HIGH, "px", "column of the point"),
    Parameter("y", "y", "float", 20.0, _LOW, _HIGH, "px", "row of the point"),
)

LINE_LAWS = (
    "What is emitted lies in the window, to the last digit, and on the line, to a relative 1e-9.",
    "The ends keep their order; an end inside the window stays as it is.",
    "Of lines and windows of whole numbers nothing visible is lost, not even the touch of a corner.",
)
NO_LINE_LAW = (
    "A line that passes a corner of the window by less than a rounding is told rightly: it may be lost, "
    "or found though it misses."
)
