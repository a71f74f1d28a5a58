"""Points in and out: the ways in which tables write numbers, and where a wrong one is."""

import codecs

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.document.errors import DocumentError
from workbench.exchange.point_lists import PointsError, read_points, text_of, write_points

number = st.floats(-1e6, 1e6)


@given(st.lists(st.tuples(number, number), min_size=1, max_size=20), st.sampled_from(",;\t "))
def test_points_come_back_with_every_digit(points: list[tuple[float, float]], separator: str) -> None:
    assert np.array_equal(read_points(write_points(points, separator)), np.array(points))


@given(st.lists(st.tuples(number, number), min_size=1, max_size=9), st.sampled_from([";", "\t", "; ", " \t"]))
def test_a_decimal_comma_is_understood(points: list[tuple[float, float]], separator: str) -> None:
    text = "".join(f"{x:.3f}{separator}{y:.3f}\n".replace(".", ",") for x, y in points)
    assert read_points(text).tolist() == [[float(f"{x:.3f}"), float(f"{y:.3f}")] for x, y in points]


@pytest.mark.parametrize(
    "text",
    [
        "1,2\n3,4.5",
        "x;y\r\n1;2\r\n3;4,5\r\n",
        "x\ty\n1\t2\n3\t4.5\n\n",
        "  1   2 # first\n\n# nothing\n3 4.5",
        "1, 2\n3, 4.5",
        '"x","y"\n"1","2"\n3,4.5',
        "\ufeffx,y\n1,2\n3,4.5",
        "1,0 2,0\n3,0 4,5",
        "1;2;\n3;4.5;",
        "+1e0 20e-1\n3. 4.50",
        "sep=;\nx;y\n1;2\n3;4,5",
        '"1,0","2,0"\n"3,0","4,5"',
        "1,2,\n3,4.5,,",
        "1 2\t# first\n3 4.5 \t # second",
        "1st coordinate, 2nd coordinate\n1, 2\n3, 4.5",
        "(1, 2)\n(3, 4.5)",
        "[1; 2],\n[3; 4,5]",
        "[[1, 2], [3, 4.5]]",
        "\ufeff[\n [\n  1,\n  2\n ],\n [3, 4.5]\n]",
    ],
)
def test_tables_are_written_in_many_ways(text: str) -> None:
    assert read_points(text).tolist() == [[1, 2], [3, 4.5]]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-be", "cp1252"])
def test_tables_are_saved_in_many_ways(encoding: str) -> None:
    content = "Länge;Höhe\n1;2\n3;4,5".encode(encoding)
    content = codecs.BOM_UTF16_BE + content if encoding == "utf-16-be" else content
    assert read_points(text_of(content, "table.csv")).tolist() == [[1, 2], [3, 4.5]]
    with pytest.raises(DocumentError, match=r"table\.csv is not UTF-8 text"):
        text_of(b"\xff\0\x80", "table.csv")


def test_a_minus_sign_may_be_typeset() -> None:
    assert read_points("\u22121 2").tolist() == [[-1, 2]]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "There are no points"),
        (" \n\n# nothing", "There are no points"),
        ("x,y\n", "a heading but no points"),
        ("1,2\n3,abc", "Line 2, column 2: 'abc' is not a number"),
        ("x;y\n1;2\n\nnan;4", "Line 4, column 1: 'nan' is not a number"),
        ("1 2\n3 inf", "Line 2, column 2: 'inf'"),
        ("1,2\n3", "Line 2: there is only one value; give x and y with a comma between them."),
        ("3,4\n20,30\n40;12", "Line 1: there is only one value; give x and y with a semicolon between them."),
        ("1\t2\n3", "Line 2: there is only one value; give x and y with a tab between them."),
        ("1 2\n3", "Line 2: there is only one value; give x and y with a blank between them."),
        ("1,2\n3,4,5", "Line 2: there are 3 values"),
        ("1,2\n1e7,4", "Line 2, column 1: '1e7' is outside ±1,000,000"),
        ("1 2\n3 1e999", "Line 2, column 2: '1e999' is outside"),
        ("1\t\n2\t3", "Line 1, column 2: '' is not a number"),
        ("0 0\n" * 100_001, "more than 100,000 points"),
    ],
)
def test_what_is_wrong_is_said_with_its_place(text: str, said: str) -> None:
    with pytest.raises(PointsError) as refused:
        read_points(text)
    assert said in str(refused.value)
