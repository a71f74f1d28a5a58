"""From the document to frame buffer and display list."""
