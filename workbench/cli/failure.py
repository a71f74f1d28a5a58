"""How a command says that it could not do its work."""


class BadInputError(Exception):
    """What was given is wrong: one sentence naming what, where, and what to do. Exit status 2."""


class WorkError(Exception):
    """What was given is right, and the work failed all the same: one sentence. Exit status 1."""
