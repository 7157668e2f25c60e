"""One run by itself."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Optional

from . import _core
from ._call import Options, new_call
from ._grid_map import MapLike, to_core


class RunCheck:
    """What a run tells of itself; docs/check.md says what the figures mean.

    data is a dict with the fields of check-1.schema.json.
    """

    def __init__(self, text: str) -> None:
        self.json: str = text
        """The text of the file X.check.json that `roomgraph check` writes."""
        self.data: Dict[str, Any] = json.loads(text)
        """The same, parsed."""

    @property
    def self_error(self) -> Optional[float]:
        """How far the run is from agreeing with itself, RMS [m]; None where nothing tells."""
        return self.data["self_error_m"]

    @property
    def breaks(self) -> List[Dict[str, Any]]:
        """Where it breaks, the largest first."""
        return self.data["breaks"]

    @property
    def doubled(self) -> List[Dict[str, Any]]:
        """What it has drawn twice, the worst first."""
        return self.data["doubled"]

    @property
    def sentence(self) -> str:
        """What can be told, and what cannot, for people, as the program prints it."""
        return self.data["sentence"]

    def __repr__(self) -> str:
        return f"<roomgraph.RunCheck: {self.sentence}>"


def check(map: MapLike, *, preset: str = "default", options: Optional[Options] = None) -> RunCheck:
    """How far one run is from agreeing with itself, and where it breaks, as `roomgraph check`.

    map: a simplemap; of a map without scans only what its walls show is told.
    preset, options: as for extract.

    Raises DataError for a map that cannot be used, UsageError for an unknown option.
    """
    return RunCheck(_core.check(to_core(map), new_call(preset, options)))
