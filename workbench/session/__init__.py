"""What an open window holds: document, undo, selection, runs."""
