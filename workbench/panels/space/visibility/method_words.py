"""What a method other than the depth buffer gives and costs, with numbers of one scene, as rich text."""

from typing import NamedTuple

from workbench.algorithms import catalogue
from workbench.algorithms.visibility.surfaces import NOTHING
from workbench.language import _
from workbench.rendering.scene.arena import MethodRun
from workbench.rendering.scene.counted import counted_texts, kept_texts
from workbench.rendering.scene.spaces import fails_where


class MethodMeasures(NamedTuple):
    """A method, and the depth buffer on the same scene."""

    run: MethodRun
    buffer: MethodRun


def method_words(measures: MethodMeasures) -> str:
    """Its measures, then what its entry says always holds, and what does not."""
    run, buffer = measures
    entry = catalogue.get(run.method)
    rows = [
        (_("Compares in"), _(entry.works_in) + "."),
        (_("Picture"), _picture(run)),
        (_("Comparisons"), _("{n:,}; the depth buffer makes {m:,}.").format(n=run.tests, m=buffer.tests)),
    ]
    if divided := counted_texts(run):
        rows.append((_("Divides"), ", ".join(divided) + "."))
    kept = _("{what}; the depth buffer keeps {other}.").format(
        what=", ".join(kept_texts(run)) or _("nothing"), other=", ".join(kept_texts(buffer))
    )
    rows.append((_("Keeps at most"), kept))
    if entry.tie:
        rows.append((_("Ties"), _(entry.tie) + "."))
    here = [f"<h4>{_('Here')}</h4>", *(f"<p><b>{head}.</b> {text}</p>" for head, text in rows)]
    return "".join(here) + what_holds(run.method)


def what_holds(method: str) -> str:
    """What the entry of a method says always holds, and what does not."""
    entry, parts = catalogue.get(method), []
    for title, lines in (
        (_("What holds"), [law.sentence for law in entry.laws]),
        (_("What does not hold"), entry.not_laws),
    ):
        if lines:
            parts += [f"<h4>{title}</h4>", *(f"<p>{_(line)}</p>" for line in lines)]
    return "".join(parts)


def _picture(run: MethodRun) -> str:
    wrong, covered = int(run.different.sum()), int((run.seen != NOTHING).sum())
    if not wrong:
        return _("All {covered:,} covered pixels show what ray casting shows.").format(covered=covered)
    said = _("{wrong:,} pixels show another surface than by ray casting: where {reason}.")
    return said.format(wrong=wrong, reason=fails_where(run.method))
