"""One workspace per topic, thin."""

from workbench.widgets import overrides as overrides
