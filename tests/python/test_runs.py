"""What runs tell of themselves, and what they know together."""

import subprocess

import pytest
import roomgraph
from conftest import drawn_flat


@pytest.fixture(scope="module")
def run_files():
    from conftest import TREE

    return [str(TREE / f"share/roomgraph/maps/office_run{i}.simplemap.gz") for i in (1, 2, 3, 4)]


def test_check_gives_what_the_program_writes(run_files, program, tmp_path):
    call = [program, "check", "-o", tmp_path, run_files[2]]
    told = subprocess.run(call, check=True, capture_output=True, text=True).stdout
    found = roomgraph.check(run_files[2])
    assert told.startswith(f"office_run3: {found.sentence}\n")
    assert found.json == (tmp_path / "office_run3.check.json").read_text()
    assert found.sentence == found.data["sentence"] in repr(found)
    assert found.self_error == found.data["self_error_m"]
    assert len(found.breaks) == len(found.data["breaks"])


def test_check_of_an_array_tells_nothing():
    assert roomgraph.check(drawn_flat()).self_error is None


def test_repair_gives_what_the_program_writes(run_files, program, tmp_path):
    subprocess.run([program, "repair", "-q", "-o", tmp_path, *run_files], check=True)
    repaired = roomgraph.repair(run_files)
    assert {run.name for run in repaired} == {f"office_run{i}" for i in (1, 2, 3, 4)}
    for run in repaired:
        assert run.simplemap == (tmp_path / f"{run.name}.repaired.simplemap.gz").read_bytes()
        assert run.tum == (tmp_path / f"{run.name}.repaired.tum").read_text()
        assert run.poses.shape[1] == 3 and len(run.poses) > 10
    mended = [run for run in repaired if run.state == "mended"]
    assert mended and all(run.moved_most >= run.moved > 0 and run.reason for run in mended)
    assert all(0 < run.left < run.moved_most for run in mended)


def test_repair_of_one_run_gives_what_the_program_writes(run_files, program, tmp_path):
    subprocess.run([program, "repair", "-q", "-o", tmp_path, run_files[2]], check=True)
    (run,) = roomgraph.repair(run_files[2:3])
    assert run.state == "mended" and run.moved_most > 1 and run.left is None
    assert run.simplemap == (tmp_path / f"{run.name}.repaired.simplemap.gz").read_bytes()


def test_repair_needs_scans(run_files):
    with pytest.raises(roomgraph.DataError, match="simplemaps"):
        roomgraph.repair([drawn_flat("a"), drawn_flat("b")])
    with pytest.raises(roomgraph.DataError, match="has no scans"):
        roomgraph.repair([drawn_flat("a")])


def test_carry_gives_what_the_program_writes(run_files, program, tmp_path):
    graph = roomgraph.extract(run_files[0])
    places = [
        roomgraph.Place(f"R{room['id']}", *room["widest_place"], 0.5) for room in graph.rooms[:4]
    ]
    table = tmp_path / "goals.csv"
    table.write_text("name,x,y,yaw\n" + "".join(f"{','.join(map(str, p))}\n" for p in places))
    out = tmp_path / "out"
    subprocess.run(
        [program, "carry", "-q", "-o", out, table, "--from", run_files[0], "--to", run_files[1]]
        + ["--via", run_files[3]]
    )
    lines = [line.split(",") for line in (out / "goals.csv").read_text().splitlines()[1:]]
    carried = roomgraph.carry(places, run_files[0], run_files[1], via=run_files[3:])
    assert len(carried) == len(lines) == 4
    for found, line in zip(carried, lines):
        assert found.name == line[0]
        assert found.state == line[4]
        assert found.place.name == found.name
        assert found.place[1:] == pytest.approx([float(text) for text in line[1:4]], abs=1e-3)
    assert "carried" in {found.state for found in carried}


def test_carry_needs_maps_that_lie_in_each_other(run_files):
    with pytest.raises(roomgraph.DataError, match="nothing can be carried"):
        roomgraph.carry([("dock", 0, 0)], run_files[0], drawn_flat())


def test_carry_takes_arrays():
    # The wall between the rooms has moved by 0.4 m, and with it what stands beside it.
    [dock] = roomgraph.carry([("dock", 8.0, 1.0)], drawn_flat("old"), drawn_flat("new"))
    assert dock.state == "carried"
    assert dock.place[1:3] == pytest.approx([8.0, 1.0], abs=0.06)


def test_carry_knows_no_error_where_neither_map_has_been():
    [far] = roomgraph.carry([("far", 500.0, 1.0)], drawn_flat("old"), drawn_flat("new"))
    assert (far.state, far.place, far.error) == ("unseen", None, None)


def test_carry_to_the_same_array_leaves_places_as_they_are():
    grid = drawn_flat("flat")
    [dock] = roomgraph.carry([("dock", 8.0, 1.0, 0.5)], grid, grid)
    assert dock.state == "carried"
    assert dock.place[1:] == pytest.approx((8.0, 1.0, 0.5))


def test_carry_refuses_what_is_no_place_and_maps_of_one_name():
    nan = float("nan")
    wrong = [("dock", nan, 1), ("dock", 1, 1, nan), ("dock", 1), ("dock", 1, 1, 0, 0), (3, 1, 1)]
    for place in wrong + [("\udc80", 1, 1)]:
        with pytest.raises(roomgraph.UsageError, match="is not a place"):
            roomgraph.carry([place], drawn_flat("old"), drawn_flat("new"))
    with pytest.raises(roomgraph.UsageError, match="two maps are named old"):
        roomgraph.carry([("dock", 8.0, 1.0)], drawn_flat("old"), drawn_flat("old", 4))
