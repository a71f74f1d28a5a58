"""Main window, workspaces, home, actions, settings, theme, tour."""

from workbench.widgets import overrides as overrides
