"""The tube: frame buffer, display list, beam, phosphor."""
