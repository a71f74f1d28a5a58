"""What a person who is asked first has answered, and what that was worth."""

from dataclasses import dataclass
from typing import Any, Literal

from workbench.engine.observation import Step

Verdict = Literal["right", "wrong", "far"]

# A click further than this from every pixel in question was not meant as an answer.
NEAR_PX = 3


@dataclass(frozen=True, slots=True)
class Answer:
    """``given``, a pixel (x, y) or an option, was said to come next; ``number`` is where the cursor stands.

    "far" is no answer: the pixel lies far from all that are in question.
    """

    given: Any
    verdict: Verdict
    number: int

    @property
    def cell(self) -> tuple[int, int] | None:
        """The pixel that was clicked; None where an option was chosen."""
        return self.given if isinstance(self.given, tuple) else None


def verdict(step: Step, x: int, y: int) -> Verdict:
    """What it is worth to say that the pixel (x, y) comes with ``step``."""
    if (x, y) in step.chosen:
        return "right"
    in_question = (*step.candidates, *step.chosen)
    near = any(abs(x - column) <= NEAR_PX and abs(y - row) <= NEAR_PX for column, row in in_question)
    return "wrong" if near else "far"
