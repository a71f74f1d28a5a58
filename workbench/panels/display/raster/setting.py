"""What is set on the page Raster: the arguments of its subject, on whatever page one is."""

from typing import Any

from msgspec.structs import replace

from workbench.display.scan import Scan
from workbench.display.timings import RasterTiming
from workbench.document.state import as_seen
from workbench.document.subjects import Argument, Position, Subject
from workbench.rendering.subjects.raster import KIND, given, mode_of, scan_of, with_given
from workbench.rendering.subjects.registry import checked
from workbench.session.session import Session

PAGE = "raster"


class RasterSetting:
    """Reads and changes the raster subject of a session."""

    usual = Subject(KIND)

    def __init__(self, session: Session) -> None:
        self.session = session

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
        return mode_of(self.session.sheet, self.subject)

    @property
    def scan(self) -> Scan | None:
        """What is scanned; None where nothing can be."""
        return scan_of(as_seen(self.session.state, self.session.sheet), self.subject)
