"""The tables of the Transform panel that can be exported."""

import numpy as np

from workbench.document.model import AnyFigure
from workbench.document.transforms.chains import transformed
from workbench.document.transforms.stages import products, stages
from workbench.exchange.tables import Table


def points_table(figure: AnyFigure) -> Table:
    """A row for each point of a figure: as drawn, then after each stage of its chain, world."""
    made = [np.eye(3), *products(stages(figure.transforms))]
    points = np.array([(p.x, p.y) for p in figure.points_world], np.float64).reshape(-1, 2)
    columns = [transformed(matrix, points) for matrix in made]
    names = [f"{axis}_{{{stage}}}" for stage in range(len(made)) for axis in "xy"]
    rows = [(k, *np.concatenate(row).tolist()) for k, row in enumerate(zip(*columns, strict=True))]
    return Table(("k", *names), rows)
