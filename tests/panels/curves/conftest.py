"""A panel with one curve in it."""

import pytest

from tests.panels.curves.by_hand import (
    ZIGZAG,
    curve_through,
    opened,
)


@pytest.fixture
def zigzag(qtbot):
    return opened(qtbot, curve_through(*ZIGZAG))
