"""Solids as polygon meshes: vertices (n, 3), y up, and faces that are counter-clockwise from outside."""

from workbench.algorithms.solids.blobs import blobs
from workbench.algorithms.solids.jug import jug
from workbench.algorithms.solids.polyhedra import (
    box,
    cube,
    dodecahedron,
    icosahedron,
    octahedron,
    tetrahedron,
)
from workbench.algorithms.solids.shapes import bracket, house, piercing_planes
from workbench.algorithms.solids.sweeps import (
    cone,
    cylinder,
    ellipsoid,
    extruded,
    prism,
    pyramid,
    sphere,
    torus,
    turned,
)
from workbench.algorithms.solids.tables import PolygonTables, polygon_tables

__all__ = [
    "PolygonTables",
    "blobs",
    "box",
    "bracket",
    "cone",
    "cube",
    "cylinder",
    "dodecahedron",
    "ellipsoid",
    "extruded",
    "house",
    "icosahedron",
    "jug",
    "octahedron",
    "piercing_planes",
    "polygon_tables",
    "prism",
    "pyramid",
    "sphere",
    "tetrahedron",
    "torus",
    "turned",
]
