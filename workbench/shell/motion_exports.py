"""What the Export menu offers of a sheet that moves: a GIF, a picture of each frame, a sheet of frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

from workbench.language import _

if TYPE_CHECKING:
    from workbench.exchange.moving_sheets import MovingSheet
    from workbench.shell.window import MainWindow

_LARGE_PX = 640


def export_animation(window: MainWindow) -> None:
    """Every frame: with the ending .gif as one file, with .png as a file for each."""
    content = _content(window)
    if content is not None:
        window.files.exports.writing.ask("animation", _("animation"), lambda: content, _mixed_delays)


def export_contacts(window: MainWindow) -> None:
    """Up to 24 frames on one sheet."""
    content = _content(window)
    if content is not None:
        window.files.exports.writing.ask("contacts", _("frames"), lambda: content)


def _content(window: MainWindow) -> MovingSheet | None:
    """The sheet, as many times as large as it can be seen well; one that does not move is said."""
    from workbench.exchange.moving_sheets import MovingSheet, Size

    sheet = window.session.sheet
    if sheet.motion is None or not sheet.motion.tracks:
        window.say_status(_("Nothing moves on this sheet; set keys in Animate first."))
        return None
    cell = max(1, _LARGE_PX // max(sheet.width_px, sheet.height_px))
    return MovingSheet(sheet, Size(sheet.width_px * cell, sheet.height_px * cell))


def _mixed_delays(content: MovingSheet) -> list[str]:
    """That a GIF counts hundredths of a second, where that shows."""
    from workbench.exchange.frames import delays_ms

    delays = sorted({delay // 10 for delay in delays_ms(content)})
    if len(delays) < 2:
        return []
    sentence = _(
        "A GIF counts hundredths of a second: some frames are seen for {short} of them, some for {long}."
    )
    return [sentence.format(short=delays[0], long=delays[-1])]
