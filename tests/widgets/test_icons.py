"""Icons of one family, at any size."""

from typing import Any

import pytest
from PySide6.QtCore import QSize

from workbench.widgets.look.icons import icon


@pytest.mark.parametrize("size", [QSize(16, -4), QSize(0, 8), QSize(-3, -3)])
def test_an_icon_without_room_is_nothing_and_says_nothing(qapp: object, qtlog: Any, size: QSize) -> None:
    assert icon("plus").pixmap(size).isNull()
    assert [record.message for record in qtlog.records] == []
    assert icon("plus").pixmap(16, 16).toImage().pixelColor(8, 8).alpha() > 0
