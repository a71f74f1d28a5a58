"""Rows of matrices as LaTeX, as NumPy and as plain text. What is hidden stays hidden in a copy."""

import ast
import math
import re
from collections.abc import Iterable

from workbench.exchange.formulas.notation import GREEK, Formula, Piece, parse, parted
from workbench.exchange.formulas.terms import Cell, Matrix, Phrase, Shows, Sign, Term, Terms

_GREEK_NAMES = {letter: name for name, letter in GREEK.items()}
_LATEX = {
    "−": "-",
    "·": r"\cdot",
    "≤": r"\le",
    "≥": r"\ge",
    "≠": r"\ne",
    "→": r"\to",
    "±": r"\pm",
    "≈": r"\approx",
    "…": r"\dots",
    "°": r"^{\circ}",
    "%": r"\%",
    "_": r"\_",
    "^": r"\hat{}",
    "&": r"\&",
    "#": r"\#",
    "$": r"\$",
    "~": r"\sim",
    "\\": r"\backslash",
    "{": r"\{",
    "}": r"\}",
    "′": "'",
}
_LATEX_FUNCTIONS = {
    "atan2": r"\operatorname{atan2}",
    "sqrt": r"\operatorname{sqrt}",
    "floor": r"\operatorname{floor}",
}
_NUMPY_FUNCTIONS = {"ln": "log", "det": "linalg.det", "atan2": "arctan2"}
_NO_NUMPY = frozenset({"cot"})
_PYTHON = {"−": "-", "·": "*", "[": "(", "]": ")", "{": "(", "}": ")"}
_COMMAND = re.compile(r"\\[a-z]+$", re.IGNORECASE)
_PYTHON_WORDS = frozenset({"lambda", "as", "in", "is", "if", "or"})


# LaTeX


def latex(terms: Terms, shows: Shows = "both") -> str:
    """One line of LaTeX for mathematics mode; it asks for the package amsmath."""
    return " ".join(_latex_term(term, shows) for term in terms)


def latex_formula(text: str) -> str:
    """A formula as LaTeX for mathematics mode."""
    return _latex(parse(text))


def _latex_term(term: Term, shows: Shows) -> str:
    match term:
        case Sign():
            return _latex(parse(term.text))
        case Phrase():
            formula = _latex(parse(term.formula))
            return rf"\mathbf{{{formula}}}" if term.strong else formula
        case Matrix():
            rows = r" \\ ".join(" & ".join(_latex_cell(cell, shows) for cell in row) for row in term.cells)
            body = rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"
            if not term.name:
                return body
            side = "overset" if term.named == "over" else "underset"
            return rf"\{side}{{{_latex(parse(term.name))}}}{{{body}}}"


def _latex_cell(cell: Cell, shows: Shows) -> str:
    symbol, figure = (_latex(parse(text)) for text in cell.seen(shows))
    return rf"\substack{{{symbol} \\ {figure}}}" if symbol and figure else symbol or figure


def _latex(formula: Formula) -> str:
    text, before = "", None
    for piece in formula:
        own = _latex_piece(piece)
        # A command ends at what is no letter
        runs_on = own[0].isalpha() and _COMMAND.search(text) is not None
        text += (" " if runs_on or parted(before, piece) else "") + own
        before = piece
    return text


def _latex_piece(piece: Piece) -> str:
    match piece.kind:
        case "variable":
            name = _GREEK_NAMES.get(piece.text)
            text = f"\\{name}" if name else piece.text
        case "function":
            text = _LATEX_FUNCTIONS.get(piece.text, f"\\{piece.text}")
        case "word":
            text = rf"\mathrm{{{''.join(_LATEX.get(c, '~' if c == ' ' else c) for c in piece.text)}}}"
        case _:
            text = "".join(_LATEX.get(character, character) for character in piece.text)
    below = f"_{{{_latex(piece.below)}}}" if piece.below else ""
    above = f"^{{{_latex(piece.above)}}}" if piece.above else ""
    return text + below + above


# Plain text


def plain(terms: Terms, shows: Shows = "both") -> str:
    """Lines of text with the matrices side by side, their columns lined up; no newline at the end."""
    blocks = [_block(term, shows) for term in terms]
    high = max((len(block) for block in blocks), default=0)
    lines = [""] * high
    for block in blocks:
        wide = max(map(len, block))
        above = (high - len(block)) // 2
        for k in range(high):
            inside = block[k - above] if above <= k < above + len(block) else ""
            lines[k] += ("  " if lines[k] or block is not blocks[0] else "") + inside.ljust(wide)
    return "\n".join(line.rstrip() for line in lines).strip("\n")


