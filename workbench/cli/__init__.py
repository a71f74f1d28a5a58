"""Everything that works without a window: ``list``, ``trace``, ``draw``."""

from workbench.cli.commands import main

__all__ = ["main"]
