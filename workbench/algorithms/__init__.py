"""Level 1: the texts that the student reads.

Each algorithm is one generator function that emits (yields) what it draws. The same text is shown, stepped
and compiled. Imports NumPy and the standard library only. ``catalogue`` lists everything in teaching order.
"""
