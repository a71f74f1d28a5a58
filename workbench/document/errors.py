"""The one error of documents: what was refused, where, and what to do."""


class DocumentError(ValueError):
    """A document, an edit or a file was refused; what was open before is untouched.

    ``field`` is the path of the field, as in ``sheets[0].figures[2].radius_world``, or empty where a whole
    file is meant. The text of the error is one sentence that names it; ``short`` says the same without the
    path, for showing beside the field itself.
    """

    def __init__(self, field: str, message: str, short: str = "") -> None:
        super().__init__(message)
        self.field = field
        self.message = message
        self.short = short or message
