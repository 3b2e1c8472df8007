"""The JSON schemas that we publish describe what we write and what we read."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from rospkg_cli.config.schema import FORMS, SECTION
from rospkg_cli.report import Report
from rospkg_cli.report.json import document
from rospkg_cli.resources import resources
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.rule import all_rules
from rospkg_cli.testing import lint_files

EXAMPLES = [
    pytest.param(example, id=f"{rule.code}-{i}") for rule in all_rules() for i, example in enumerate(rule.examples)
]


def schema(name: str) -> dict:
    return json.loads((resources("schemas") / f"{name}.schema.json").read_text())


@pytest.mark.parametrize("example", EXAMPLES)
def test_reports_fit_their_schema(example) -> None:
    report = Report(lint_files(example.bad_files(), None, example.targets), Path("/ws"), Path("/ws"))
    jsonschema.validate(document(report), schema("report"), jsonschema.Draft202012Validator)


def test_a_report_that_lacks_something_does_not_fit() -> None:
    data = document(Report(lint_files({"README.md": ""}), Path("/ws"), Path("/ws")))
    jsonschema.validate(data, schema("report"), jsonschema.Draft202012Validator)
    del data["findings"][0]["line"]
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(data, schema("report"), jsonschema.Draft202012Validator)


def test_the_schema_of_the_config_has_its_keys() -> None:
    config = schema("rospkg")
    assert set(config["properties"]) == set(FORMS)
    section = config["$defs"]["sections"]["additionalProperties"]
    assert set(section["properties"]) == set(SECTION)
    assert config["properties"]["target"]["items"]["enum"] == [distro.name for distro in DISTROS]
