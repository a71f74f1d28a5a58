"""What cannot be done with a curve is refused in one sentence."""

import pytest
from msgspec.structs import replace

from tests.document.curves.test_edits import curve_of, the_curve
from workbench.document import DocumentError
from workbench.document.building import Edit
from workbench.document.curves.conversions import convert
from workbench.document.curves.cutting import insert_on_curve, inserted, split
from workbench.document.curves.degrees import raise_degree
from workbench.document.curves.joining import align, join
from workbench.document.curves.shaping import smooth_joint
from workbench.document.samples.figures import document_of


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (insert_on_curve("f1", 99.0), "no u = 99"),
        (insert_on_curve("f2", 1.0), "already"),
        (split("f1", 0.0), "nothing to cut off"),
        (join("f1", "f1"), "one curve"),
        (convert("f1", "natural_cubic"), "change its kind"),
        (convert("f1", "bezier"), "several pieces"),
        (smooth_joint("f1", 9, "C1"), "no joint 9"),
        (smooth_joint("f1", 0, "C3"), "Choose one of"),
        (align(["s1/f1/p1/x"], "middling"), "Choose one of"),
        (raise_degree("f2"), "has a fixed degree"),
        (join("f1", "f2"), "A closed curve"),
    ],
)
def test_what_cannot_be_done_is_refused_in_one_sentence(edit: Edit, words: str) -> None:
    places = [(0, 0), (20, 40), (50, 50), (80, 10), (110, 0)]
    one = the_curve(curve_of(places, spline="b_spline"))
    other = replace(one, spline="cardinal", closed=True)
    document = document_of("Two", 320, 200, [one, other])
    with pytest.raises(DocumentError, match=words) as refusal:
        edit(document)
    assert str(refusal.value).endswith(".")
    assert inserted(one, 0.5).knot_rule == "free"
