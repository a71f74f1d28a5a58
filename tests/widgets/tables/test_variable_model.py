"""The variables tell of those rows alone whose values became others, whatever they are made of."""

from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QModelIndex

from workbench.engine.recording import Moment
from workbench.session.variables import differing
from workbench.widgets.tables.variable_table import VariableModel


def moment(value: Any) -> Moment:
    return Moment(1, "text", 0, {"value": value}, ())


@pytest.mark.parametrize(
    ("value", "equal", "other"),
    [
        ((np.arange(3), 1), (np.arange(3), 1), (np.array([0, 1, 9]), 1)),
        ([np.ones(2), np.zeros(2)], [np.ones(2), np.zeros(2)], [np.ones(2), np.ones(2)]),
        ({"a": np.arange(2)}, {"a": np.arange(2)}, {"b": np.arange(2)}),
        (np.arange(3), np.arange(3), np.arange(4)),
    ],
    ids=["tuple of arrays", "list of arrays", "dict of arrays", "array"],
)
def test_of_equal_values_nothing_is_told(value: Any, equal: Any, other: Any) -> None:
    model, rows = VariableModel(), []
    model.take({"value": value}, frozenset())
    model.dataChanged.connect(lambda first, _last, _roles: rows.append(QModelIndex(first).row()))
    model.take({"value": equal}, frozenset())
    assert (rows, differing(moment(value), moment(equal))) == ([], frozenset())
    model.take({"value": other}, frozenset())
    assert (rows, differing(moment(value), moment(other))) == ([0], {"value"})
