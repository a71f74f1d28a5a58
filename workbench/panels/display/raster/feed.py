"""Keeps the tube of the page Raster showing the sheet under its mode, depth and colour table."""

from collections.abc import Callable

from PySide6.QtCore import QObject

from workbench.document.model import Sheet
from workbench.panels.display.raster.setting import RasterSetting
from workbench.panels.shared.tube_feed import TubeFeed
from workbench.rendering.subjects.raster import fault_of
from workbench.widgets.tube.raster_view import RasterView
from workbench.widgets.tube.view import TubeView


class RasterFeed(TubeFeed):
    """Feeds one tube; ``told`` is called after it was given another picture."""

    def __init__(
        self, setting: RasterSetting, view: RasterView, told: Callable[[], object], parent: QObject
    ) -> None:
        self._setting, self._told = setting, told
        super().__init__(setting.session, [view], parent)

    @property
    def _scanned(self) -> object:
        return self._setting.subject

    def _scan(self, view: TubeView, sheet: Sheet, lit: bool) -> bool:
        assert isinstance(view, RasterView)
        fault = fault_of(sheet, self._setting.subject)
        self._refusals[view].say(fault)
        scan = self._setting.scan_of(sheet)
        if scan is not None:
            view.show_scan(scan.buffer.shown, scan.timing, (sheet.width_px, sheet.height_px))
        self._told()
        return scan is not None or fault != ""
