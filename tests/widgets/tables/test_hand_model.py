"""The rows of the hand table, where a run comes to be told less far than it was."""

from types import SimpleNamespace
from typing import Any

from workbench.widgets.tables.hand_table import HandModel


def test_what_is_told_anew_are_rows_that_there_are(qtbot: Any) -> None:
    run: Any = SimpleNamespace(tellable=10, step_number=8, entry=SimpleNamespace(columns=("k", "p_k")))
    model = HandModel(run)
    model.reset()
    model.update()
    told: list[tuple[int, int]] = []
    model.dataChanged.connect(lambda first, last, _roles: told.append((first.row(), last.row())))
    run.tellable, run.step_number = 3, 7
    model.update()
    assert model.rowCount() == 3
    assert told == [(2, 2)]


class _Steps(list[tuple[Any, ...]]):
    def row(self, number: int) -> tuple[Any, ...]:
        return self[number - 1]


def test_a_cell_has_true_minus_signs_and_the_hyphens_of_its_words() -> None:
    entry = SimpleNamespace(columns=("rule", "p_k"))
    run: Any = SimpleNamespace(steps=_Steps([("4-connected", -3)]), tellable=1, step_number=0, entry=entry)
    model = HandModel(run)
    model.reset()
    assert [model.data(model.index(0, column)) for column in (0, 1)] == ["4-connected", "−3"]
