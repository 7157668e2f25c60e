"""The examples of docs/python.md run as they stand there."""

import re
import shutil

import pytest
import roomgraph


@pytest.mark.filterwarnings("ignore::ResourceWarning")
def test_examples_run(tree, maps, tmp_path, monkeypatch, capsys):
    pytest.importorskip("networkx")
    pytest.importorskip("pandas")
    shutil.copytree(maps, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", (tree / "docs/python.md").read_text(), re.S)
    assert len(blocks) == 5
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    printed = capsys.readouterr().out
    assert "2 rooms" in printed and "is the best map" in printed
    for file in ("graph.json", "graph.png", "results/report.html", "results/comparison.json"):
        assert (tmp_path / file).stat().st_size > 0
    assert list(tmp_path.glob("*.repaired.tum"))


def test_documents_all_that_is_public(tree):
    text = (tree / "docs/python.md").read_text()
    for name in roomgraph.__all__:
        assert getattr(roomgraph, name).__doc__, name
    for name in ("extract", "compare", "check", "repair", "carry", "read_comparison", "GridMap"):
        assert f"roomgraph.{name}" in text, name
