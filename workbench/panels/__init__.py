"""One workspace per topic, thin."""
