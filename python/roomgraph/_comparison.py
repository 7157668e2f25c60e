"""Several maps of one site."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional, Union

from . import _core
from ._call import Options, Progress, new_call
from ._grid_map import MapLike, all_to_core, to_core

if TYPE_CHECKING:
    import pandas


class Comparison:
    """What is known of several maps of one site; docs/scoring.md says what the figures mean.

    Each run, pair, room and break is a dict with the fields of comparison-1.schema.json.
    """

    def __init__(self, text: str, compared: Optional[_core.Comparison] = None) -> None:
        self._compared = compared
        self.json: str = text
        """comparison.json, as `roomgraph compare --format json --output .` writes it."""
        self.data: Dict[str, Any] = json.loads(text)
        """The same, parsed."""

    @property
    def runs(self) -> List[Dict[str, Any]]:
        """The maps, the best first; those without a rank last."""
        return self.data["runs"]

    @property
    def pairs(self) -> List[Dict[str, Any]]:
        """How each two maps lie in each other."""
        return self.data["pairs"]

    @property
    def rooms(self) -> List[Dict[str, Any]]:
        """The rooms of the site, and which map has which."""
        return self.data["rooms"]

    @property
    def breaks(self) -> List[Dict[str, Any]]:
        """Where maps break, the largest first."""
        return self.data["breaks"]

    @property
    def left_out(self) -> List[Dict[str, Any]]:
        """Maps that could not be compared, and why."""
        return self.data["left_out"]

    @property
    def verdict(self) -> str:
        """One line for people."""
        return self.data["verdict"]

    def frame(self) -> "pandas.DataFrame":
        """A row for each run, by name: its figures, and the value of each measure. Needs pandas."""
        import pandas

        skipped = ("name", "path", "pose", "measures")
        rows = []
        for run in self.runs:
            row = {key: value for key, value in run.items() if key not in skipped}
            row.update((name, measure["value"]) for name, measure in run["measures"].items())
            rows.append(row)
        names = pandas.Index([run["name"] for run in self.runs], name="run")
        return pandas.DataFrame(rows, index=names)

    def report(self) -> str:
        """report.html, which needs no other file and no network."""
        return self._with_maps().report()

    def write(self, folder: Union[str, "os.PathLike[str]"]) -> None:
        """Writes report.html and comparison.json, which `roomgraph report` reads, into a folder."""
        self._with_maps().write(os.fsencode(folder))

    def _with_maps(self) -> _core.Comparison:
        if self._compared is None:
            raise _core.UsageError(
                "a comparison that was read has no maps to draw: use 'roomgraph report'"
            )
        return self._compared

    def __str__(self) -> str:
        return self._compared.text() + self.verdict if self._compared else self.verdict

    def __repr__(self) -> str:
        return f"<roomgraph.Comparison of {len(self.runs)} runs: {self.verdict}>"


def compare(
    maps: Iterable[MapLike],
    *,
    reference: Optional[MapLike] = None,
    preset: str = "default",
    options: Optional[Options] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> Comparison:
    """Ranks several maps of one site, and tells how wrong each is, as `roomgraph compare` does.

    maps: files, or GridMaps, in any order.
    reference: a map to measure all others against, instead of against each other.
    preset, options: as for extract; those of a comparison are also known, such as
      {"compare.aligned": True} or {"compare.estimate_scale": True}.
    threads: how many maps or pairs to work on at once; 0 for one per core. It changes no number.
    progress: called with how many jobs of a step are done and how many it has: first maps, then
      pairs, then a dozen shorter steps, each from 1 on. What it raises ends the comparison, as
      Ctrl-C does.

    Maps that cannot be used are left out, see left_out. Raises DataError where none can be used,
    UsageError for fewer than two, two of one name, or an unknown option.
    """
    given = None if reference is None else to_core(reference)
    compared = _core.compare(
        all_to_core(maps), given, new_call(preset, options, threads, progress)
    )
    return Comparison(compared.json(), compared)


def read_comparison(file: Union[str, "os.PathLike[str]"]) -> Comparison:
    """A comparison.json that was written before. Raises DataError where it is none."""
    return Comparison(_core.read_comparison(os.fsencode(file)))
