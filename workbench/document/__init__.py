"""The picture as a value: model, edits, addresses, files."""
