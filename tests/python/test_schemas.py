"""The schemas of the files that the program writes."""

import json

import jsonschema
import pytest
from conftest import TREE

SCHEMAS = sorted((TREE / "share/roomgraph/schema").glob("*.json"))


@pytest.mark.parametrize("file", SCHEMAS, ids=lambda file: file.name)
def test_are_schemas(file):
    schema = json.loads(file.read_text())
    jsonschema.validators.validator_for(schema).check_schema(schema)
