"""Level 0: points, matrices, tolerances, and the conventions of the whole program."""
