"""Titled blocks of a text."""

import inspect
from collections.abc import Iterator

from workbench.algorithms.lines import bresenham_line
from workbench.engine.blocks import block_at, blocks, loop_headers


def walk(n: int) -> Iterator[tuple[int]]:
    """Walk.

    # Not a title: this is the docstring.
    """
    total = 0

    # Begin
    # with a second line of the same comment
    x = 1
    y = max(
        x,
        # not a title: inside a statement
        n,
    )

    for k in range(n):
        # Test
        if k % 2:
            # Step inside
            x += 1
        else:
            y += 1  # not a title: after code
        total += x

        # Emit
        while y > x:
            y -= 1
        yield (x,)
    total += y

    # End
    yield (total,)


def text_of(title: str) -> list[str]:
    source, first = inspect.getsourcelines(walk)
    lines = next(block.lines for block in blocks(walk) if block.title == title)
    return [source[line - first].strip() for line in lines]


def test_blocks_come_in_the_order_of_the_text() -> None:
    titles = ["Begin", "Test", "Step inside", "Emit", "End"]
    assert [block.title for block in blocks(walk)] == titles


def test_a_block_has_its_own_lines_and_those_of_loops_without_titles() -> None:
    assert text_of("Test") == ["if k % 2:", "else:", "y += 1  # not a title: after code", "total += x"]
    assert text_of("Step inside") == ["x += 1"]
    assert text_of("Emit") == ["while y > x:", "y -= 1", "yield (x,)"]
    assert text_of("End") == ["yield (total,)"]


def test_a_statement_over_several_lines_is_whole() -> None:
    assert len(text_of("Begin")) == 6


def test_headers_of_loops_with_titles_and_what_follows_them_belong_to_no_block() -> None:
    source, first = inspect.getsourcelines(walk)
    free = [
        line.strip()
        for number, line in enumerate(source, first)
        if block_at(walk, number) is None and line.strip() and not line.strip().startswith("#")
    ]
    assert "for k in range(n):" in free
    assert "total += y" in free
    assert "total = 0" in free
    assert [source[line - first].strip() for line in loop_headers(walk)] == ["for k in range(n):"]


def test_lines_are_numbers_in_the_file() -> None:
    block = blocks(bresenham_line)[3]
    source = inspect.getsource(inspect.getmodule(bresenham_line)).splitlines()
    assert source[block.title_line - 1].strip() == f"# {block.title}" == "# Choose the nearer row"
    assert source[block.first_line - 1].strip() == "if p < 0:"
    assert source[block.last_line - 1].strip() == "p += two_dy_minus_dx"
