"""Files and words as nobody should write them: made of sound ones by seeded chance."""

import random
from collections.abc import Callable, Sequence

HUGE = (b"1e308", b"-1e308", b"1e999", b"9" * 400, b"1" * 5000, b"0." + b"0" * 3000 + b"1", b"NaN", b"-0")
BRACKETS = ((b"[", b"]"), (b'{"a":', b"}"), (b"<g>", b"</g>"), (b"(", b")"), (b"{", b"}"))
MOST_BYTES = 60_000

Mangler = Callable[[random.Random, bytes], bytes]


def truncated(chance: random.Random, data: bytes) -> bytes:
    """Broken off anywhere."""
    return data[: chance.randrange(len(data) + 1)]


def doubled(chance: random.Random, data: bytes) -> bytes:
    """A stretch of it, once more or very often."""
    begin, end = _stretch(chance, data)
    return data[:begin] + data[begin:end] * chance.choice((2, 3, 50, 2000)) + data[end:]


def flipped(chance: random.Random, data: bytes) -> bytes:
    """Some bits of it turned over."""
    changed = bytearray(data)
    for _time in range(chance.choice((1, 1, 3, 20))):
        if changed:
            changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def spliced(chance: random.Random, data: bytes) -> bytes:
    """One stretch of it put over another."""
    (a, b), (c, d) = _stretch(chance, data), _stretch(chance, data)
    return data[:a] + data[c:d] + data[b:]


def with_huge_number(chance: random.Random, data: bytes) -> bytes:
    """One of its numbers, or any place where there is none, as a number of no sensible size."""
    digits = [k for k, byte in enumerate(data) if 48 <= byte < 58] or [len(data) // 2]
    at = chance.choice(digits)
    return data[:at] + chance.choice(HUGE) + data[at + 1 :]


def nested(chance: random.Random, data: bytes) -> bytes:
    """A stretch of it inside many brackets or groups, or the brackets alone."""
    begin, end = _stretch(chance, data)
    depth = chance.choice((3, 150, 250, 3000))
    opening, closing = chance.choice(BRACKETS)
    return data[:begin] + opening * depth + data[begin:end] + closing * chance.choice((depth, 0)) + data[end:]


def emptied(chance: random.Random, data: bytes) -> bytes:
    """A stretch of it gone, or replaced by one sign again and again."""
    begin, end = _stretch(chance, data)
    sign = chance.choice((b"", b" ", b"\0", b"\n", b",", b'"', b"\xff", "é\u2028".encode(), b"a", b"1"))
    return data[:begin] + sign * chance.choice((1, 100, 20_000)) + data[end:]


ANY = (truncated, doubled, flipped, spliced, with_huge_number, nested, emptied)


def mangled(chance: random.Random, sound: Sequence[bytes], special: Sequence[Mangler] = ()) -> bytes:
    """One of the ``sound`` ones after one to four mishaps, at most ``MOST_BYTES`` long."""
    data = chance.choice(sound)
    for _time in range(chance.choice((1, 1, 2, 4))):
        data = chance.choice((*ANY, *special))(chance, data)[:MOST_BYTES]
    return data


def _stretch(chance: random.Random, data: bytes) -> tuple[int, int]:
    begin = chance.randrange(len(data) + 1)
    return begin, min(begin + chance.choice((1, 5, 40, 400)), len(data))
