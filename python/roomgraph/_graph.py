"""The graph of one map."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np

from . import _core
from ._call import Options, new_call
from ._grid_map import MapLike, to_core

if TYPE_CHECKING:
    import networkx


class Graph:
    """The topology graph of a map, its rooms, and its areas with the passages between them.

    Each vertex, edge, room, area and passage is a dict with the fields of graph-1.schema.json, and
    its id is its place in its list.
    """

    def __init__(self, stages: _core.Stages) -> None:
        self._stages = stages
        self.json: str = stages.json()
        """The text of the file X.json that `roomgraph extract` writes."""
        self.data: Dict[str, Any] = json.loads(self.json)
        """The same, parsed."""

    @property
    def vertices(self) -> List[Dict[str, Any]]:
        """Where paths meet, end, or cross the border of a room."""
        return self.data["vertices"]

    @property
    def edges(self) -> List[Dict[str, Any]]:
        """The paths between vertices, with their points."""
        return self.data["edges"]

    @property
    def rooms(self) -> List[Dict[str, Any]]:
        """The rooms of the graph, with their polygons."""
        return self.data["rooms"]

    @property
    def areas(self) -> List[Dict[str, Any]]:
        """All that the graph reaches: the rooms, then the pieces of corridor."""
        return self.data["areas"]

    @property
    def passages(self) -> List[Dict[str, Any]]:
        """The openings between areas."""
        return self.data["passages"]

    @property
    def notes(self) -> List[Dict[str, Any]]:
        """What is odd about the map, for people."""
        return self.data["notes"]

    @property
    def resolution(self) -> float:
        """Side of a cell [m]."""
        return self.data["input"]["resolution"]

    @property
    def origin(self) -> Tuple[float, float]:
        """x and y of the lower left corner of the map [m]."""
        x, y = self.data["input"]["origin"]
        return x, y

    @property
    def labels(self) -> np.ndarray:
        """1 + the id of the area of each cell, 0 for none; uint16, the first row lowest."""
        return self._stages.labels()

    @property
    def png(self) -> bytes:
        """The picture of the result, as the bytes of a file."""
        return self._stages.png()

    @property
    def svg(self) -> str:
        """The same as the text of a file."""
        return self._stages.svg()

    def _repr_png_(self) -> bytes:
        return self.png

    def to_networkx(self) -> "networkx.MultiGraph":
        """The vertices and edges, with all their fields as attributes. Needs networkx.

        Nodes are the ids of vertices, with their place as `pos`; the keys of edges are their ids,
        and `weight` is their length [m].
        """
        import networkx

        graph = networkx.MultiGraph()
        for vertex in self.vertices:
            graph.add_node(vertex["id"], pos=(vertex["x"], vertex["y"]), **vertex)
        for edge in self.edges:
            graph.add_edge(
                edge["source"], edge["target"], key=edge["id"], weight=edge["length"], **edge
            )
        return graph

    def __repr__(self) -> str:
        counts = [f"{len(self.data[name])} {name}" for name in ("rooms", "vertices", "edges")]
        return f"<roomgraph.Graph of {self.data['input']['file']}: {', '.join(counts)}>"


def extract(map: MapLike, *, preset: str = "default", options: Optional[Options] = None) -> Graph:
    """The graph of a map, as `roomgraph extract` makes it.

    map: a file of any kind that roomgraph reads, or a GridMap.
    preset: "default", or "paper" for the paper's numbers.
    options: SECTION.KEY to value, as `roomgraph config` lists them:
      {"load_grid.resolution": 0.05}.

    A degenerate map gives an empty graph and a note. Raises DataError for a map that cannot be
    read, UsageError for an unknown option or a value out of range.
    """
    return Graph(_core.extract(to_core(map), new_call(preset, options)))
