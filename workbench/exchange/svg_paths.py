"""SVG paths in and out: ``read_svg`` and ``write_svg``."""

from workbench.exchange.svg_reading import Imported, frame_of, read_svg, size_of
from workbench.exchange.svg_tree import SvgError, read_tree
from workbench.exchange.svg_writing import Exported, write_svg

__all__ = ["Exported", "Imported", "SvgError", "frame_of", "read_svg", "read_tree", "size_of", "write_svg"]
