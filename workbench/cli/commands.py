"""The commands and their options."""

import argparse
import os
import re
import sys
from collections.abc import Collection, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from workbench import __version__
from workbench.cli.failure import BadInputError, WorkError
from workbench.language import _, legible

if TYPE_CHECKING:
    from workbench.document.model import Sheet

PROGRAM = "graphics-workbench"
_LONGEST_SENTENCE = 500  # whatever was typed and is quoted in it


class _Parser(argparse.ArgumentParser):
    commands: Collection[str] = ()

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        # What argparse holds for a number and not for an option: any that Python writes.
        self._negative_number_matcher = re.compile(r"-\.?[0-9]")

    def error(self, message: str) -> NoReturn:
        raise BadInputError(f"{message.rstrip('.')} ({self.prog} --help tells more)")


def main(arguments: Sequence[str]) -> int:
    """Run one command. 0 when it worked; else one line on standard error and 2 for bad input, 1 otherwise."""
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="replace")  # what the terminal cannot show stops nothing
    try:
        try:
            parser = _parser()
            if arguments and arguments[0] not in parser.commands and os.path.lexists(arguments[0]):
                raise BadInputError(_why_not_opened(arguments[0]))
            options = parser.parse_args(arguments)
        except SystemExit as told:  # --help and --version have printed
            _print("")
            return int(told.code or 0)
        _print(options.run(options))
    except (BadInputError, WorkError) as failure:
        with suppress(OSError):
            sentence = legible(str(failure), _LONGEST_SENTENCE)
            print(f"{PROGRAM}: {sentence}", file=sys.stderr, flush=True)
        return 2 if isinstance(failure, BadInputError) else 1
    except BrokenPipeError:
        return 141
    except KeyboardInterrupt:
        return 130
    return 0


def _why_not_opened(word: str) -> str:
    """Why what this word names opens no window."""
    from workbench.document.errors import DocumentError
    from workbench.document.storage.content import check_file
    from workbench.exchange.readable import SUFFIXES

    try:
        check_file(word, sys.maxsize)
    except DocumentError as problem:
        return problem.short
    sentence = _("{path} is not of a kind that can be opened; choose a file that ends in {endings}.")
    return sentence.format(path=word, endings=", ".join(SUFFIXES))


def _print(text: str) -> None:
    """Print ``text``, and whatever still waits. Raises WorkError, and BrokenPipeError when nobody reads."""
    if not sys.stdout:
        raise WorkError(_("the result cannot be printed, since the output is closed; open it."))
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        # What Python still wants to flush on leaving goes nowhere.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            raise
        sentence = _("the result cannot be printed ({reason}); send it elsewhere.")
        raise WorkError(sentence.format(reason=error.strerror)) from error


