"""Samples that the tests share."""

import os
import pathlib

import numpy as np
import pytest
import roomgraph

TREE = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture
def maps():
    """The folder of the sample maps."""
    return TREE / "share/roomgraph/maps"


@pytest.fixture
def tree():
    return TREE


@pytest.fixture
def program():
    """The program that the package is held against."""
    return os.environ["ROOMGRAPH"]


def drawn_flat(name="flat", shift=0, width=240):
    """Two rooms with a door between them, 12 m by 6 m, as percents; one wall may be moved."""
    cells = np.full((120, width), 0, np.int8)
    cells[:3], cells[-3:], cells[:, :3], cells[:, -3:] = 100, 100, 100, 100
    wall = width // 2 + shift
    cells[:, wall : wall + 3] = 100
    cells[50:70, wall : wall + 3] = 0
    return roomgraph.GridMap(cells, 0.05, (-1.0, -2.0), name)
