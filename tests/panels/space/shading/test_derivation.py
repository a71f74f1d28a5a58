"""The light of a pixel on paper: every number of it comes to what the picture has."""

import re

import numpy as np
import pytest

from workbench.document.samples.examples import example
from workbench.document.subjects import Subject
from workbench.engine.warm import compile_use
from workbench.exchange.diagrams import Sentence
from workbench.panels.space.shading.derivation import derivation
from workbench.rendering.emissions import emitted
from workbench.rendering.subjects.shading import call_of, lighting_of


def page_of(shading: str, slug: str, at: int, **arguments: object):
    """The lines of the page of a pixel, and the light that the picture has there."""
    (page,) = pages_of(shading, slug, (at,), **arguments)
    return page


def pages_of(shading: str, slug: str, places: tuple[int, ...], **arguments: object):
    """The same for several pixels of one picture, by their numbers among what is emitted."""
    sheet = example(slug).document.sheets[0]
    subject = Subject("shading", entry=shading, arguments={"columns": 16, **arguments})
    call = call_of(sheet, subject)
    assert call is not None
    compile_use(call.entry, "collect")  # shadows that Python casts take a minute
    rows = np.array(emitted(call))
    names = tuple(each.name for each in sheet.scene.lights)
    lighting = lighting_of(sheet, subject)
    assert lighting is not None
    pages = []
    for at in places:
        x, y, _light = rows[at % len(rows)]
        last = rows[(rows[:, 0] == x) & (rows[:, 1] == y)][-1, 2]
        page = derivation(lighting, shading, int(x), int(y), names, float(last))
        assert page is not None
        pages.append(([block.text for block in page.blocks if isinstance(block, Sentence)], float(last)))
    return pages


def last_number(line: str) -> float:
    return float(re.findall(r"−?\d+(?:\.\d+)?", line)[-1].replace("−", "-"))


@pytest.mark.parametrize("arguments", [{}, {"by_halfway": True}, {"shadows": True}], ids=str)
@pytest.mark.parametrize("shading", ["flat_shading", "gouraud", "phong"])
def test_the_sum_is_the_light_of_the_picture(shading: str, arguments: dict[str, object]) -> None:
    shaded = ["shading-lamps"] if "shadows" in arguments else ["shading-ball", "shading-lamps"]
    for slug in shaded:  # nothing casts a shadow on a ball alone
        for lines, light in pages_of(shading, slug, (7, 40, -1), **arguments):
            totals = [line for line in lines if line.startswith("$I = ") and "Σ" not in line]
            assert len(totals) == (3 if shading == "gouraud" else 1)
            for line in totals:
                *parts, total = (
                    float(each.replace("−", "-")) for each in re.findall(r"−?\d+(?:\.\d+)?", line)
                )
                assert sum(parts) == pytest.approx(total, abs=3e-4)
            assert last_number(lines[-1] if shading == "gouraud" else totals[0]) == pytest.approx(
                light, abs=2e-4
            )


def test_each_part_is_its_product() -> None:
    lines, _light = page_of("phong", "shading-ball", 40)
    (diffuse,) = [line for line in lines if line.startswith("Diffuse")]
    product = re.search(r"= ([\d.]+) · ([\d.]+) · ([\d.]+) = ([\d.]+)\$", diffuse)
    assert product is not None
    k, arrives, cosine, value = map(float, product.groups())
    assert k * arrives * cosine == pytest.approx(value, abs=1e-3)
    (specular,) = [line for line in lines if line.startswith("Specular")]
    assert "R = 2 (N · L) N − L" in specular
    assert lines[0] == "$I = k_a + Σ f_j I_j (k_d (N · L_j) + k_s (V · R)^n)$"
