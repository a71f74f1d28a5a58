"""A recording leaves out large arrays that a text can write; whatever is told of a run does without them."""

import copy

import pytest

from tests.engine.test_cut_runs import ENTRIES, spread, tell
from tests.engine.test_observation import so_far
from workbench.algorithms.entry import Entry
from workbench.engine import arguments, containers
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

SAID = {
    "boundary_fill_spans": "is boundary or has been filled already: no run begins here.",
    "flatten_bezier": "from its chord, and 0.05 is allowed: draw the chord.",
    "ray_casting_boxes": "is tried on box",
}
KEPT = {"b_spline_curve": 24, "flatten_bezier": 21}  # items of arrays that are never large
_STEPS = 30
_CUTS = 6


@pytest.mark.parametrize("entry", ENTRIES)
def test_a_run_is_told_without_the_arrays_that_are_too_large(
    entry: Entry, monkeypatch: pytest.MonkeyPatch
) -> None:
    most = KEPT.get(entry.slug, 3)
    monkeypatch.setattr(containers, "LARGEST_ARRAY", most)
    monkeypatch.setattr(containers, "LARGEST_VIEW", 1)
    monkeypatch.setattr(arguments, "LARGEST_ARRAY", most)
    recording = record(entry.function, *copy.deepcopy(entry.example))
    assert recording.error is None
    steps = Steps(entry, recording)
    said = "".join(part.text for event in range(len(recording)) for part in steps.told(event))
    assert SAID.get(entry.slug, "") in said
    for number in spread(len(steps), _STEPS):
        if 1 <= number <= len(steps):
            step = steps[number]
            assert step.number == number
            steps.candidates_next(number)
            steps.options_next(number)
            for event in (step.first, step.last):
                steps.told(event)
                steps.marks_told(event)
    for cut in spread(len(recording), _CUTS):
        if 0 <= cut <= len(recording):
            tell(entry, so_far(recording, cut))
