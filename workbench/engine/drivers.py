"""The loops around a lowered text: what calls it with which sink. They are written behind the text and kept with it.

Each driver takes the algorithm's own arguments last, all of them, in order.
"""

from workbench.algorithms.entry import Emits

PAINTING: dict[str, str] = {"pixels": "Paint", "coverage": "Blend", "spans": "PaintSpans"}

_HEAD = "from workbench.engine.sinks import {names}"

_PLAIN = """
@reading
def _collect(values, count, stop, {arguments}):
    {name}(Collect(values, count, stop), {arguments})

@reading
def _run(stop, {arguments}):
    {name}(Nothing(stop), {arguments})
"""

_PAINT = """
@reading
def _paint(image, value, {arguments}):
    {name}({sink}(image, value), {arguments})
"""

_PAINT_WITHIN = """
@reading
def _extent({arguments}):
    return {extent}

@reading
def _paint(image, value, {arguments}):
    height, width = image.shape
    box = _extent({arguments})
    left, right = min(box[0], box[2]), max(box[0], box[2])
    low, high = min(box[1], box[3]), max(box[1], box[3])
    if left >= 0 and low >= 0 and right < width and high < height:
        {name}(PaintInside(image, value), {arguments})
    elif left < width and right >= 0 and low < height and high >= 0:
        {name}({sink}(image, value), {arguments})
"""

_PAINT_MANY = """
@reading
def _paint_many(image, value, stop, rows):
    for row in range(len(rows)):
        if stop[0] != 0:
            raise Stopped
        _paint(image, value, {columns})
"""

_HITS = """
@reading
def _hits(x, y, numbers, count, found, stop, {arguments}):
    {name}({sink}(x, y, numbers, count, found, stop), {arguments})
"""


_COUNT = """
@reading
def _count(runs, visits, blocks, emitted, stop, {arguments}):
    {name}(Count(runs, visits, blocks, emitted, stop), {arguments})
"""

_PROBE = """
@reading
def _probe(x, y, touches, found, rows, blocks, steps, emitted, stop, {arguments}):
    {name}({sink}(x, y, touches, found, rows, blocks, steps, emitted, stop), {arguments})
"""


def ticking_drivers(
    name: str, parameters: tuple[tuple[str, str | None], ...], emits: Emits | None, probing: bool
) -> str:
    """The text of the driver for the counting text of ``name``, or for its probing text."""
    sink = "Count" if not probing else "ProbeSpan" if emits == "spans" else "ProbePixel"
    arguments = ", ".join(parameter for parameter, _kind in parameters)
    text = (_PROBE if probing else _COUNT).format(name=name, arguments=arguments, sink=sink)
    return _HEAD.format(names=sink) + "\n" + text


def drivers(
    name: str, parameters: tuple[tuple[str, str | None], ...], emits: Emits | None, extent: str
) -> str:
    """The text of the drivers for the function ``name``.

    ``parameters`` are names and kinds; ``extent`` is an expression over them for (x_min, y_min, x_max, y_max) of
    everything that is emitted, or empty.
    """
    arguments = ", ".join(parameter for parameter, _kind in parameters)
    fields = {"name": name, "arguments": arguments}
    used = ["Collect", "Nothing", "Stopped"]
    text = _PLAIN.format(**fields)
    if emits in PAINTING:
        sink = PAINTING[emits]
        used.append(sink)
        if extent and emits == "pixels":
            used.append("PaintInside")
            text += _PAINT_WITHIN.format(**fields, sink=sink, extent=extent)
        else:
            text += _PAINT.format(**fields, sink=sink)
        if all(kind in ("int", "float", "bool", "colour") for _name, kind in parameters):
            text += _PAINT_MANY.format(
                columns=", ".join(_column(k, kind) for k, (_n, kind) in enumerate(parameters))
            )
    if emits in ("pixels", "coverage", "fragments", "spans"):
        sink = "HitSpan" if emits == "spans" else "Hit"
        used.append(sink)
        text += _HITS.format(**fields, sink=sink)
    return _HEAD.format(names=", ".join(sorted(used))) + "\n" + text


def _column(number: int, kind: str | None) -> str:
    item = f"rows[row, {number}]"
    return f"float({item})" if kind == "float" else f"bool({item})" if kind == "bool" else f"int({item})"
