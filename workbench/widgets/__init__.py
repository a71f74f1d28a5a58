"""Reusable parts of the interface."""

from workbench.widgets import overrides as overrides
