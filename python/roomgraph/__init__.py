"""Topology graphs with rooms of 2D grid maps, and how wrong several maps of one site are.

Lengths are metres and angles radians, in the frame of the map, unless a name says otherwise.
Notes on odd maps go to the logger "roomgraph" (level INFO), maps that cannot be used to the same
(WARNING). All functions leave Python's other threads running.
"""

from ._check import RunCheck, check
from ._comparison import Comparison, compare, read_comparison
from ._core import DataError, UsageError
from ._core import version as __version__
from ._graph import Graph, extract
from ._grid_map import GridMap
from ._site import CarriedPlace, Place, RepairedRun, carry, repair

for _error in (DataError, UsageError):
    _error.__module__ = __name__

__all__ = [
    "CarriedPlace",
    "Comparison",
    "DataError",
    "Graph",
    "GridMap",
    "Place",
    "RepairedRun",
    "RunCheck",
    "UsageError",
    "carry",
    "check",
    "compare",
    "extract",
    "read_comparison",
    "repair",
]