def plain_formula(text: str) -> str:
    """A formula as a line of text: ``x_p(1 − cos θ) + y_p sin θ``."""
    return _plain(parse(text))


def cell_text(cell: Cell, shows: Shows = "both") -> str:
    """What a cell says, its number behind its symbol."""
    symbol, figure = (_plain(parse(text)) for text in cell.seen(shows))
    return f"{symbol} = {figure}" if symbol and figure else symbol or figure


def _block(term: Term, shows: Shows) -> list[str]:
    match term:
        case Sign():
            return [plain_formula(term.text)]
        case Phrase():
            return [plain_formula(term.formula)]
        case Matrix():
            cells = [[cell_text(cell, shows) for cell in row] for row in term.cells]
            widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
            rows = [
                "[ " + "  ".join(text.rjust(w) for text, w in zip(row, widths, strict=True)) + " ]"
                for row in cells
            ]
            name = [plain_formula(term.name).center(len(rows[0]))] if term.name else []
            # A line without words on the other side keeps the rows in the middle of the line
            beside = [""] * len(name)
            return [*name, *rows, *beside] if term.named == "over" else [*beside, *rows, *name]


def _plain(formula: Formula) -> str:
    text, before = "", None
    for piece in formula:
        below = f"_{_plain(piece.below)}".replace(" ", "") if piece.below else ""
        above = f"^{_plain(piece.above)}".replace(" ", "") if piece.above else ""
        text += (" " if parted(before, piece) else "") + piece.text + below + above
        before = piece
    return text


# NumPy


def numpy_text(terms: Terms) -> str:
    """The matrices as NumPy arrays with every digit, each under its name where that is a plain name.

    A cell without a number is its formula in Python, or not a number where it has none.
    """
    lines = []
    matrices = [term for term in terms if isinstance(term, Matrix)]
    for term in matrices:
        rows = ",\n".join("    [" + ", ".join(_numpy_cell(cell) for cell in row) + "]" for row in term.cells)
        name = _plain(parse(term.name))
        lead = f"{name} = " if name.isidentifier() else f"# {name}\n" if name else ""
        lines.append(f"{lead}np.array([\n{rows},\n])")
    return "\n".join(lines)


def _numpy_cell(cell: Cell) -> str:
    if cell.hidden:
        return "np.nan"
    if cell.value is not None:
        return repr(cell.value + 0.0) if math.isfinite(cell.value) else f"np.{cell.value}"
    expression = _python(parse(cell.symbol))
    return expression if _is_expression(expression) else "np.nan"


def _is_expression(text: str) -> bool:
    try:
        ast.parse(text, mode="eval")
    except (SyntaxError, ValueError):
        return False
    return True


def _python(formula: Formula) -> str:
    """A formula as Python: products get their sign, functions their parentheses. It may be no expression."""
    text, before = "", None
    rest = list(formula)
    while rest:
        piece = rest.pop(0)
        starts = piece.kind in ("variable", "number", "function", "word", "open")
        ends = before is not None and before.kind in ("variable", "number", "word", "close", "mark")
        if starts and ends:
            text += "*"
        elif piece.kind == "operator" and piece.text in "+−":
            text += " "
        text += _python_piece(piece)
        if piece.kind == "operator" and piece.text in "+−":
            text += " "
        if piece.kind == "function" and rest and rest[0].kind != "open":
            argument = _argument(rest)
            del rest[: len(argument)]
            text += f"({_python(argument)})"
            piece = Piece(")", "close")
        before = piece
    return text


def _argument(rest: Iterable[Piece]) -> Formula:
    """What a function without parentheses is of: a sign, numbers, and the first name."""
    argument: list[Piece] = []
    for piece in rest:
        if piece.kind not in ("sign", "number", "variable", "word"):
            break
        argument.append(piece)
        if piece.kind in ("variable", "word"):
            break
    return tuple(argument)


def _python_piece(piece: Piece) -> str:
    text = _GREEK_NAMES.get(piece.text, piece.text)
    if piece.kind == "function" and text not in _NO_NUMPY:
        text = f"np.{_NUMPY_FUNCTIONS.get(text, text)}"
    elif text in _PYTHON_WORDS:
        text += "_"
    text = "".join(_PYTHON.get(character, character) for character in text)
    below = "_" + re.sub(r"\W+", "_", _plain(piece.below)) if piece.below else ""
    above = f"**({_python(piece.above)})" if piece.above else ""
    return text + below + above
