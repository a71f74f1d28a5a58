"""Stepping and compiling the text of an algorithm."""
