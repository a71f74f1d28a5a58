"""What is asked of a raster display in exams: plain formulas, each with its units.

Three times of a line are told apart: without any retrace, with retraces that are given, and from the totals
of a mode. 1 kbit is 1000 bits, 1 KiB 1024 bytes.
"""

from fractions import Fraction
from math import gcd

FACE_ASPECT = Fraction(4, 3)
"""Width over height of the face of a tube."""


def frame_buffer_bits(width_px: int, height_px: int, bits: int) -> int:
    """Size of a frame buffer in bits."""
    return width_px * height_px * bits


def frame_buffer_bytes(width_px: int, height_px: int, bits: int) -> Fraction:
    """Size of a frame buffer in bytes."""
    return Fraction(frame_buffer_bits(width_px, height_px, bits), 8)


def address_of(x: int, y: int, width_px: int) -> int:
    """Address of a pixel, in pixels: rows of x_max + 1 pixels, one after the other from row 0."""
    return y * width_px + x


def byte_and_bit(address: int, bits: int) -> tuple[int, int]:
    """The byte in which the bits of the pixel at ``address`` begin, and the bit in it, 0 the first."""
    return divmod(address * bits, 8)


def colour_count(bits: int) -> int:
    """How many colours ``bits`` tell apart."""
    return 1 << bits


def plain_line_s(height_px: int, refresh_hz: Fraction) -> Fraction:
    """Seconds for a line where retraces take no time."""
    return 1 / (height_px * refresh_hz)


def plain_pixel_s(width_px: int, height_px: int, refresh_hz: Fraction) -> Fraction:
    """Seconds for a pixel where retraces take no time."""
    return 1 / (width_px * height_px * refresh_hz)


def line_s(height_px: int, refresh_hz: Fraction, v_retrace_s: Fraction) -> Fraction:
    """Seconds for a line and its horizontal retrace, where the vertical one is given."""
    return (1 / refresh_hz - v_retrace_s) / height_px


def pixel_s(
    width_px: int, height_px: int, refresh_hz: Fraction, h_retrace_s: Fraction, v_retrace_s: Fraction
) -> Fraction:
    """Seconds for a pixel, where the retrace of each line and that of the frame are given.

    Zero or less where the retraces take longer than the frame.
    """
    return (1 / refresh_hz - height_px * h_retrace_s - v_retrace_s) / (width_px * height_px)


def retrace_share(
    height_px: int, refresh_hz: Fraction, h_retrace_s: Fraction, v_retrace_s: Fraction
) -> Fraction:
    """Share of the time that goes into retraces that are given, 0 to 1 and more."""
    return (height_px * h_retrace_s + v_retrace_s) * refresh_hz


def scan_out_rate(width_px: int, height_px: int, bits: int, refresh_hz: Fraction) -> Fraction:
    """Bytes a second that the frame buffer gives on average."""
    return frame_buffer_bytes(width_px, height_px, bits) * refresh_hz


def loading_s(size_bits: int, bits_per_second: Fraction) -> Fraction:
    """Seconds to load so many bits over a line."""
    return size_bits / bits_per_second


def aspect(width_px: int, height_px: int) -> tuple[int, int]:
    """Columns to rows, in lowest terms."""
    common = gcd(width_px, height_px)
    return width_px // common, height_px // common


def pixel_aspect(width_px: int, height_px: int, face: Fraction = FACE_ASPECT) -> Fraction:
    """Width over height of a pixel of a picture that fills a face; 1 is square."""
    return face * height_px / width_px
