"""Whether labels of a drawing lie over one another, as shapely sees it."""

from collections.abc import Sequence
from itertools import combinations

import shapely

from workbench.display.cutaway import PlacedLabel


def crowded(placed: Sequence[PlacedLabel]) -> bool:
    """Whether any two of the boxes have a part in common."""
    boxes = [shapely.box(*each.box) for each in placed]
    return any(one.intersection(other).area > 1e-9 for one, other in combinations(boxes, 2))
