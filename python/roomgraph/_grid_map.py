"""Maps that are arrays."""

from __future__ import annotations

import hashlib
import os
import struct
from collections.abc import Iterable as AnyIterable
from dataclasses import dataclass
from typing import Any, Iterable, List, Tuple, Union

import numpy as np

from . import _core


@dataclass(frozen=True)
class GridMap:
    """A map that a program holds as an array.

    cells: rows and columns, the first row lowest (smallest y). Integers are percents, as in a
      nav_msgs/OccupancyGrid: 0 free, 100 occupied, -1 unknown. Floating-point numbers are
      probabilities of being occupied, NaN unknown. So is what is masked. A cell is occupied from
      0.65 on and free up to 0.196, unless the options of `binarize` say otherwise.
    resolution: side of a cell [m].
    origin: x and y of the lower left corner of the map [m].
    name: of the map in results and errors; each map of a comparison has its own.
    """

    cells: np.ndarray
    resolution: float
    origin: Tuple[float, float] = (0.0, 0.0)
    name: str = "array"

    def _to_core(self) -> _core.ArrayMap:
        if not isinstance(self.name, str) or not is_text(self.name):
            raise _core.UsageError(f"the name of a map is {self.name!r}: give a str")
        grey = np.ascontiguousarray(_grey_of(self.cells, self.name))
        resolution = number(self.resolution, f"{self.name}: its resolution")
        if not isinstance(self.origin, (tuple, list, np.ndarray)) or len(self.origin) != 2:
            raise _core.UsageError(f"{self.name}: its origin is not x and y")
        x, y = (number(value, f"{self.name}: its origin") for value in self.origin)
        place = struct.pack("<qqddd", *_shape_of(grey), resolution, x, y)
        sha256 = hashlib.sha256(place + grey.tobytes()).hexdigest()
        return _core.ArrayMap(self.name, sha256, grey, resolution, x, y)


MapLike = Union[str, "os.PathLike[str]", GridMap]


def to_core(given: MapLike) -> Union[bytes, _core.ArrayMap]:
    """What the extension module takes for a map."""
    if isinstance(given, np.ndarray):
        raise _core.UsageError("an array is not a map: give roomgraph.GridMap(array, resolution)")
    if isinstance(given, GridMap):
        return given._to_core()
    if isinstance(given, (str, bytes, os.PathLike)):
        return os.fsencode(given)
    raise _core.UsageError(f"{given!r} is not a map: give a file or a roomgraph.GridMap")


def all_to_core(given: Iterable[MapLike]) -> List[Union[bytes, _core.ArrayMap]]:
    """The same of several maps."""
    if isinstance(given, (str, bytes, os.PathLike, GridMap)):
        raise _core.UsageError(f"{given!r} is one map: give a list of maps")
    if not isinstance(given, AnyIterable):
        raise _core.UsageError(f"{given!r} is no list of maps")
    return [to_core(map) for map in given]


def number(given: Any, what: str) -> float:
    """It as a number."""
    if isinstance(given, (int, float, np.integer, np.floating)):
        return float(given)
    raise _core.UsageError(f"{what} is {given!r}, and no number")


def is_text(name: str) -> bool:
    """Not so are file names that are no UTF-8, as Python decodes them."""
    try:
        name.encode()
    except UnicodeEncodeError:
        return False
    return True


def _shape_of(grey: np.ndarray) -> Tuple[int, int]:
    return (grey.shape[0], grey.shape[1]) if grey.ndim == 2 else (0, 0)


def _grey_of(given: np.ndarray, name: str) -> np.ndarray:
    """255 for surely free, 0 for surely occupied, 128 for unknown."""
    try:
        cells, masked = np.ma.getdata(given), np.ma.getmaskarray(given)
    except ValueError as error:
        raise _core.UsageError(f"{name}: its cells are no array of rows and columns") from error
    if cells.dtype.kind not in "iuf":
        raise _core.UsageError(
            f"{name}: its cells are {cells.dtype}: give percents as integers, or probabilities"
        )
    if np.issubdtype(cells.dtype, np.integer):
        if cells.size and cells.max() == 1:
            raise _core.UsageError(
                f"{name}: no integer in it is above 1, and integers are percents: "
                "give 0 to 100, or probabilities as floating-point numbers"
            )
        unknown, occupied = masked | (cells == -1), cells / 100.0
    else:
        unknown = masked | np.isnan(cells)
        occupied = np.where(unknown, 0.0, cells)
    known = occupied[~unknown]
    if known.size and (known.min() < 0 or known.max() > 1):
        raise _core.UsageError(
            f"{name}: a cell is out of range: integers are percents (0 to 100, or -1 for unknown), "
            "floating-point numbers probabilities (0 to 1, or NaN)"
        )
    grey = np.rint(255 * (1 - np.where(unknown, 0.0, occupied)))
    return np.where(unknown, 128, grey).astype(np.uint8)
