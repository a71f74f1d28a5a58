"""The eight neighbours of a pixel: along the row, along the column, at the corners."""

EIGHT_STEPS = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1))
