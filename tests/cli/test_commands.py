"""The commands as a person gives them: what they print, where, and how they end."""

import csv
import io
import json
import os
import socket
import subprocess
import sys
from pathlib import Path

import cv2
import pytest

from workbench.__main__ import main
from workbench.algorithms import catalogue
from workbench.document import save
from workbench.document.samples.examples import example_document
from workbench.exchange.readable import SUFFIXES
from workbench.rendering import frame_buffer

PICTURE = """
0000000
0011100
0010100
0010100
0011100
0000000
"""


def refused(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """The one line that a command with bad input says on standard error."""
    assert main(words) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("graphics-workbench: ")
    assert said.err.endswith("\n")
    assert said.err.count("\n") == 1
    return said.err


def printed(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(words) == 0
    said = capsys.readouterr()
    assert said.err == ""
    return said.out


def test_list_names_every_entry(capsys: pytest.CaptureFixture[str]) -> None:
    heading, *lines = printed(capsys, "list").splitlines()
    assert heading.split() == ["slug", "topic", "title"]
    assert [line.split()[0] for line in lines] == [entry.slug for entry in catalogue.entries()]
    assert all(entry.title in line for entry, line in zip(catalogue.entries(), lines, strict=True))


def test_hand_table_of_the_course_books(capsys: pytest.CaptureFixture[str]) -> None:
    heading, *lines = printed(capsys, "trace", "bresenham_line", "20", "10", "30", "18").splitlines()
    assert heading.split()[:2] in (["k", "pₖ"], ["k", "p_k"])
    rows = [line.split(maxsplit=2) for line in lines]
    assert [int(p) for _, p, _ in rows] == [6, 2, -2, 14, 10, 6, 2, -2, 14, 10]
    assert [int(k) for k, _, _ in rows] == list(range(10))
    reached = ["(21, 11)", "(22, 12)", "(23, 12)", "(24, 13)", "(25, 14)"]
    reached += ["(26, 15)", "(27, 16)", "(28, 16)", "(29, 17)", "(30, 18)"]
    assert [pixel for _, _, pixel in rows] == reached


def test_without_arguments_the_entry_s_own_example_is_traced(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(("trace", "bresenham_line")) == 0
    example = capsys.readouterr().out
    assert main(("trace", "bresenham_line", *map(str, catalogue.get("bresenham_line").example))) == 0
    assert capsys.readouterr().out == example
    assert main(("trace", "depth_sort")) == 0
    assert capsys.readouterr().out.splitlines()[0].split()[:3] == ["P", "Q", "test"]


@pytest.mark.parametrize("table", ["hand", "pixels", "lines"])
def test_the_three_formats_have_the_same_rows(capsys: pytest.CaptureFixture[str], table: str) -> None:
    given = ("trace", "midpoint_circle", "0", "0", "5", "--table", table)
    content = json.loads(printed(capsys, *given, "--format", "json"))
    heading, *rows = csv.reader(io.StringIO(printed(capsys, *given, "--format", "csv")))
    lines = printed(capsys, *given).splitlines()
    assert heading == content["columns"]
    assert len(rows) == len(content["rows"]) == len(lines) - 1
    assert len(rows) > 3


def test_numbers_that_begin_with_a_minus_are_no_options(capsys: pytest.CaptureFixture[str]) -> None:
    plain = printed(capsys, "trace", "bresenham_line", "-16", "0", "5", "5")
    assert printed(capsys, "trace", "bresenham_line", "-0x10", "0", "5", "5") == plain
    assert "-2.5" in printed(capsys, "trace", "liang_barsky", "-.5", "-1e0", "2", "2", "0", "0", "1", "1")


def test_a_picture_may_have_blanks_between_its_digits(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    (tmp_path / "plain.txt").write_text("111\n101\n111\n")
    (tmp_path / "wide.txt").write_text("1 1 1\n\n1 0 1 \n1\t1 1\n")
    plain, wide = (
        printed(capsys, "trace", "boundary_fill_4", f"@{tmp_path / name}", "1", "1", "2", "1")
        for name in ("plain.txt", "wide.txt")
    )
    assert plain == wide
    assert len(plain.splitlines()) > 1


def test_a_run_that_draws_nothing_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    said = printed(capsys, "trace", "boundary_fill_4", "['000']", "9", "9", "2", "1").splitlines()
    assert said[1:] == ["No rows: with these arguments nothing is drawn."]


def test_pixels_are_what_is_emitted(capsys: pytest.CaptureFixture[str]) -> None:
    content = json.loads(
        printed(capsys, "trace", "dda_line", "-3", "2", "4", "-1", "--table", "pixels", "--format", "json")
    )
    assert content["columns"] == ["x", "y"]
    emitted = catalogue.get("dda_line").function(-3, 2, 4, -1)
    assert content["rows"] == [list(pixel) for pixel in emitted]


def test_lines_have_the_variables_before_each(capsys: pytest.CaptureFixture[str]) -> None:
    given = ("trace", "bresenham_line", "0", "0", "3", "1", "--table", "lines", "--format", "json")
    content = json.loads(printed(capsys, *given))
    rows = [dict(zip(content["columns"], row, strict=True)) for row in content["rows"]]
    assert rows[0]["text"] == "steep = abs(y1 - y0) > abs(x1 - x0)"
    assert rows[0]["steep"] is None
    assert rows[1]["steep"] is False
    at_choice = [row for row in rows if row["text"] == "if p < 0:"]
    assert [row["p"] for row in at_choice] == [-1, 1, -3]


def test_a_picture_comes_from_a_file_top_row_first(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    file = tmp_path / "ring.txt"
    file.write_text(PICTURE)
    given = (
        "trace",
        "boundary_fill_4",
        f"@{file}",
        "3",
        "3",
        "2",
        "1",
        "--table",
        "pixels",
        "--format",
        "json",
    )
    assert sorted(json.loads(printed(capsys, *given))["rows"]) == [[3, 2], [3, 3]]


def test_a_picture_can_be_written_on_the_command_line(capsys: pytest.CaptureFixture[str]) -> None:
    rows = str(PICTURE.split())
    given = ("trace", "boundary_fill_4", rows, "3", "3", "2", "1", "--table", "pixels", "--format", "json")
    assert sorted(json.loads(printed(capsys, *given))["rows"]) == [[3, 2], [3, 3]]


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("trase",), "trase"),
        (("trace",), "SLUG"),
        (("trace", "bresenham"), "bresenham_line"),
        (("trace", "nosuch"), "There is no algorithm named 'nosuch'; list shows all of them."),
        (("trace", "bresenham_line", "-5.", "0", "5", "5"), "x0 = -5.: it must be a whole number"),
        (("trace", "bresenham_line", "-1e3", "0", "5", "5"), "x0 = -1e3: it must be a whole number"),
        (("trace", "bresenham_line", "1", "2", "3"), "4 arguments (x0 y0 x1 y1), but 3"),
        (("trace", "bresenham_line", "1", "2", "3", "x"), "y1 = x"),
        (("trace", "bresenham_line", "1", "2", "3", "4.5"), "y1 = 4.5: it must be a whole number"),
        (("trace", "bresenham_line", "1", "2", "3", "True"), "y1 = True"),
        (("trace", "bresenham_line", "1", "2", "3", "10**3"), "y1 = 10**3"),
        (("trace", "bresenham_line", "1", "2", "3", "9" * 30), "y1 = 999"),
        (("trace", "bresenham_line", "1", "2", "3", "(" * 9000), "y1"),
        (("trace", "bresenham_line", "1", "2", "3", "{{1}}"), "y1 = {{1}}: this is not a number"),
        (("trace", "bresenham_line", "1", "2", "3", "\v1-\6\u2028"), "y1 = "),
        (("trace", "bresenham_line", "1", "2", "3", "[" + "1," * 400_000 + "]"), "at most 500,000"),
        (("trace", "bresenham_line", "1", "2", "3", "-x" * 9000), "unrecognized arguments: -x-x"),
        (("trace", "liang_barsky", "9" * 400, *"0000000"), "x0: it must be a finite number"),
        (("trace", "midpoint_circle", "0", "0", "-1"), "r = -1: it must be at least 0"),
        (
            ("trace", "bresenham_line", "1", "2", "3", "@nowhere.txt"),
            "y1 = @nowhere.txt: There is no file nowhere.txt",
        ),
        (("trace", "boundary_fill_4", "['01', '0']", "0", "0", "2", "1"), "row 2"),
        (("trace", "boundary_fill_4", "['0a']", "0", "0", "2", "1"), "row 1"),
        (("trace", "boundary_fill_4", "[]", "0", "0", "2", "1"), "image = []: the picture is empty"),
        (("trace", "boundary_fill_4", "7", "0", "0", "2", "1"), "image = 7: it must be a list"),
        (("trace", "bresenham_line", "1", "2", "3", "4", "--table", "foot"), "foot"),
        (("draw", "nowhere.gwb", "-o", "a.png"), "nowhere.gwb"),
        (("draw", "nowhere.gwb", "-o", "a.jpg"), "a.jpg"),
        (("draw", "nowhere.gwb"), "-o"),
    ],
)
def test_bad_input_is_named_in_one_line(
    capsys: pytest.CaptureFixture[str], words: tuple[str, ...], named: str
) -> None:
    assert named in refused(capsys, *words)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ["draw", "a.gwb", "-o", "a.png", "--cell", "1e9"],
            "'1e9' is not a whole number; write one such as 8",
        ),
        (
            ["draw", "a.gwb", "-o", "a.png", "--sheet", "two"],
            "'two' is not a whole number; write one such as 8",
        ),
        (
            ["surface", "hill", "-o", "a.obj", "--tolerance", "x"],
            "'x' is not a number; write one such as 0.5",
        ),
    ],
)
def test_a_wrong_number_is_named_in_plain_words(
    words: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    assert said in capsys.readouterr().err


def test_help_and_version(capsys: pytest.CaptureFixture[str]) -> None:
    for words, expected in ((("--help",), "trace"), (("--version",), "0.1.0")):
        assert expected in printed(capsys, *words)


def test_a_terminal_without_the_letters_and_a_closed_one() -> None:
    root = Path(__file__).parents[2]
    command = [sys.executable, "-m", "workbench", "list"]
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    shown = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=True)
    assert "B?zier" in shown.stdout
    assert shown.stderr == ""
    closed = subprocess.run(
        [sys.executable, "-c", "import os, sys; os.close(1); os.execv(sys.argv[1], sys.argv[1:])", *command],
        cwd=root,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    assert closed.returncode == 1
    assert closed.stderr.startswith("graphics-workbench: the result cannot be printed, since")
    assert closed.stderr.count("\n") == 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
@pytest.mark.parametrize("words", [("list",), ("--help",), ("trace", "bresenham_line", "0", "0", "9", "4")])
def test_what_cannot_be_printed_is_said_in_one_line(words: tuple[str, ...]) -> None:
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "workbench", *words],
            cwd=Path(__file__).parents[2],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert done.returncode == 1
    assert done.stderr == (
        "graphics-workbench: the result cannot be printed (No space left on device); send it elsewhere.\n"
    )


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "example.gwb"
    save(example_document(), path)
    return path


