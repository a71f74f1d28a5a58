"""What methods for hidden surfaces count and keep, in words, in the singular where there is one."""

from workbench.language import _, ngettext


def counted_text(n: int, what: str) -> str:
    """``n`` of ``what`` an entry counts or keeps, by the name that it has there."""
    text = {
        "boxes": ngettext("{n:,} box", "{n:,} boxes", n),
        "boxes divided": ngettext("{n:,} box divided", "{n:,} boxes divided", n),
        "cells": ngettext("{n:,} cell", "{n:,} cells", n),
        "cells divided": ngettext("{n:,} cell divided", "{n:,} cells divided", n),
        "depths": ngettext("{n:,} depth", "{n:,} depths", n),
        "edges": ngettext("{n:,} edge", "{n:,} edges", n),
        "flags": ngettext("{n:,} flag", "{n:,} flags", n),
        "nodes": ngettext("{n:,} node", "{n:,} nodes", n),
        "octants gone into": ngettext("{n:,} octant gone into", "{n:,} octants gone into", n),
        "pieces": ngettext("{n:,} piece", "{n:,} pieces", n),
        "splits": ngettext("{n:,} split", "{n:,} splits", n),
        "squares": ngettext("{n:,} square", "{n:,} squares", n),
        "squares divided": ngettext("{n:,} square divided", "{n:,} squares divided", n),
        "surfaces": ngettext("{n:,} surface", "{n:,} surfaces", n),
        "swaps and splits": ngettext("{n:,} swap or split", "{n:,} swaps and splits", n),
    }.get(what)
    return (text or _("{n:,} {what}")).format(n=n, what=_(what))


def counted_forms(n: int, what: str) -> tuple[str, ...]:
    """The same, then in fewer words where its noun goes without saying."""
    short = {
        "boxes divided": _("{n:,} divided"),
        "cells divided": _("{n:,} divided"),
        "squares divided": _("{n:,} divided"),
        "octants gone into": ngettext("{n:,} octant", "{n:,} octants", n),
    }.get(what)
    whole = counted_text(n, what)
    return (whole,) if short is None else (whole, short.format(n=n))
