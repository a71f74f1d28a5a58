"""The one style sheet (``resources/controls/style.qss``), over Fusion: flat surfaces,
hair lines, an edge on what can be typed into. ``@token`` in it stands for a token's value.
"""

from workbench.paths import resource
from workbench.widgets.look.tokens import RADIUS, TITLE_PX, Tokens
from workbench.widgets.look.type_faces import scaled


def style_sheet(chosen: Tokens) -> str:
    """The style sheet of one theme, its type as large as type is now."""
    text = resource("controls", "style.qss").read_text(encoding="utf-8")
    values = {
        "accent_hover": _towards(chosen.accent, chosen.text, 0.15),
        "controls": resource("controls").as_posix(),
        "radius": f"{RADIUS}px",
        "title_px": f"{scaled(TITLE_PX)}px",
        **{name: getattr(chosen, name) for name in Tokens._fields if name != "data"},
    }
    for name in sorted(values, key=len, reverse=True):
        text = text.replace(f"@{name}", values[name])
    return text


def _towards(start: str, end: str, part: float) -> str:
    """The colour ``part`` of the way from one to another."""
    pairs = ((int(start[i : i + 2], 16), int(end[i : i + 2], 16)) for i in (1, 3, 5))
    return "#" + "".join(f"{round(a + (b - a) * part):02X}" for a, b in pairs)
