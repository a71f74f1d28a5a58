"""Every text that a person reads passes through here, so that another language is one more catalogue.

``_`` is gettext; ``ngettext`` chooses between singular and plural.
"""

import gettext as _gettext

from workbench.paths import resource

_translation = _gettext.translation("workbench", str(resource("languages")), fallback=True)

_ = _translation.gettext
ngettext = _translation.ngettext
