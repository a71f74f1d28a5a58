"""Insides, colours and frames of SVG drawings, beside an independent renderer."""

from itertools import product
from random import Random

import pytest

from tests.exchange.svg_oracle import assert_same

SVG = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
PATH = '<path {} d="M10 10H90V90H10ZM30 30{}Z"/>'
ALIGNED = [f"x{x}Y{y}" for x, y in product(("Min", "Mid", "Max"), repeat=2)]
SQUARE = "M10 50C10 0 90 0 90 50S50 90 10 50z"


def rect(how: str = "") -> str:
    return f'<rect x="10" y="20" width="30" height="40" {how}/>'


BODIES = [
    rect(""),
    rect(' fill="rgba(255,0,0,0.5)"'),
    rect(' fill="rgb(10%,20%,30%)"'),
    rect(' fill="hsl(120,100%,25%)"'),
    rect(' fill="#f80"'),
    rect(' fill="red" opacity="0.25"'),
    rect(' fill="red" fill-opacity="50%"'),
    '<g opacity=".5">' + rect(" fill='red' fill-opacity='.5'") + "</g>",
    rect(' fill="red" stroke="blue" stroke-width="0"'),
    rect(' fill="no such colour"'),
    rect(' fill="url(#missing) green"'),
    '<g color="teal">' + rect(" fill='currentColor'") + "</g>",
    '<g fill="blue">' + rect(" fill='inherit'") + "</g>",
    "<style>rect{fill:blue}</style>" + rect(' fill="red"'),
    "<style>rect{fill:blue !important}</style>" + rect(' style="fill:red"'),
    "<style>g > rect{fill:red} g rect{fill:blue}</style><g>" + rect("") + "</g>",
    "<style>g > rect{fill:red} g rect{fill:blue}</style><g><a>" + rect("") + "</a></g>",
    "<style>.b{fill:red} .a{fill:lime}</style>" + rect(' class="a b"'),
    "<style>#i{fill:red} rect.a{fill:lime}</style>" + rect(' id="i" class="a"'),
    '<style>rect[width="30"]{fill:red}</style>' + rect(""),
    "<style>svg > *:first-child{fill:red} rect{fill:lime}</style>" + rect(""),
    "<style>@media print { rect { fill: red } } rect { fill: teal }</style>" + rect(""),
    rect(' style="opacity: 0.5; fill: red; fill-opacity: 0.5"'),
    rect(' style="/* kept */ fill: teal ;  stroke : none ;"'),
    rect(' style=" fill: red;  fill: blue; "'),
    "<style> rect { fill : red ; fill-opacity : .5 ; } </style>" + rect(""),
    '<path fill="red" d="M10 10H90V90H10Z"/>',
    PATH.format('fill="red" fill-rule="evenodd"', "H70V70H30"),
    PATH.format('fill="red"', "H70V70H30"),
    PATH.format('fill="red"', "V70H70V30"),
    PATH.format('style="fill:red;fill-rule:evenodd"', "H70V70H30"),
    f'<path fill="purple" d="{SQUARE}"/>',
    f'<path fill="purple" d="{SQUARE}" transform="translate(5 5) rotate(20 50 50) scale(.8 .5)"/>',
    '<path fill="navy" d="M20 50A30 20 30 1 1 80 50Q50 90 20 50"/>',
    '<path fill="navy" d="m20 20 60 0t0 40l-60 0z"/>',
    '<polyline points="10,10 50,90 90,20" fill="orange"/>',
    '<polygon points="10,10 50,90 90,20" fill="orange" stroke="none"/>',
    '<circle cx="50" cy="50" r="25%" fill="red"/>',
    '<ellipse cx="50" cy="50" rx="30" fill="red"/>',
    '<ellipse cx="50" cy="50" rx="30" ry="10" fill="red" transform="rotate(20 50 50)"/>',
    '<circle cx="50" cy="50" r="20" fill="red" transform="skewX(20)"/>',
    '<rect x="10" y="10" width="60" height="40" rx="10" fill="red"/>',
    '<rect x="10" y="10" width="60" height="40" rx="40" ry="5" fill="red"/>',
    '<rect x="40" y="40" width="20" height="10" fill="red" transform="rotate(30)" transform-origin="50 50"/>',
    '<rect x="10" y="10" width="20" height="10" fill="red" transform="none"/>',
    '<g font-size="10"><rect x="1em" y="2em" width="30%" height="1.5em" fill="red"/></g>',
    '<rect x="1mm" y="1pc" width="20pt" height=".5in" fill="red"/>',
    '<switch><rect systemLanguage="xx" width="90" height="90" fill="red"/>'
    '<rect x="5" y="5" width="20" height="10" fill="blue"/><rect width="90" height="9"/></switch>',
    '<svg x="10%" y="20" width="50%" height="30" viewBox="0 0 10 10">'
    '<rect width="100%" height="50%" fill="green"/></svg>',
    '<svg x="10" y="20" width="50" height="30"><rect width="50%" height="50%" fill="green"/></svg>',
    '<symbol id="s" viewBox="0 0 10 5"><circle cx="5" cy="2.5" r="2" fill="blue"/></symbol>'
    '<use href="#s" x="10" y="10" width="60" height="60"/>',
    '<symbol id="s"><rect width="20" height="10" fill="blue"/></symbol><use xlink:href="#s" x="10" y="15"/>',
    '<defs><rect id="r" width="20" height="10"/></defs><use href="#r" x="9" y="9" fill="red"/>',
    '<defs><g id="r" fill="blue"><rect width="20" height="10"/></g></defs><use href="#r" x="9" fill="red"/>',
    '<path d="M0 0 L nan 3" fill="red"/><use href="http://x/y#z"/>' + rect(" fill='blue'"),
    '<polygon points="1,2 3 x" fill="red"/>' + rect(" fill='blue'"),
    '<g transform="spin(3)">' + rect("") + "</g>" + rect(" fill='blue'"),
]

