"""Graphics Workbench: the algorithms of computer graphics, drawn, stepped, compiled, and seen to glow."""

__version__ = "0.1.0"
