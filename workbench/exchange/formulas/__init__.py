"""Formulas as plain text, typeset: their notation, matrices of them, how they are laid out and copied."""
