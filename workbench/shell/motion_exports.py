"""What the Export menu offers of a sheet that moves: a GIF, a picture of each frame, a sheet of frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

from workbench.language import _, ngettext

if TYPE_CHECKING:
    from workbench.exchange.moving_sheets import MovingSheet
    from workbench.exchange.writing import FileFormat
    from workbench.shell.window import MainWindow

_LARGE_PX = 640
_RATES = (5.0, 10.0, 12.0, 20.0, 24.0, 25.0, 30.0, 50.0)
_HIGHEST_RATE = 100.0


def export_animation(window: MainWindow) -> None:
    """Every frame, as one GIF or a file for each: how is chosen on the card."""
    from workbench.document.motion.tracks import motion_of
    from workbench.exchange.moving_sheets import MOST_SIDE_PX, MovingSheet, Size
    from workbench.panels.stage.pages import formats_of
    from workbench.widgets.fields.writing_card import Pictures

    content, writing = _content(window), window.files.exports.writing
    if content is None or writing.is_busy():
        return
    own = min(motion_of(content.sheet).rate, _HIGHEST_RATE)
    rates = sorted({own, *_RATES})

    def note(file_format: FileFormat) -> str:
        count = ngettext("{n} frame", "{n} frames", content.parts).format(n=content.parts)
        paths = file_format.paths(writing.proposed(_("animation"), file_format.suffix), content.parts)
        names = paths[0].name if len(paths) == 1 else f"{paths[0].name} … {paths[-1].name}"
        return _("{count} at its own rate: {names}").format(count=count, names=names)

    def then(file_format: FileFormat, width: int, seconds: float) -> None:
        height = max(round(width * content.sheet.height_px / content.sheet.width_px), 1)
        rate = next((each for each in rates if 1 / each == seconds), own)
        chosen = MovingSheet(content.sheet, Size(width, min(height, MOST_SIDE_PX)), rate)
        writing.ask_pictures(_("Export the animation"), _("animation"), file_format, chosen, _mixed_delays)

    texts = {".gif": _("Animated GIF"), ".png": _("PNG, one file per frame")}
    formats = [(each, texts.get(each.suffix, each.title)) for each in formats_of("animation")]
    speeds = [(_("{n:g} frames per second").format(n=rate), 1 / rate) for rate in rates]
    writing.card.offer(Pictures(_("Export the animation"), formats, speeds, 1 / own, note, then))


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
        "A GIF counts in hundredths of a second: some frames are shown for {short} of them, some for {long}."
    )
    return [sentence.format(short=delays[0], long=delays[-1])]
