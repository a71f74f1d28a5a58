"""Short texts that would take minutes, and long ones that would take gigabytes, if they were believed."""

from collections.abc import Callable

import pytest

from tests.soak.cases import soaked
from tests.soak.confined import MOST_MB, MOST_S

Says = Callable[[str, str], str]

SVG = """
from workbench.exchange.svg_paths import read_svg
from workbench.document.samples.examples import example_document
def svg(body, before=""):
    text = f'{before}<svg xmlns="http://www.w3.org/2000/svg">{body}</svg>'
    return read_svg(text, example_document().sheets[0])
def tiny(data):
    text = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><path d="{data}"/></svg>'
    return read_svg(text, example_document().sheets[0])
def doubling(depth):
    twice = (f'<g id="g{k}"><use href="#g{k + 1}"/><use href="#g{k + 1}"/></g>' for k in range(depth))
    return "".join(twice) + f'<g id="g{depth}"><line x2="1"/></g>'
"""
SVG += """
from workbench.exchange.svg_originals import FIGURE, DIGEST, digest
from workbench.exchange.svg_tree import OWN
def nested_original(depth):
    kept = '{&quot;unknown&quot;:' + '[' * depth
    known = digest('line', {'x2': '1'})
    return f'<line xmlns:own="{OWN}" x2="1" own:{FIGURE}="{kept}" own:{DIGEST}="{known}"/>'
"""
CSV = "from workbench.exchange.point_lists import read_points"
GWB = """
from workbench.document.storage.files import decode
def gwb(version, rest): return decode(b'{"format":"graphics-workbench","version":%d,' % version + rest)
sheet = b'"document":{"sheets":[{"id":"s1","palette":'
"""