def _parser() -> _Parser:
    parser = _Parser(prog=PROGRAM, description=_("Without a command, the window opens."))
    parser.add_argument("--version", action="version", version=f"Graphics Workbench {__version__}")
    commands = parser.add_subparsers(title=_("commands"), metavar="COMMAND", required=True)

    listing = commands.add_parser("list", help=_("every algorithm: slug, topic, title"))
    listing.set_defaults(run=_list)

    trace = commands.add_parser("trace", help=_("the hand table of a run, what it emits, or its lines"))
    trace.add_argument("slug", metavar="SLUG", help=_("the algorithm, as list names it"))
    trace.add_argument(
        "words",
        metavar="ARG",
        nargs="*",
        help=_("a Python literal, or @file; without any, an example is run"),
    )
    trace.add_argument("--table", choices=("hand", "pixels", "lines"), default="hand")
    trace.add_argument("--format", choices=("text", "csv", "json"), default="text")
    trace.set_defaults(run=_trace)

    draw = commands.add_parser("draw", help=_("renders a document without a window"))
    draw.add_argument("document", metavar="FILE.gwb", type=Path)
    draw.add_argument("-o", "--output", metavar="OUT.png", type=Path, required=True)
    draw.add_argument(
        "--sheet", metavar="NUMBER", type=_whole, default=1, help=_("which sheet, counted from 1")
    )
    draw.add_argument(
        "--cell", metavar="SIZE", type=_whole, default=1, help=_("each pixel becomes SIZE x SIZE")
    )
    draw.set_defaults(run=_draw)

    moving = commands.add_parser("animate", help=_("a sheet that moves, as a GIF or a PNG for each frame"))
    moving.add_argument("document", metavar="FILE.gwb", type=Path)
    moving.add_argument(
        "-o", "--output", metavar="OUT", type=Path, required=True, help=_(".gif, or .png for each frame")
    )
    moving.add_argument("--size", metavar="WxH", type=_size, help=_("pixels of each picture"))
    moving.add_argument("--rate", metavar="N", type=_number, help=_("pictures per second"))
    moving.add_argument(
        "--sheet", metavar="NUMBER", type=_whole, default=1, help=_("which sheet, counted from 1")
    )
    moving.add_argument("--contacts", action="store_true", help=_("one PNG with up to 24 frames"))
    moving.set_defaults(run=_animate)

    change = commands.add_parser("convert", help=_("SVG or points to a document, a document to SVG"))
    change.add_argument("file", metavar="IN", type=Path, help=_("a .gwb, .svg, .csv, .tsv or .txt file"))
    change.add_argument(
        "-o", "--output", metavar="OUT", type=Path, required=True, help=_("a .gwb or .svg file")
    )
    change.add_argument(
        "--sheet", metavar="NUMBER", type=_whole, default=1, help=_("which sheet, counted from 1")
    )
    change.add_argument(
        "--tolerance",
        metavar="T",
        type=_number,
        help=_("largest error, in world units, where it is not exact"),
    )
    change.add_argument(
        "--size", metavar="WxH", type=_size, help=_("size in pixels of the sheet that is made")
    )
    change.set_defaults(run=_convert)

    shape = commands.add_parser("surface", help=_("a surface as a mesh of triangles"))
    shape.add_argument("surface", metavar="SURFACE", help=_("an example, such as sphere, or a JSON file"))
    shape.add_argument(
        "-o", "--output", metavar="OUT", type=Path, required=True, help=_(".obj, .ply or .stl")
    )
    shape.add_argument(
        "--tolerance",
        metavar="T",
        type=_number,
        default=0.01,
        help=_("largest distance from the true surface"),
    )
    shape.set_defaults(run=_surface)

    render = commands.add_parser("render", help=_("a mesh or a scene as a picture"))
    render.add_argument("model", metavar="MODEL", type=Path, help=_("a mesh file, or a .gwb with a scene"))
    render.add_argument(
        "-o", "--output", metavar="OUT", type=Path, required=True, help=_(".png, or its lines as .svg")
    )
    render.add_argument("--projection", metavar="NAME", help=_("such as perspective, isometric, cabinet"))
    render.add_argument(
        "--visibility", metavar="SLUG", default="depth_buffer", help=_("the method for hidden surfaces")
    )
    render.add_argument("--shading", metavar="NAME", default="flat")
    render.add_argument("--size", metavar="WxH", type=_size, help=_("pixels of the picture"))
    render.add_argument("--depth", metavar="OUT.png", type=Path, help=_("the depths, white is near"))
    render.add_argument("--eye", metavar="X,Y,Z", type=_point)
    render.add_argument("--look-at", metavar="X,Y,Z", type=_point)
    render.add_argument(
        "--sheet", metavar="NUMBER", type=_whole, default=1, help=_("which sheet, counted from 1")
    )
    render.set_defaults(run=_render)

    commands.add_parser("tour", help=_("a picture of every workspace"))
    parser.commands = commands.choices
    return parser