FRAMES = [
    *((f'width="200" height="200" viewBox="0 0 100 50" preserveAspectRatio="{how}"') for how in ALIGNED),
    *(
        (f'width="200" height="200" viewBox="0 0 100 50" preserveAspectRatio="{how} slice"')
        for how in ALIGNED
    ),
    'width="200" height="200" viewBox="10 5 50 100"',
    'width="200" height="200" viewBox="0 0 100 50" preserveAspectRatio="none"',
    'width="200" height="200"',
    'width="2in" height="2in" viewBox="0 0 80 80"',
]


@pytest.mark.parametrize("body", BODIES)
def test_a_body_is_as_it_is_rendered(body: str) -> None:
    assert assert_same(f'{SVG} viewBox="0 0 100 100">{body}</svg>') >= 1


@pytest.mark.parametrize("frame", FRAMES)
def test_a_frame_is_as_it_is_rendered(frame: str) -> None:
    assert assert_same(f'{SVG} {frame}><rect x="40" y="18" width="20" height="9" fill="red"/></svg>') == 1


@pytest.mark.parametrize(("align", "mode"), [*product(ALIGNED, ("meet", "slice"))])
def test_a_drawing_inside_is_as_it_is_rendered(align: str, mode: str) -> None:
    inner = (
        f'<svg x="10" y="20" width="60" height="30" viewBox="5 5 20 20" preserveAspectRatio="{align} {mode}"'
    )
    x, y = ({"Min": 7, "Mid": 13, "Max": 19}[side] for side in (align[1:4], align[5:8]))
    shape = f'<rect x="{x}" y="{y}" width="5" height="4" fill="red"/></svg>'
    assert assert_same(f'{SVG} viewBox="0 0 100 100">{inner}>{shape}</svg>') == 1


def test_generated_drawings_are_as_they_are_rendered() -> None:
    compared = sum(assert_same(generated(Random(seed))) for seed in range(60))
    assert compared > 80


def generated(chance: Random) -> str:
    """Some shapes, each of a colour of its own, in groups under transforms."""

    def number(low: float, high: float) -> str:
        return f"{chance.uniform(low, high):.{chance.choice((0, 1, 3))}f}"

    def shape() -> str:
        colour = "#" + "".join(f"{chance.randrange(0xD0):02x}" for _channel in "rgb")
        paint = chance.choice((f'fill="{colour}"', f'style="fill:{colour}"'))
        paint += chance.choice(("", ' fill-rule="evenodd"', ' opacity="1"'))
        at = f'x="{number(0, 60)}" y="{number(0, 60)}"'
        match chance.randrange(6):
            case 0:
                return f'<rect {at} width="{number(10, 60)}" height="{number(10, 60)}" {paint}/>'
            case 1:
                return f'<rect {at} width="{number(20, 60)}" height="20" rx="{number(0, 30)}" {paint}/>'
            case 2:
                return f'<circle cx="{number(20, 80)}" cy="{number(20, 80)}" r="{number(8, 40)}" {paint}/>'
            case 3:
                radii = f'rx="{number(8, 40)}" ry="{number(8, 40)}"'
                return f'<ellipse cx="{number(20, 80)}" cy="{number(20, 80)}" {radii} {paint}/>'
            case 4:
                points = " ".join(f"{number(0, 100)},{number(0, 100)}" for _k in range(3))
                return f'<{chance.choice(("polygon", "polyline"))} points="{points}" {paint}/>'
        ends = " ".join(f"C{number(0, 100)} {number(0, 100)} 90 {number(10, 90)} 50 9{k}" for k in range(1))
        return f'<path d="M10 {number(10, 90)}{ends}z" {paint}/>'

    def group(depth: int) -> str:
        inside = "".join(group(depth - 1) if depth and chance.random() < 0.4 else shape() for _k in range(2))
        turned = chance.choice(
            (
                "",
                f'transform="translate({number(-9, 9)},{number(-9, 9)})"',
                f'transform="rotate({number(0, 90)} 50 50)"',
                f'transform="translate(20 20) scale({number(0.4, 1)} .7)"',
                'transform="matrix(.8 .1 -.2 .7 10 10)"',
            )
        )
        return f"<g {turned}>{inside}</g>"

    return f'{SVG} viewBox="0 0 100 100">{group(1)}</svg>'
