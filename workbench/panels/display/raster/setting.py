"""What is set on the page Raster: the arguments of its subject, on whatever page one is."""

from functools import partial
from typing import Any

from msgspec.structs import replace

from workbench.display.scan import Scan
from workbench.display.timings import RasterTiming
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Position, Subject
from workbench.rendering.scene.backdrop import can_be_lit
from workbench.rendering.subjects.raster import KIND, fault_of, given, mode_of, scan_of, timing_of, with_given
from workbench.rendering.subjects.registry import checked
from workbench.session.session import Session

PAGE = "raster"


class RasterSetting:
    """Reads and changes the raster subject of a session."""

    usual = Subject(KIND)

    def __init__(self, session: Session) -> None:
        self.session = session
        self._before: Scan | None = None

    @property
    def subject(self) -> Subject:
        """What the page steps; the usual one where it was not visited yet."""
        position = self.session.state.positions.get(PAGE)
        return position.subject if position is not None and position.subject.is_of(self.usual) else self.usual

    def value(self, name: str) -> Any:
        """An argument."""
        return given(self.subject, name)

    def give(self, **changes: Argument) -> None:
        """Change arguments; the step stays. Raises DocumentError."""
        subject = checked(with_given(self.subject, **changes))
        positions = self.session.state.positions
        position = replace(positions.get(PAGE, Position()), subject=subject)
        self.session.update_state(positions={**positions, PAGE: position})

    @property
    def mode(self) -> RasterTiming:
        """The mode as it is named or typed."""
        return mode_of(self.sheet, self.subject)

    @property
    def sheet(self) -> Sheet:
        """What is scanned: the sheet as it is seen."""
        return self.session.frames.seen

    @property
    def timing(self) -> RasterTiming | None:
        """What the beam follows; None where nothing can be scanned."""
        sheet, subject = self.sheet, self.subject
        return None if fault_of(sheet, subject) else timing_of(sheet, subject)

    @property
    def scan(self) -> Scan | None:
        """What is scanned, or was before while a large sheet is worked on; None where nothing can be."""
        scan = self.scan_of(self.sheet)
        if scan is None and self._before is not None and self._before.timing == self.timing:
            return self._before
        self._before = scan
        return scan

    def scan_of(self, sheet: Sheet) -> Scan | None:
        """The picture of a sheet as it is stored and scanned; None where it cannot be, or cannot yet."""
        subject = self.subject
        make = partial(scan_of, sheet, subject)
        return self.session.ahead.of(sheet, KIND, make, subject, can_be_lit(sheet))
