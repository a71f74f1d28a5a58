"""What is drawn of a row of a polygon is written as its sentence has it."""

import numpy as np

from workbench.algorithms.marks import Word
from workbench.algorithms.polygons.scan_line_marks import row_marks


def test_a_crossing_far_out_is_written_beside_it_as_the_sentence_has_it() -> None:
    words = [m.text for m in row_marks(3, [-12345.25, 1000.5], np.empty((0, 3))) if isinstance(m, Word)]
    assert words == ["−12345.25", "1000.5"]
