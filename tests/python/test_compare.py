"""Several maps of one site."""

import logging
import subprocess
import threading
import time

import numpy as np
import pytest
import roomgraph
from conftest import drawn_flat


@pytest.fixture
def runs(maps):
    return [maps / f"office_run{i}.simplemap.gz" for i in (1, 2, 4)]


def test_gives_the_bytes_that_the_program_writes(runs, program, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    subprocess.run(
        [program, "compare", *runs, "-q", "--format", "json", "--output", "."], check=True
    )
    comparison = roomgraph.compare(reversed(runs))
    assert comparison.json == (tmp_path / "comparison.json").read_text()
    again = roomgraph.read_comparison("comparison.json")
    assert again.data == comparison.data
    subprocess.run(
        [program, "compare", *runs, "-q", "--format", "report,json", "-o", "of_program"], check=True
    )
    comparison.write("of_python")
    for file in ("comparison.json", "report.html"):
        assert (tmp_path / "of_python" / file).read_bytes() == (
            tmp_path / "of_program" / file
        ).read_bytes()
    assert comparison.report().startswith("<!")
    with pytest.raises(ValueError, match="roomgraph report"):
        again.report()


def test_runs_come_best_first(runs):
    told = []
    comparison = roomgraph.compare(runs, progress=lambda done, count: told.append((done, count)))
    assert [run["rank"] for run in comparison.runs] == [1, 2, 3]
    assert len(comparison.pairs) == 3
    assert comparison.runs[0]["name"] in comparison.verdict in str(comparison)
    assert (3, 3) in told
    assert all(0 <= done <= count for done, count in told)


def test_becomes_a_frame_of_pandas(runs):
    pytest.importorskip("pandas")
    comparison = roomgraph.compare(runs)
    frame = comparison.frame()
    best = comparison.runs[0]
    assert list(frame.index) == [run["name"] for run in comparison.runs]
    assert frame.loc[best["name"], "map_error_m"] == best["map_error_m"]
    assert frame.loc[best["name"], "coverage"] == best["measures"]["coverage"]["value"]


def test_arrays_are_compared_beside_each_other_and_files():
    flats = [drawn_flat("a"), drawn_flat("b"), drawn_flat("bad", shift=8)]
    comparison = roomgraph.compare(flats)
    assert {run["file"] for run in comparison.runs} == {"a", "b", "bad"}
    assert comparison.runs[-1]["name"] == "bad"
    against = roomgraph.compare([flats[1], flats[2]], reference=flats[0])
    assert against.data["reference"] == "a"
    worst = against.runs[-1] if against.runs[-1]["name"] != "a" else against.runs[-2]
    assert worst["name"] == "bad"
    with pytest.raises(ValueError, match="name"):
        roomgraph.compare([drawn_flat("a"), drawn_flat("a", shift=4)])


def test_one_map_alone_is_no_comparison(runs):
    with pytest.raises(roomgraph.UsageError, match="at least two"):
        roomgraph.compare(runs[:1])


def test_maps_that_cannot_be_used_are_left_out(runs, tmp_path, caplog):
    bad = tmp_path / "bad.simplemap"
    bad.write_bytes(b"no map")
    bare = roomgraph.GridMap(np.zeros((50, 50), np.int8), 0.05, name="bare")
    comparison = roomgraph.compare([*runs[:2], bad, bare])
    assert [run["name"] for run in comparison.left_out] == ["bad", "bare"]
    warnings = [r.message for r in caplog.records if r.levelno == logging.WARNING]
    assert len(warnings) == 2 and str(bad) in warnings[0] and "bare" in warnings[1]
    with pytest.raises(roomgraph.DataError, match="no map could be used"):
        roomgraph.compare([bad, bare])


def test_what_progress_raises_ends_it(runs):
    calls = []

    def stop(done, count):
        calls.append(done)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        roomgraph.compare(runs, progress=stop)
    assert len(calls) == 1


def test_other_threads_of_python_run_meanwhile(runs):
    beats = []
    stops = threading.Event()

    def beat():
        while not stops.is_set():
            beats.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=beat)
    thread.start()
    try:
        begin = time.monotonic()
        roomgraph.compare(runs, threads=1)
        end = time.monotonic()
    finally:
        stops.set()
        thread.join()
    # With Python's lock held, a pair of maps would take all of it at once.
    inside = [begin, *(at for at in beats if begin < at < end), end]
    assert max(b - a for a, b in zip(inside, inside[1:])) < 0.8 * (end - begin)


def test_number_of_threads_changes_nothing(runs):
    assert roomgraph.compare(runs, threads=1).json == roomgraph.compare(runs, threads=3).json
