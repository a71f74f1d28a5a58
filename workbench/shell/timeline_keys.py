"""The keys of the timeline of Animate and of its curves, for the table of keys."""

from workbench.language import _


def timeline_keys() -> tuple[tuple[str, str, str], ...]:
    """Part, key, what it does."""
    timeline, curve = _("Timeline of Animate"), _("Curve of a track in Animate")
    return (
        (timeline, "Left, Right", _("Frame back, forward; with Shift by ten, with Ctrl from key to key")),
        (timeline, "Home, End", _("First, last frame")),
        (timeline, "Up, Down", _("Go from track to track")),
        (timeline, "K", _("Set a key in the frame that is shown")),
        (timeline, "Return", _("Select or deselect the key of the frame that is shown")),
        (timeline, "Alt+Left, Alt+Right", _("Move the chosen keys; with Shift scale them in time")),
        (timeline, "Ctrl+A", _("Choose all keys")),
        (timeline, "Delete", _("Remove the chosen keys")),
        (timeline, "Menu", _("Choose the easing of the chosen keys")),
        (timeline, "C", _("The curve of the track, or all tracks")),
        (timeline, "], [", _("More ghosts, fewer ghosts")),
        (timeline, "+, -, F", _("Frames wider, narrower, all of them")),
        (curve, "Alt+Up, Alt+Down", _("Raise, lower the chosen keys; with Shift by ten times as much")),
        (curve, "H", _("Take the next handle, which Alt and the arrows then move")),
        (curve, "PgUp, PgDown", _("Choose another number of the track; with Shift zoom values")),
    )
