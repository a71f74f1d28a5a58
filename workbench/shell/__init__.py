"""Main window, workspaces, home, actions, settings, theme, tour."""
