"""Every text that a person reads passes through here, so that another language is one more catalogue.

``_`` is gettext; ``ngettext`` chooses between singular and plural.
"""

import gettext as _gettext
import math

from workbench.paths import resource

_translation = _gettext.translation("workbench", str(resource("languages")), fallback=True)

_ = _translation.gettext
ngettext = _translation.ngettext

LONGEST_NAME = 60
_LEAST = 1e-300  # not far below it the step between two such bounds is no normal number, or 0


def legible(name: str, most: int = LONGEST_NAME) -> str:
    """``name``, whatever stands in it, as a sentence can hold it: on one line, and at most so long."""
    cut = name if len(name) <= most else name[: most - 1] + "…"
    return "".join(sign if sign.isprintable() else "\ufffd" for sign in cut)


def reason_of(error: Exception) -> str:
    """What an error says, as a person reads it: one of the system's without its number."""
    return (error.strerror if isinstance(error, OSError) else "") or str(error)


def at_most(value: float) -> str:
    """A bound of two figures, rounded up, so that what is said to be at most so much is."""
    if not _LEAST < value < math.inf:
        return f"{value:.2g}"
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return f"{math.ceil(value / step - 1e-9) * step:.2g}"
