"""The graph of one map."""

import logging
import subprocess

import numpy as np
import pytest
import roomgraph
from conftest import drawn_flat


def test_gives_what_the_program_writes(maps, program, tmp_path):
    office = maps / "office.yaml"
    subprocess.run([program, "extract", "-q", "-o", tmp_path, office], check=True)
    graph = roomgraph.extract(office)
    assert graph.json == (tmp_path / "office.json").read_text()
    assert graph.png == (tmp_path / "office.png").read_bytes()
    assert graph.svg == (tmp_path / "office.svg").read_text()
    assert len(graph.rooms) == len(graph.data["rooms"]) > 5
    assert "rooms" in repr(graph)


def test_labels_are_the_areas_of_the_cells(maps):
    graph = roomgraph.extract(str(maps / "office.yaml"))
    labels = graph.labels
    assert labels.dtype == np.uint16
    assert labels.max() == len(graph.areas)
    x, y = graph.areas[0]["widest_place"]
    row = int((y - graph.origin[1]) / graph.resolution)
    column = int((x - graph.origin[0]) / graph.resolution)
    assert labels[row, column] == 1


def test_takes_arrays():
    graph = roomgraph.extract(drawn_flat())
    assert len(graph.rooms) == 2
    assert graph.labels.shape == (120, 240)
    [passage] = graph.passages
    assert passage["width"] == pytest.approx(1.0, abs=0.06)
    assert passage["middle"] == pytest.approx([5.075, 1.0], abs=0.06)
    assert graph.data["input"]["kind"] == "array"
    assert graph.data["input"]["file"] == "flat"


def test_percents_probabilities_and_files_are_the_same_map(tmp_path):
    flat = drawn_flat()
    cells = flat.cells.astype(float) / 100
    probable = roomgraph.GridMap(cells, flat.resolution, flat.origin, flat.name)
    assert roomgraph.extract(probable).json == roomgraph.extract(flat).json
    (tmp_path / "flat.pgm").write_bytes(
        b"P5 240 120 255\n" + np.where(flat.cells == 100, 0, 254)[::-1].astype(np.uint8).tobytes()
    )
    (tmp_path / "flat.yaml").write_text(
        "image: flat.pgm\nresolution: 0.05\norigin: [-1, -2, 0]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
    )
    of_file, of_array = roomgraph.extract(tmp_path / "flat.yaml"), roomgraph.extract(flat)
    for key in ("vertices", "edges", "rooms", "areas", "passages"):
        assert of_file.data[key] == of_array.data[key]


def test_unknown_cells_are_neither_free_nor_occupied():
    known, unknown = drawn_flat(), drawn_flat()
    unknown.cells[3:-3, 130:-3] = -1
    assert (roomgraph.extract(known).labels > 0).sum() > 1.5 * (
        roomgraph.extract(unknown).labels > 0
    ).sum()
    cells = np.where(unknown.cells == -1, np.nan, unknown.cells / 100.0)
    of_nan = roomgraph.extract(roomgraph.GridMap(cells, 0.05, (-1.0, -2.0), "flat"))
    assert of_nan.json == roomgraph.extract(unknown).json
    masked = np.ma.masked_array(known.cells, unknown.cells == -1)
    of_masked = roomgraph.extract(roomgraph.GridMap(masked, 0.05, (-1.0, -2.0), "flat"))
    assert of_masked.json == roomgraph.extract(unknown).json


def test_becomes_a_graph_of_networkx():
    networkx = pytest.importorskip("networkx")
    graph = roomgraph.extract(drawn_flat())
    net = graph.to_networkx()
    assert net.number_of_nodes() == len(graph.vertices)
    assert net.number_of_edges() == len(graph.edges)
    centres = [v["id"] for v in graph.vertices if v["kind"] == "room"]
    lengths = sum(edge["length"] for edge in graph.edges)
    assert networkx.shortest_path_length(net, *centres, weight="weight") <= lengths
    assert net.nodes[0]["pos"] == (graph.vertices[0]["x"], graph.vertices[0]["y"])


