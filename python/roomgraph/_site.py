"""What the runs of a site know together."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Iterable, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _core
from ._call import Options, Progress, new_call
from ._grid_map import MapLike, all_to_core, is_text, number, to_core


@dataclass(frozen=True)
class RepairedRun:
    """A run with the poses that all runs together give it, in its own frame."""

    name: str
    file: str
    state: str
    """"mended"; or left as it was: "kept" or "reference"."""
    reason: str
    """Of the state, one line."""
    moved: float
    """How far its scans have moved, RMS [m]."""
    moved_most: float
    """The farthest [m]."""
    moved_most_at: int
    """The key frame that has moved so far."""
    left: Optional[float]
    """How far its scans still lie from where they fit on what the others have drawn, RMS [m]; None
    unless others have mended it."""
    poses: np.ndarray = field(repr=False)
    """x, y and yaw of the robot at each scan, a row each [m, rad]."""
    simplemap: bytes = field(repr=False)
    """The mended file, compressed as the run's file is."""
    tum: str = field(repr=False)
    """Its trajectory, as evo reads it."""


class Place(NamedTuple):
    """Something that was marked on a map: a goal, a dock, the corner of a zone."""

    name: str
    x: float
    y: float
    yaw: float = 0.0


@dataclass(frozen=True)
class CarriedPlace:
    """A place on another map."""

    name: str
    place: Optional[Place]
    """Where it is; None where neither map tells."""
    state: str
    """"carried", "unsure", "gone" (it is in a wall now) or "unseen"."""
    error: Optional[float]
    """How far it may be off, as a standard deviation [m]; None where neither map tells."""
    reason: str
    """Of any other state than "carried", one line."""


def repair(
    maps: Iterable[MapLike],
    *,
    reference: Optional[MapLike] = None,
    preset: str = "default",
    options: Optional[Options] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> List[RepairedRun]:
    """Each run with scans, with its key frames where all runs together have them.

    One alone goes where it would lie if it agreed with itself.

    Arguments as for compare; a reference stays as it is, and the others follow it. What
    `roomgraph repair` does, without files. Raises DataError where no run has scans.
    """
    given = None if reference is None else to_core(reference)
    call = new_call(preset, options, threads, progress)
    repaired = _core.repair(all_to_core(maps), given, call)
    return [RepairedRun(**run) for run in repaired]


def carry(
    places: Iterable[Union[Tuple[str, float, float], Tuple[str, float, float, float]]],
    old: MapLike,
    new: MapLike,
    *,
    via: Iterable[MapLike] = (),
    preset: str = "default",
    options: Optional[Options] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> List[CarriedPlace]:
    """Places of the map `old` on the map `new`, as `roomgraph carry` finds them, in their order.

    places: Places, or tuples of name, x, y and, if it has one, yaw.
    via: more runs of the site, which tell how both maps bend.
    Other arguments as for compare. Raises DataError where the one map does not lie in the other.
    """
    given = [_place_of(place) for place in places]
    call = new_call(preset, options, threads, progress)
    carried = _core.carry(given, to_core(old), to_core(new), all_to_core(via), call)
    return [
        CarriedPlace(
            place.name, None if pose is None else Place(place.name, *pose), state, error, reason
        )
        for place, (pose, state, error, reason) in zip(given, carried)
    ]


def _place_of(given: Iterable[Any]) -> Place:
    try:
        name, *numbers = given
        place = Place(name, *(number(value, f"{name}: a coordinate") for value in numbers))
    except (TypeError, ValueError) as error:
        raise _core.UsageError(f"{given!r} is not a place: give name, x, y and yaw") from error
    if not isinstance(name, str) or not is_text(name) or not np.isfinite(place[1:]).all():
        raise _core.UsageError(f"{given!r} is not a place: give a str, metres and radians")
    return place
