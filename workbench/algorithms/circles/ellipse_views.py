"""What the midpoint ellipse shows of its blocks."""

from workbench.algorithms.entry import Parameter, View

PARAMETERS = (
    Parameter("xc", "x_c", "int", 0, -32768, 32767, "px", "centre, column"),
    Parameter("yc", "y_c", "int", 0, -32768, 32767, "px", "centre, row"),
    Parameter("rx", "r_x", "int", 8, 0, 16383, "px", "radius along x"),
    Parameter("ry", "r_y", "int", 6, 0, 16383, "px", "radius along y"),
)

COLUMNS = ("region", "k", "p_k", "(x_{k+1}, y_{k+1})", "2r_y^2x_{k+1}", "2r_x^2y_{k+1}")

_HERE = "((xc + x, yc + y),)"
_EAST = "((xc + x + 1, yc + y), (xc + x + 1, yc + y - 1))"
_SOUTH = "((xc + x, yc + y - 1), (xc + x + 1, yc + y - 1))"
_ROW_1 = "(1, x - 1, before.p, (x, y), px, py)"
_ROW_2 = "(2, k, before.p, (x, y), px, py)"

VIEWS = (
    View(
        block="Start region 1 at the top",
        chosen=_HERE,
        sentence="Start at (0, {ry}) from the centre. p1 = r_y² − r_x² r_y + r_x²/4 = {p}.",
    ),
    View(
        block="Region 1: choose E or SE",
        when="before.p < 0",
        candidates=_EAST,
        chosen=_HERE,
        rejected="((xc + x, yc + y - 1),)",
        row=_ROW_1,
        sentence="p1 = {before.p} is negative: the midpoint is inside, take E, ({x}, {y}) "
        "from the centre. Next p1 = {before.p} + {px} + {ry2} = {p}.",
    ),
    View(
        block="Region 1: choose E or SE",
        candidates=_EAST,
        chosen=_HERE,
        rejected="((xc + x, yc + before.y),)",
        row=_ROW_1,
        sentence="p1 = {before.p} is not negative: the midpoint is not inside, take SE, ({x}, {y}) "
        "from the centre. Next p1 = {before.p} + {px} − {py} + {ry2} = {p}.",
    ),
    View(
        block="Change to region 2",
        when="y > 0",
        row="('1 → 2', '', p, (x, y), px, py)",
        sentence="2r_y²x = {px} has reached 2r_x²y = {py}: the slope passes −1, region 2 begins at ({x}, "
        "{y}). p2 = r_y²(x + ½)² + r_x²(y − 1)² − r_x² r_y² = {p}.",
    ),
    View(
        block="Change to region 2",
        row="('1 → 2', '', '', (x, y), px, py)",
        sentence="The centre row is reached at ({x}, {y}): region 2 has no rows left.",
    ),
    View(
        block="Region 2: choose S or SE",
        when="before.p > 0",
        candidates=_SOUTH,
        chosen=_HERE,
        rejected="((xc + x + 1, yc + y),)",
        row=_ROW_2,
        sentence="p2 = {before.p} is positive: the midpoint is outside, take S, ({x}, {y}) "
        "from the centre. Next p2 = {before.p} − {py} + {rx2} = {p}.",
    ),
    View(
        block="Region 2: choose S or SE",
        candidates=_SOUTH,
        chosen=_HERE,
        rejected="((xc + before.x, yc + y),)",
        row=_ROW_2,
        sentence="p2 = {before.p} is not positive: the midpoint is not outside, take SE, ({x}, {y}) "
        "from the centre. Next p2 = {before.p} + {px} − {py} + {rx2} = {p}.",
    ),
    View(
        block="Finish the tip of a flat ellipse",
        chosen=_HERE,
        row="('tip', '', '', (x, y), '', '')",
        sentence="The centre row is reached before the end of the axis: go on to ({rx}, 0) along it.",
    ),
)