def test_options_are_those_of_the_program(maps):
    graph = roomgraph.extract(
        maps / "office.png", options={"load_grid.resolution": 0.1, "keep_components.only_largest": True}
    )
    assert graph.resolution == 0.1
    assert graph.data["options"]["keep_components"]["only_largest"] is True
    paper = roomgraph.extract(drawn_flat(), preset="paper")
    assert paper.data["options"] != roomgraph.extract(drawn_flat()).data["options"]


def test_wrong_arguments_are_value_errors(maps):
    office = maps / "office.yaml"
    with pytest.raises(roomgraph.UsageError, match="no section"):
        roomgraph.extract(office, options={"nothing.like_it": 1})
    with pytest.raises(ValueError, match="SECTION.KEY"):
        roomgraph.extract(office, options={"resolution": 1})
    with pytest.raises(ValueError, match="preset"):
        roomgraph.extract(office, preset="papers")
    for cells, resolution in (
        (np.zeros((0, 4), np.int8), 0.05),
        (np.zeros(4, np.int8), 0.05),
        (np.full((4, 4), 255, np.uint8), 0.05),
        (np.full((4, 4), 1.5), 0.05),
        (np.zeros((4, 4), bool), 0.05),
        (np.eye(4, dtype=np.int8), 0.05),
        (np.zeros((4, 4), np.int8), 0.0),
        (np.zeros((4, 4), np.int8), float("nan")),
        (np.zeros((4, 4), np.int8), "0.05"),
        (np.zeros((4, 4), np.int8), None),
        (np.zeros((4, 4), complex), 0.05),
        (np.zeros((4, 4), "m8[s]"), 0.05),
        ([[1, 2], [3]], 0.05),
    ):
        with pytest.raises(ValueError, match="mine: "):
            roomgraph.extract(roomgraph.GridMap(cells, resolution, name="mine"))
    for origin in ((1, 2, 0.5), None, "12", ("a", 0), (1e15, 0)):
        with pytest.raises(roomgraph.UsageError, match="mine: .*origin"):
            roomgraph.extract(roomgraph.GridMap(np.zeros((4, 4)), 0.05, origin, "mine"))
    for wrong in ({"preset": None}, {"options": [1]}):
        with pytest.raises(roomgraph.UsageError):
            roomgraph.extract(office, **wrong)
    many = {"maps": [office], "threads": 2**40}
    for wrong in ({"maps": office}, {"maps": 5}, {"maps": [3]}, {"maps": [office], "threads": -1}, many):
        with pytest.raises(roomgraph.UsageError):
            roomgraph.compare(**wrong)
    with pytest.raises(roomgraph.UsageError, match="name"):
        roomgraph.extract(roomgraph.GridMap(np.zeros((4, 4)), 0.05, name="\udcff"))
    with pytest.raises(roomgraph.UsageError, match="give roomgraph.GridMap"):
        roomgraph.extract(np.zeros((4, 4)))


def test_files_that_cannot_be_read_say_which_and_why(tmp_path):
    missing = tmp_path / "missing.yaml"
    with pytest.raises(roomgraph.DataError, match="missing.yaml: "):
        roomgraph.extract(missing)
    assert not issubclass(roomgraph.DataError, ValueError)
    assert roomgraph.DataError.__module__ == "roomgraph"


def test_odd_maps_are_legal():
    empty = roomgraph.extract(roomgraph.GridMap(np.full((9, 9), -1, np.int8), 0.05))
    assert empty.vertices == [] and empty.notes


def test_notes_on_reading_go_to_the_log(maps, caplog):
    with caplog.at_level(logging.INFO, logger="roomgraph"):
        roomgraph.extract(maps / "office.png")
    assert any("resolution" in record.message for record in caplog.records)
    assert all(record.levelno == logging.INFO for record in caplog.records)


def test_names_need_not_be_utf8(tmp_path):
    name = str(tmp_path / "caf\udce9.yaml")
    with pytest.raises(roomgraph.DataError, match="caf"):
        roomgraph.extract(name)
