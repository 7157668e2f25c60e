"""Maps that are arrays."""

from __future__ import annotations

import hashlib
import os
import struct
from dataclasses import dataclass
from typing import Tuple, Union

import numpy as np

from . import _core


@dataclass(frozen=True)
class GridMap:
    """A map that a program holds as an array.

    cells: rows and columns, the first row lowest (smallest y). Integers are percents, as in a
      nav_msgs/OccupancyGrid: 0 free, 100 occupied, -1 unknown. Floating-point numbers are
      probabilities of being occupied, NaN unknown. A cell is occupied from 0.65 on and free up to
      0.196, unless the options of `binarize` say otherwise.
    resolution: side of a cell [m].
    origin: x and y of the lower left corner of the map [m].
    name: of the map in results and errors; each map of a comparison has its own.
    """

    cells: np.ndarray
    resolution: float
    origin: Tuple[float, float] = (0.0, 0.0)
    name: str = "array"

    def _to_core(self) -> _core.ArrayMap:
        grey = np.ascontiguousarray(_grey_of(np.asarray(self.cells), self.name))
        if len(self.origin) != 2:
            raise _core.UsageError(f"{self.name}: its origin is not x and y")
        x, y = (float(value) for value in self.origin)
        place = struct.pack("<qqddd", *_shape_of(grey), self.resolution, x, y)
        sha256 = hashlib.sha256(place + grey.tobytes()).hexdigest()
        return _core.ArrayMap(self.name, sha256, grey, self.resolution, x, y)


MapLike = Union[str, "os.PathLike[str]", GridMap]


def to_core(given: MapLike) -> Union[bytes, _core.ArrayMap]:
    """What the extension module takes for a map."""
    if isinstance(given, np.ndarray):
        raise _core.UsageError("an array is no map: give roomgraph.GridMap(array, resolution)")
    return given._to_core() if isinstance(given, GridMap) else os.fsencode(given)


def _shape_of(grey: np.ndarray) -> Tuple[int, int]:
    return (grey.shape[0], grey.shape[1]) if grey.ndim == 2 else (0, 0)


def _grey_of(cells: np.ndarray, name: str) -> np.ndarray:
    """255 for surely free, 0 for surely occupied, 128 for unknown."""
    if cells.dtype == bool or not np.issubdtype(cells.dtype, np.number):
        raise _core.UsageError(
            f"{name}: its cells are {cells.dtype}: give percents as integers, or probabilities"
        )
    if np.issubdtype(cells.dtype, np.integer):
        if cells.size and cells.max() == 1:
            raise _core.UsageError(
                f"{name}: no integer in it is above 1, and integers are percents: "
                "give 0 to 100, or probabilities as floating-point numbers"
            )
        unknown, occupied = cells == -1, cells / 100.0
    else:
        unknown = np.isnan(cells)
        occupied = np.where(unknown, 0.0, cells)
    known = occupied[~unknown]
    if known.size and (known.min() < 0 or known.max() > 1):
        raise _core.UsageError(
            f"{name}: a cell is out of range: integers are percents (0 to 100, or -1 for unknown), "
            "floating-point numbers probabilities (0 to 1, or NaN)"
        )
    grey = np.rint(255 * (1 - np.where(unknown, 0.0, occupied)))
    return np.where(unknown, 128, grey).astype(np.uint8)
