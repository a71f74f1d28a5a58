"""How a random-scan display works, as a page: its architecture, the list, and the sum of its times."""

from workbench.algorithms.numerals import with_minus
from workbench.algorithms.scanning.operations import DRAW, NAMES
from workbench.exchange.diagrams import Block, Derivation, Heading, Sentence
from workbench.language import _
from workbench.panels.display.vector.architecture import architecture
from workbench.panels.display.vector.numbers import on_paper, working
from workbench.panels.display.vector.run import VectorRun
from workbench.widgets.formulas.paper import paper_inks

_HEIGHT_PT = 190.0
_LISTED = 12


def derivation(run: VectorRun) -> Derivation:
    """The page, with the numbers of this list."""
    title = _("Random-scan display")
    blocks: list[Block] = [
        Heading(title),
        Sentence(
            _(
                "The application writes a display list into system memory. The display processor fetches one "
                "instruction after the other, its vector generator moves the beam from end to end of each "
                "line, and at the end of the list it jumps back to the first: that is a refresh."
            )
        ),
        architecture(run.working, _HEIGHT_PT),
        Heading(_("The display list")),
    ]
    blocks += [Sentence(line) for line in _listing(run)]
    blocks.append(Heading(_("How long a picture takes")))
    sums, seen = working(run.budget, run.stores)
    blocks += [Sentence(on_paper(line)) for line in sums]
    blocks += [Sentence(line) for line in seen]
    return Derivation(title, blocks, paper_inks())


def _listing(run: VectorRun) -> list[str]:
    """The first instructions with their times."""
    lines = []
    for address, (operation, x, y, intensity) in enumerate(run.program.rows[:_LISTED].tolist()):
        took = int(run.budget.time.each_ps[address]) * 1e-6
        place = with_minus(f"({x:.4g}, {y:.4g})") if address < len(run.program) - 1 else "0"
        bright = f", {intensity:.0%}" if operation == DRAW else ""
        lines.append(f"{address}:  {NAMES[int(operation)]} {place}{bright}: {took:.4g} µs")
    more = len(run.program) - _LISTED
    if more > 0:
        lines.append(_("and {n:,} more").format(n=more))
    return lines
