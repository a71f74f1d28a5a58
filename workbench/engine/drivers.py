"""The loops around a lowered text: what calls it with which sink. Written behind the text, kept with it.

Each driver takes the algorithm's own arguments last, all of them, in order; its own names begin with ``_``.
"""

from workbench.algorithms.entry import Emits
from workbench.engine.arguments import LISTS, only_numbers

PAINTING: dict[str, str] = {"pixels": "Paint", "coverage": "Blend", "spans": "PaintSpans"}
FIGURES = {"pixels": "PaintFigure", "coverage": "BlendFigure", "spans": "PaintFigureSpans"}

_HEAD = "from workbench.engine.sinks import {names}"

_PLAIN = """
@driver
def _collect(_values, _count, _stop, {arguments}):
    {name}(Collect(_values, _count, _stop), {arguments})

@driver
def _run({arguments}):
    {name}(Nothing(), {arguments})
"""

_COLLECT_MANY = """
@driver
def _collect_many(_values, _count, _stop, _ends, _rows):
    for row in range(len(_rows)):
        if _stop[0] != 0:
            return
        {name}(Collect(_values, _count, _stop), {columns})
        _ends[row] = _count[0]
"""

_PAINTED = """
@driver
def _painted(_sink, {arguments}):
    if not {painter}(_sink, {arguments}):
        {name}(_sink, {arguments})
"""

_PAINT = """
@driver
def _paint(_image, _value, {arguments}):
    {painter}({sink}(_image, _value), {arguments})
"""

_PAINT_WITHIN = """
@driver
def _extent({arguments}):
    return {extent}

@driver
def _paint(_image, _value, {arguments}):
    _height, _width = _image.shape
    _box = _extent({arguments})
    _left, _right = min(_box[0], _box[2]), max(_box[0], _box[2])
    _low, _high = min(_box[1], _box[3]), max(_box[1], _box[3])
    if _left >= 0 and _low >= 0 and _right < _width and _high < _height:
        {painter}(PaintInside(_image, _value), {arguments})
    elif _left < _width and _right >= 0 and _low < _height and _high >= 0:
        {painter}({sink}(_image, _value), {arguments})
"""

_PAINT_MANY = """
@driver
def _paint_many(_image, _value, _stop, _rows):
    for row in range(len(_rows)):
        if _stop[0] != 0:
            return
        _paint(_image, _value, {columns})
"""

_PAINT_BATCH = """
@driver
def _paint_batch(_first, _last, _image, _painter, _bounds, _colours, _numbers, {given}):
    _seen = Bounds(_bounds[0], _bounds[1], _bounds[2], _bounds[3])
    for row in range(_first, _last):
        {painter}({sink}(_image, _painter, _colours[row], _numbers[row], _seen), {items})
"""

_HITS = """
@driver
def _hits(_x, _y, _numbers, _count, _found, _stop, {arguments}):
    {name}({sink}(_x, _y, _numbers, _count, _found, _stop), {arguments})
"""


_COUNT = """
@driver
def _count(_runs, _visits, _blocks, _emitted, _stop, {arguments}):
    {name}(Count(_runs, _visits, _blocks, _emitted, _stop), {arguments})
"""

_PROBE = """
@driver
def _probe(_x, _y, _touches, _found, _rows, _blocks, _steps, _emitted, _stop, {arguments}):
    {name}({sink}(_x, _y, _touches, _found, _rows, _blocks, _steps, _emitted, _stop), {arguments})
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
    name: str,
    parameters: tuple[tuple[str, str | None], ...],
    emits: Emits | None,
    extent: str,
    painter: str,
) -> str:
    """The text of the drivers for the function ``name``, painted where it can by the function ``painter``.

    ``parameters`` are names and kinds; ``extent`` is an expression over them for a box (x_min, y_min, x_max,
    y_max) around everything that is emitted, or empty.
    """
    arguments = ", ".join(parameter for parameter, _kind in parameters)
    columns = ", ".join(_column(k, kind) for k, (_n, kind) in enumerate(parameters))
    used = ["Collect", "Nothing"]

    def filled(template: str, **further: str) -> str:
        return template.format(name=name, painter=painter, arguments=arguments, columns=columns, **further)

    text = filled(_PLAIN)
    if painter:
        text += filled(_PAINTED)
    painter = "_painted" if painter else name
    numbers = only_numbers(parameters)
    if numbers:
        text += filled(_COLLECT_MANY)
    if emits in PAINTING:
        sink = PAINTING[emits]
        used.append(sink)
        if extent and emits == "pixels":
            used.append("PaintInside")
            text += filled(_PAINT_WITHIN, sink=sink, extent=extent)
        else:
            text += filled(_PAINT, sink=sink)
        if numbers:
            text += filled(_PAINT_MANY)
        if takes_batches(parameters):
            used += ["Bounds", FIGURES[emits]]
            text += _paint_batch(painter, parameters, FIGURES[emits])
    if emits in ("pixels", "coverage", "fragments", "spans"):
        sink = "HitSpan" if emits == "spans" else "Hit"
        used.append(sink)
        text += filled(_HITS, sink=sink)
    return _HEAD.format(names=", ".join(sorted(used))) + "\n" + text


def takes_batches(parameters: tuple[tuple[str, str | None], ...]) -> bool:
    """Whether each parameter, (name, kind), is a number or a list: no call writes what another reads."""
    return all(kind in LISTS or only_numbers([(name, kind)]) for name, kind in parameters)


def _paint_batch(painter: str, parameters: tuple[tuple[str, str | None], ...], sink: str) -> str:
    """The text of the driver that paints many figures; see ``batches`` for what it is given."""
    given, items, numbers = ["_rows"], [], 0
    for parameter, kind in parameters:
        if kind in LISTS:
            given += [f"_{parameter}", f"_starts_{parameter}"]
            starts = f"_starts_{parameter}"
            items.append(f"_{parameter}[{starts}[row] : {starts}[row + 1]]")
        else:
            items.append(_column(numbers, kind))
            numbers += 1
    return _PAINT_BATCH.format(painter=painter, sink=sink, given=", ".join(given), items=", ".join(items))


def _column(number: int, kind: str | None) -> str:
    item = f"_rows[row, {number}]"
    return f"float({item})" if kind == "float" else f"bool({item})" if kind == "bool" else f"int({item})"
