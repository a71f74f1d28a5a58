"""Tables as text, CSV, JSON and for the clipboard: the hand table of a run, or any other.

Text and clipboard show numbers as the course writes them; CSV and JSON keep every digit.
"""

import csv
import html
import io
import json
import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from workbench.algorithms.numerals import decimal

_SUBSCRIPTS = str.maketrans("0123456789+-−=()aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ")
_SUPERSCRIPTS = str.maketrans("0123456789+-−=()nr", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁼⁽⁾ⁿʳ")
_RAISED_OR_LOWERED = re.compile(r"([_^])(?:\{([^}]*)\}|(\w))")


@dataclass(frozen=True, slots=True)
class Table:
    """Headings, and rows as long; ``formulas`` tells that they are written as in an entry: ``x_{k+1}``."""

    columns: tuple[str, ...]
    rows: Sequence[tuple[Any, ...]]
    formulas: bool = True

    def computed(self) -> "Table":
        """The same, with every row at hand that is otherwise computed when it is read."""
        return replace(self, rows=list(self.rows))

    def headings(self, subscripts: bool) -> list[str]:
        """The headings with real subscripts, or in plain characters."""
        if not self.formulas:
            return list(self.columns)
        return [typeset(column) if subscripts else plain(column) for column in self.columns]


def typeset(heading: str) -> str:
    """A heading with real sub- and superscripts: pₖ. What has no such character keeps its plain form."""

    def placed(match: re.Match[str]) -> str:
        sign, text = match[1], match[2] or match[3]
        small = text.translate(_SUBSCRIPTS if sign == "_" else _SUPERSCRIPTS)
        return f"{sign}{text}" if any(character in text for character in small) else small

    return _RAISED_OR_LOWERED.sub(placed, heading)


def plain(heading: str) -> str:
    """A heading without braces: p_k, x_k+1."""
    return _RAISED_OR_LOWERED.sub(lambda match: match[1] + (match[2] or match[3]), heading)


def shown(value: Any) -> str:
    """Any value of a table as a person reads it; a pair of coordinates is (x, y), a picture its size."""
    if isinstance(value, np.generic):
        return shown(value.item())
    if isinstance(value, int | float) and not isinstance(value, bool):
        return decimal(value)
    if isinstance(value, np.ndarray):
        return " × ".join(str(size) for size in reversed(value.shape))
    if isinstance(value, tuple):
        return f"({', '.join(shown(part) for part in value)})"
    if isinstance(value, list):
        return f"[{', '.join(shown(part) for part in value)}]"
    return "" if value is None else str(value)


def to_text(table: Table, subscripts: bool = True) -> str:
    """Columns lined up, numbers to the right, one heading line. Ends in a newline."""
    cells = [table.headings(subscripts)]
    cells += [[shown(value) for value in row] for row in table.rows]
    right = [_numeric(table, index) for index in range(len(table.columns))]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    lines = (
        "  ".join(
            cell.rjust(width) if is_number else cell.ljust(width)
            for cell, width, is_number in zip(row, widths, right, strict=True)
        ).rstrip()
        for row in cells
    )
    return "\n".join(lines) + "\n"


def to_csv(table: Table) -> str:
    """Comma-separated, one heading line, every digit kept; a pair keeps its parentheses."""
    return _separated(table, ",", _exact)


def to_tsv(table: Table) -> str:
    """Tab-separated, as spreadsheets and word processors take it from the clipboard."""
    return _separated(table, "\t", shown)


def to_html(table: Table) -> str:
    """An HTML table, for the clipboard: pastes as a table where tabs would not."""
    head = "".join(f"<th>{html.escape(heading)}</th>" for heading in table.headings(subscripts=True))
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(shown(value))}</td>" for value in row) + "</tr>"
        for row in table.rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def to_json(table: Table) -> str:
    """An object with ``columns`` and ``rows``. A number JSON cannot write (infinity) becomes its name."""
    content = {
        "columns": table.headings(subscripts=False),
        "rows": [[_json_value(value) for value in row] for row in table.rows],
    }
    return json.dumps(content, ensure_ascii=False) + "\n"


def _numeric(table: Table, index: int) -> bool:
    return any(isinstance(row[index], int | float | np.integer | np.floating) for row in table.rows)


def _separated(table: Table, separator: str, text: Any) -> str:
    lines = io.StringIO()
    writer = csv.writer(lines, delimiter=separator, lineterminator="\n")
    writer.writerow(table.headings(subscripts=False))
    writer.writerows([text(value) for value in row] for row in table.rows)
    return lines.getvalue()


def _exact(value: Any) -> str:
    plain_value = _json_value(value)
    if isinstance(plain_value, list):
        inside = ", ".join(map(_exact, plain_value))
        return f"({inside})" if isinstance(value, tuple) else f"[{inside}]"
    return "" if plain_value is None else str(plain_value)


def _json_value(value: Any) -> Any:
    if isinstance(value, np.ndarray | np.generic):
        return _json_value(value.tolist())
    if isinstance(value, Iterable) and not isinstance(value, str):
        return [_json_value(part) for part in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value if isinstance(value, bool | int | float | str | None) else str(value)