def test_draw_writes_the_frame_buffer(capsys: pytest.CaptureFixture[str], file: Path) -> None:
    output = file.with_suffix(".png")
    assert printed(capsys, "draw", str(file), "-o", str(output), "--cell", "3") == ""
    image = frame_buffer(example_document().sheets[0])
    height, width = image.shape
    picture = cv2.imread(str(output))
    assert picture.shape == (3 * height, 3 * width, 3)
    for x, y in ((20, 10), (30, 18), (0, 0), (25, 14)):
        blue, green, red = (int(channel) for channel in picture[3 * (height - 1 - y) + 1, 3 * x + 1])
        assert red << 16 | green << 8 | blue == image[y, x]


def test_draw_says_what_another_algorithm_drew(capsys: pytest.CaptureFixture[str], file: Path) -> None:
    file.write_text(file.read_text().replace('"bresenham_line"', '"line_of_tomorrow"'))
    output = file.with_suffix(".png")
    said = printed(capsys, "draw", str(file), "-o", str(output))
    assert said.strip() == (
        "1 figure asks for line_of_tomorrow, which this version lacks; "
        "Bresenham's line draws it, and the file keeps the name."
    )
    assert output.exists()


def test_draw_says_what_is_wrong_before_it_draws(
    capsys: pytest.CaptureFixture[str], file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("workbench.rendering.frame_buffer", None)
    output = str(file.with_suffix(".png"))
    said = refused(capsys, "draw", str(file), "-o", output, "--sheet", "7")
    assert "has one sheet, so there is no sheet 7" in said
    for cell in ("0", "1000000"):
        assert "cell" in refused(capsys, "draw", str(file), "-o", output, "--cell", cell)
    file.write_text(file.read_text()[:-40])
    assert str(file) in refused(capsys, "draw", str(file), "-o", output)
    assert not Path(output).exists()


def test_a_picture_that_cannot_be_written_is_no_bad_input(
    capsys: pytest.CaptureFixture[str], file: Path
) -> None:
    assert main(("draw", str(file), "-o", str(file.parent / "nowhere" / "a.png"))) == 1
    assert "a.png" in capsys.readouterr().err


def test_a_reader_that_goes_away_is_no_traceback() -> None:
    read, write = os.pipe()
    os.close(read)
    command = [
        sys.executable,
        "-m",
        "workbench",
        "trace",
        "midpoint_circle",
        "0",
        "0",
        "300",
        "--table",
        "lines",
    ]
    done = subprocess.run(command, stdout=write, stderr=subprocess.PIPE, text=True, timeout=60)
    os.close(write)
    assert (done.returncode, done.stderr) == (141, "")


def test_an_ascii_terminal_gets_ascii() -> None:
    command = [sys.executable, "-m", "workbench", "trace", "bresenham_line", "0", "0", "2", "1"]
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = subprocess.run(command, env=environment, capture_output=True, timeout=60, check=True)
    assert done.stdout.splitlines()[0].split()[:2] == [b"k", b"p_k"]
    assert done.stdout.isascii()


def test_an_interrupt_while_something_is_imported_is_no_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    class Interrupted:
        def find_spec(self, name: str, *_rest: object) -> None:
            if name.startswith("workbench.cli"):
                raise KeyboardInterrupt

    for name in [name for name in sys.modules if name.startswith("workbench.cli")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.delattr("workbench.cli")
    monkeypatch.setattr(sys, "meta_path", [Interrupted(), *sys.meta_path])
    assert main(["list"]) == 130


@pytest.mark.parametrize("name", ["nowhere.gwb", "NOWHERE.GWB", *(f"nowhere{suffix}" for suffix in SUFFIXES)])
def test_whatever_can_be_opened_is_opened_in_the_window(
    capsys: pytest.CaptureFixture[str], name: str
) -> None:
    assert main([name]) == 2
    assert capsys.readouterr().err == f"There is no file {name}; choose another.\n"


@pytest.mark.skipif(sys.platform == "win32", reason="has no pipes and devices among its files")
@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("pipe.gwb", "pipe.gwb is a pipe; write what comes out of it to a file, and open that."),
        ("pipe", "pipe is a pipe; write what comes out of it to a file, and open that."),
        ("folder.gwb", "folder.gwb is a folder; choose a file in it."),
        ("folder", "folder is a folder; choose a file in it."),
        ("/dev/zero", "/dev/zero is a device; choose a file."),
        ("a.docx", "a.docx is not of a kind that can be opened; choose a file that ends in .gwb, "),
        ("socket.gwb", "socket.gwb is a socket; choose a file."),
    ],
)
def test_what_cannot_be_opened_is_told_for_what_it_is(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    said: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    for pipe in ("pipe", "pipe.gwb"):
        os.mkfifo(pipe)
    for folder in ("folder", "folder.gwb"):
        Path(folder).mkdir()
    Path("a.docx").touch()
    with socket.socket(socket.AF_UNIX) as one:
        one.bind("socket.gwb")
        assert main([name]) == 2
    assert said in capsys.readouterr().err
