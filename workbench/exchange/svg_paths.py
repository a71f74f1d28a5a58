"""SVG paths in and out: ``read_svg`` and ``write_svg``."""

from workbench.exchange.svg_reading import Imported, read_svg
from workbench.exchange.svg_tree import SvgError
from workbench.exchange.svg_writing import Exported, write_svg

__all__ = ["Exported", "Imported", "SvgError", "read_svg", "write_svg"]
