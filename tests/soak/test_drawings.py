"""Generated SVG drawings by the hundred beside an independent renderer; run by hand."""

from random import Random

from tests.exchange.svg_oracle import assert_same
from tests.exchange.test_svg_beside_renderer import generated


def test_600_drawings_are_as_they_are_rendered() -> None:
    compared = sum(assert_same(generated(Random(seed))) for seed in range(600))
    print(f"\n{compared} insides compared")
    assert compared > 800