@pytest.mark.parametrize(
    ("imports", "call", "said"),
    [
        (SVG, """svg('<rect x="' + '1' * 20_000 + 'a"/>')""", "which is not a length that can be drawn"),
        (SVG, """svg('<g transform="rotate(' + '1' * 200_000 + 'a)"/>')""", "cannot be read"),
        (SVG, """svg('<g fill="url(#' + ' ' * 200_000 + '"><line x2="1"/></g>')""", "read"),
        (SVG, "svg(nested_original(100_000))", "read"),
        (SVG, "svg(doubling(17))", "more than 100,000 elements"),
        (SVG, "svg('<style>' + 'a' * 30_000 + '</style>')", "read"),
        (
            SVG,
            """svg('<style>' + 'a{}' * 300_000 + '</style><rect width="1" height="1"/>')""",
            "has 900,000 characters",
        ),
        (SVG, """svg('<style>' + 'a{}' * 130_000 + '</style><rect width="1" height="1"/>')""", "read"),
        (SVG, "svg('<style>' + 'a,' * 150_000 + 'b{fill:red}</style>')", "more than 10,000 selectors"),
        (
            SVG,
            "svg('<style>' + ''.join(f'.b{k}.a{{fill:red}}' for k in range(9_000)) + '</style>'"
            """ + ''.join(f'<g class="a c{k}"/>' for k in range(40_000)))""",
            "too many rules",
        ),
        (
            SVG,
            "svg('<style>' + ' '.join(f'g g g.a{k}{{fill:red}}' for k in range(9)) + '</style>'"
            """ + '<g class="a0 a1 a2 a3 a4 a5 a6 a7 a8">' * 190 + '</g>' * 190)""",
            "too many rules",
        ),
        (SVG, """svg('<rect width="1" height="1" style="fill:' + '(' * 5_000 + '"/>')""", "read"),
        (SVG, "svg('<style>g' + ':not(' * 3_000 + '{fill:red}</style><line x2=\"1\"/>')", "read"),
        (SVG, "svg('<style>' + 'g ' * 900 + '{fill:red}</style><line x2=\"1\"/>')", "read"),
        (SVG, """svg('<line style="font-size:' + '9' * 5_000 + '"/>')""", "too many digits"),
        (SVG, "svg('<style>a{font-size:' + '9' * 5_000 + '}</style>')", "too many digits"),
        (
            SVG,
            "svg('<style>' + ''.join(f'g[id*=aab{k}]{{fill:red}}' for k in range(9_000)) + '</style>'"
            """ + '<g id="' + 'a' * 500_000 + '"/>')""",
            "too many rules",
        ),
        (SVG, """svg('<g style="fill:red;stroke:blue;opacity:.5"/>' * 90_000)""", "read"),
        (
            SVG,
            "svg(''.join(f'<g style=\"fill:#{k:06x};stroke:#{7 * k:06x}\"/>' for k in range(90_000)))",
            "more than 1,000,000 different characters",
        ),
        (
            SVG,
            "svg('<g transform=\"rotate(1)\">' * 190 + '<line x2=\"1\"/>' * 40_000 + '</g>' * 190)",
            "more than 150,000 transforms",
        ),
        (SVG, "svg('<line transform=\"rotate(1e400) skewX(1e400)\"/>')", "cannot be read"),
        (SVG, "svg('<line transform=\"scale(1e300) scale(1e300)\"/>')", "numbers above 1e+12"),
        (SVG, "svg('<g transform=\"scale(1e10)\">' * 90 + '<line x2=\"1\"/>' + '</g>' * 90)", "finite"),
        (SVG, "svg('<path d=\"M0 0A1e-320 9 0 0 1 9 9\"/>')", "cannot be understood"),
        (SVG, "tiny('M0 0' + 'C1e12 0 0 1e12 1e12 1e12' * 4_000)", "more than 200,000 points"),
        (SVG, "tiny('M0 0A1e12 1e12 0 0 1 1e12 1Z' * 40)", "more than 200,000 points"),
        (SVG, """svg('<path d="M 0 0' + 'l1 1' * 250_000 + '"/>')""", "more than 200,000 points"),
        (SVG, """svg('<path d="M 0 0' + 'l1 1' * 20_000 + '"/>')""", "read"),
        (SVG, """svg('<polyline points="' + '1 2 ' * 1_000_000 + '"/>')""", "more than 200,000 points"),
        (SVG, "svg('<g/>' * 2_500_000)", "more than 100,000 elements"),
        (SVG, """svg('<g ' + ' '.join(f'a{k}=""' for k in range(500_000)) + '/>')""", "read"),
        (
            SVG,
            """svg('<g id="' + '&a;' * 3_000_000 + '"/>', f'<!DOCTYPE svg [<!ENTITY a "{"b" * 99}">]>')""",
            "could make more than 16,777,216 characters",
        ),
        (
            SVG,
            "svg('<g/>' * 90_000, '<!DOCTYPE svg ['"
            """ + ''.join(f'<!ATTLIST g a{k} CDATA "b">' for k in range(100_000)) + ']>')""",
            "more than 500 declarations",
        ),
        (CSV, "read_points('1,2' + ',3' * 20_000)", "Line 1: it has 40,003 characters"),
        (CSV, "read_points('1,2' + ',3' * 4_000)", "there are 4002 values"),
        (CSV, "read_points('1.5 2\\n' * 100_000)", "read"),
        (CSV, "read_points('\\n' * 5_000_000)", "There are no points"),
        (CSV, "read_points('1 2\\n' * 25_000_000)", "100,000,000 characters, but at most 16,777,216"),
        (GWB, "gwb(3, sheet + b'[' + b'1,' * 100_000_000)", "bytes, but at most 134,217,728"),
        (GWB, "gwb(3, sheet + b'[' + b'1,' * 30_000_000)", "values, but at most 2,000,000"),
        (
            GWB,
            """gwb(3, sheet + b'[1],"figures":[' + b'{"id":"p1","x":0.125,"y":1.25},' * 450_000)""",
            "breaks off at line 1, in sheets[0].figures[450000]",
        ),
        (GWB, "gwb(3, sheet + b'[],' + b' ' * 50_000_000)", "breaks off at line 1, in sheets[0]"),
        (GWB, """gwb(1, b'"x":[' + b'[],' * 900_000 + b'1]}')""", "x is a field"),
    ],
)
def test_it_is_read_or_refused_before_it_takes_long_or_much(
    confined: Says, imports: str, call: str, said: str
) -> None:
    assert said in confined(imports, call)


@pytest.mark.parametrize(("kind", "count"), [("svg", 30), ("csv", 150), ("gwb", 150), ("cli", 30)])
def test_whatever_is_mangled_is_read_or_refused_in_one_sentence(kind: str, count: int) -> None:
    outcome = soaked(kind, count, 7)
    assert outcome.faults == []
    assert outcome.slowest_s < MOST_S
    assert outcome.peak_mb < MOST_MB


def test_100_000_points_are_fitted_or_refused(confined: Says) -> None:
    imports = (
        "import sys, numpy as np; from workbench.algorithms.curves import fit_pieces\n"
        "u = np.linspace(0, 60, 100_000); wave = np.column_stack([5 * u, 100 * np.sin(u)])\n"
        "noise = np.random.default_rng(1).uniform(0, 100, (100_000, 2))"
    )
    assert confined(imports, "fit_pieces(wave, 0.5)") == "read"
    assert "more than 3,333 pieces" in confined(imports, "fit_pieces(noise, 0.5, most_pieces=3333)")
