"""Why a refreshed tube flickers, as an answer in an exam: the light over time, the measures, the verdict."""

import numpy as np

from workbench.algorithms.marks import Stroke, Word, along
from workbench.algorithms.numerals import numeral
from workbench.display.flicker import (
    BRIGHT_FIELD_CD_M2,
    fusion_hz,
    in_closed_form,
    light_over_refresh,
    modulation,
)
from workbench.display.phosphor import Phosphor
from workbench.exchange.diagrams import Arrow, Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.flicker.measures import doubt, verdict
from workbench.widgets.formulas.paper import paper_inks

_WIDE, _HIGH, _MARGIN, _HEIGHT_PT = 100.0, 30.0, 6.0, 150.0
_SAMPLES, _PERIODS = 400, 3
_MOST_DRAWN = 4.0


def derivation(phosphor: Phosphor, refresh_hz: float, cd_m2: float, measures: Table) -> Derivation:
    """The page, with the numbers of this tube; ``measures`` has what was measured beside the formulas."""
    title = _("Refresh, persistence and flicker")
    blocks: list[Block] = [
        Heading(title),
        Sentence(
            _(
                "1. The beam hits each place of the screen once in a refresh, every $T = 1 / f$, and goes "
                "on. In between only the phosphor gives light there, and it fades."
            )
        ),
        _light(phosphor, 1.0 / refresh_hz),
        Sentence(
            _(
                "2. Persistence is the time in which the light falls to 10 %. A phosphor is a sum of "
                "exponentials: $L(t) = S_1 e^{-t/tau_1} + S_2 e^{-t/tau_2} + ...$; of one alone the "
                "persistence is $tau ln 10 = 2.3 tau$."
            )
        ),
        Sentence(
            _(
                "3. The eye sees the mean of what comes fast enough (Talbot and Plateau), and flicker "
                "below that."
            )
        ),
        Sentence(
            _(
                "4. How fast that is rises with the logarithm of the luminance and with the modulation of "
                "the light (Ferry and Porter). So a bright screen needs a faster refresh, and a phosphor "
                "with a long persistence a slower one."
            )
        ),
        Sentence(
            _(
                "5. A long persistence has its price: what moves leaves a trail. Moving pictures need a "
                "short one and a fast refresh; a still picture may have a long one."
            )
        ),
        Heading(_("With the numbers of this tube")),
        *map(Sentence, _numbers(phosphor, refresh_hz, cd_m2)),
        *(
            Sentence(
                _("{name}: by formula {formula}, measured {measured}.").format(
                    name=name, formula=formula, measured=measured
                )
            )
            for name, formula, measured in measures.rows
        ),
        Sentence(verdict(phosphor, refresh_hz, cd_m2)),
        Sentence(doubt(phosphor)),
    ]
    return Derivation(title, blocks, paper_inks())


def _light(phosphor: Phosphor, period_s: float) -> Drawing:
    """Light over its mean, a few refreshes long, with the mean and the time from hit to hit."""
    once = light_over_refresh(phosphor, period_s, _SAMPLES)
    light = np.tile(once[:, 1], _PERIODS)
    times = np.concatenate([once[:, 0] + k * period_s for k in range(_PERIODS)])
    # The first moments of most phosphors are far brighter than what follows
    most = min(float(light.max()), _MOST_DRAWN)
    cut = "" if most < _MOST_DRAWN else _("drawn up to {n:g} times the mean").format(n=most)
    x = times * (_WIDE / (_PERIODS * period_s))
    y = np.minimum(light, most) * (_HIGH / most)
    mean, period = _HIGH / most, _WIDE / _PERIODS
    items: list[Item] = [
        Arrow(along((0.0, 0.0), (_WIDE + _MARGIN, 0.0)), "muted"),
        Arrow(along((0.0, 0.0), (0.0, _HIGH + _MARGIN)), "muted"),
        Stroke(np.column_stack((x, y)), "data1", "medium"),
        Stroke(along((0.0, mean), (_WIDE, mean)), "text", "hair", "dash"),
        Word("t", _WIDE + _MARGIN, 0.0, "muted", 0, 1),
        Word(f'L "{cut}"', 0.0, _HIGH + _MARGIN, "muted", 1, 0),
        Word('"mean"', _WIDE, mean, "text", 1, 1),
        Word(f'T = {numeral(round(1e3 * period_s, 3))} "ms"', 1.5 * period, -2.0, "text", 0, -1),
    ]
    for start, end in ((1.5 * period, period), (1.5 * period, 2.0 * period)):
        items.append(Arrow(along((start, -2.0), (end, -2.0)), "text"))
    return Drawing((-2.0, -_MARGIN, _WIDE + 2.0 * _MARGIN, _HIGH + _MARGIN), items, _HEIGHT_PT)


def _numbers(phosphor: Phosphor, refresh_hz: float, cd_m2: float) -> list[str]:
    period_s = 1.0 / refresh_hz
    flicker = in_closed_form(phosphor, period_s)
    shares = "; ".join(
        _("{share:.3g} % of the light with $tau_{k} = {ms:.4g}$ ms").format(
            share=100.0 * share, k=k, ms=1e3 * term.tau_s
        )
        for k, (term, share) in enumerate(zip(phosphor.terms, phosphor.energy_fractions, strict=True), 1)
    )
    least, most = light_over_refresh(phosphor, period_s, 1)[::-1, 1].tolist()
    return [
        _("{name} at {hz:.4g} Hz: $T = 1 / {hz:.4g}$ s = {ms:.4g} ms; persistence {t10:.4g} ms.").format(
            name=phosphor.name, hz=refresh_hz, ms=1e3 * period_s, t10=1e3 * phosphor.t10_s
        ),
        _("Its terms: {terms}.").format(terms=shares),
        _(
            "Just after a hit the light is {most:.4g} times its mean, just before the next {least:.4g} "
            "times: "
            "percent flicker $= ({most:.4g} - {least:.4g}) / ({most:.4g} + {least:.4g})$ = {percent:.1f} %."
        ).format(most=most, least=least, percent=100.0 * flicker.percent_flicker),
        _("Flicker index: the area above the mean over the whole area, {index:.3f}.").format(
            index=flicker.flicker_index
        ),
        _(
            "Modulation of the fundamental, with the share $e_k$ of each term and $omega = 2 pi f$: "
            "$m = 2 |Sigma e_k / (1 + i omega tau_k)|$ = {modulation:.3f}, at most 2."
        ).format(modulation=flicker.modulation),
        _fusion(phosphor, cd_m2),
    ]


def _fusion(phosphor: Phosphor, cd_m2: float) -> str:
    """The rate at which prediction and refresh are one; a faster refresh modulates the light less."""
    fusion = fusion_hz(phosphor, cd_m2)
    if fusion <= 0.0:
        return _("Fusion: at a mean luminance of {cd:g} cd/m² no rate is so low that it flickers.").format(
            cd=cd_m2
        )
    return _(
        "Fusion at a mean luminance of {cd:g} cd/m²: the refresh $f$ for which "
        "$f = 60 + 16.6 log_10(L m / (2 * {field}))$, where $m$ is that of this $f$: "
        "$60 + 16.6 log_10({cd:g} * {modulation:.3f} / {twice:g})$ = {fusion:.1f} Hz."
    ).format(
        field=BRIGHT_FIELD_CD_M2,
        cd=cd_m2,
        modulation=modulation(phosphor, 1.0 / fusion),
        twice=2.0 * BRIGHT_FIELD_CD_M2,
        fusion=fusion,
    )