def _whole(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        sentence = _("{text!r} is not a whole number; write one such as 8")
        raise argparse.ArgumentTypeError(sentence.format(text=text[:20])) from None


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        sentence = _("{text!r} is not a number; write one such as 0.5")
        raise argparse.ArgumentTypeError(sentence.format(text=text[:20])) from None


def _size(text: str) -> tuple[int, int]:
    from workbench.cli.conversions import size

    return size(text)


def _point(text: str) -> object:
    from workbench.cli.rendering import point

    return point(text)


def _render(options: argparse.Namespace) -> str:
    from workbench.cli.rendering import render_model

    return render_model(options)


def _convert(options: argparse.Namespace) -> str:
    from workbench.cli.conversions import convert

    return convert(options)


def _surface(options: argparse.Namespace) -> str:
    from workbench.cli.conversions import surface

    return surface(options)


def _list(options: argparse.Namespace) -> str:
    from workbench.algorithms import catalogue
    from workbench.exchange.tables import Table, to_text

    rows = [(entry.slug, entry.topic, _(entry.title)) for entry in catalogue.entries()]
    return to_text(Table((_("slug"), _("topic"), _("title")), rows, formulas=False))


def _trace(options: argparse.Namespace) -> str:
    from workbench.algorithms import catalogue
    from workbench.cli import traces
    from workbench.cli.arguments import read_arguments
    from workbench.exchange import tables

    try:
        entry = catalogue.get(options.slug)
    except LookupError as error:
        raise BadInputError(error.args[0]) from None
    recording = traces.run(entry, read_arguments(entry, options.words))
    table = traces.TABLES[options.table](entry, recording)
    if options.format == "text":
        text = tables.to_text(table, subscripts=_writes_subscripts())
        return text if table.rows else text + _("No rows: with these arguments nothing is drawn.") + "\n"
    return tables.to_csv(table) if options.format == "csv" else tables.to_json(table)


def _writes_subscripts() -> bool:
    return (sys.stdout.encoding or "").lower().replace("-", "").startswith("utf")


def _draw(options: argparse.Namespace) -> str:
    from workbench.cli import outputs
    from workbench.document.stand_ins import stand_ins
    from workbench.exchange.pictures import refuse_cell
    from workbench.rendering import frame_buffer

    file_format = outputs.format_for("picture", path=options.output)
    sheet = _sheet(options)
    try:
        refuse_cell((sheet.height_px, sheet.width_px), options.cell)
    except ValueError as error:
        raise BadInputError(str(error)) from None
    outputs.write(file_format, (frame_buffer(sheet), options.cell), options.output)
    return "\n".join(stand_ins([sheet]))


def _sheet(options: argparse.Namespace) -> "Sheet":
    """The sheet of a document that is asked for."""
    from workbench.cli.sheets import sheet_of
    from workbench.document import DocumentError, load

    try:
        document = load(options.document)
    except DocumentError as error:
        raise BadInputError(f"{options.document}: {error}") from None
    except OSError as error:
        raise BadInputError(f"{options.document}: {error.strerror}") from None
    return sheet_of(document, options.document, options.sheet)


def _animate(options: argparse.Namespace) -> str:
    from workbench.cli import outputs
    from workbench.exchange.moving_sheets import MovingSheet, Size

    kind = "contacts" if options.contacts else "animation"
    file_format = outputs.format_for(kind, path=options.output)
    sheet = _sheet(options)
    if sheet.motion is None:
        raise BadInputError(_("{file}: nothing moves on this sheet.").format(file=options.document))
    rate = options.rate
    if rate is not None and not rate > 0.0:
        sentence = _("The rate is {rate:g}; give a number of pictures per second above 0.")
        raise BadInputError(sentence.format(rate=rate))
    try:
        content = MovingSheet(sheet, options.size and Size(*options.size), rate or 0.0)
    except ValueError as error:
        raise BadInputError(str(error)) from None
    outputs.write(file_format, content, options.output)
    return ""
