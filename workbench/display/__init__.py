"""The tube: beam, deflection, phosphor and time, composed without a window."""

from workbench.display.beam import Beam, BeamState
from workbench.display.phosphor import Phosphor, Term
from workbench.display.phosphor import names as phosphor_names
from workbench.display.raster_beam import RasterBeam
from workbench.display.stroke_timeline import MmStroke
from workbench.display.timings import RasterTiming, raster_modes
from workbench.display.tube import Tube
from workbench.display.vector_beam import VectorBeam
from workbench.display.vector_timing import VectorTiming, vector_displays

__all__ = [
    "Beam",
    "BeamState",
    "MmStroke",
    "Phosphor",
    "RasterBeam",
    "RasterTiming",
    "Term",
    "Tube",
    "VectorBeam",
    "VectorTiming",
    "phosphor_names",
    "raster_modes",
    "vector_displays",
]
