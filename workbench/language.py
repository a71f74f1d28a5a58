"""Every text that a person reads passes through here, so that another language is one more catalogue.

``_`` is gettext; ``ngettext`` chooses between singular and plural.
"""

import gettext as _gettext

from workbench.paths import resource

_translation = _gettext.translation("workbench", str(resource("languages")), fallback=True)

_ = _translation.gettext
ngettext = _translation.ngettext

LONGEST_NAME = 60


def legible(name: str, most: int = LONGEST_NAME) -> str:
    """``name``, whatever stands in it, as a sentence can hold it: on one line, and at most so long."""
    cut = name if len(name) <= most else name[: most - 1] + "…"
    return "".join(sign if sign.isprintable() else "\ufffd" for sign in cut)


def reason_of(error: Exception) -> str:
    """What an error says, as a person reads it: one of the system's without its number."""
    return (error.strerror if isinstance(error, OSError) else "") or str(error)
