"""Every report format, read by what reads it in the world."""

from __future__ import annotations

import io
import json
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import jsonschema
import pytest
from junitparser import JUnitXml

from rospkg_cli.engine.run.results import Results
from rospkg_cli.report import FORMATS, Report, render
from rospkg_cli.report.fingerprint import fingerprints
from rospkg_cli.rule import all_rules
from rospkg_cli.testing import lint_files

IGNORED = "<!-- rospkg: ignore[XML104] it will come -->\n  <license>TODO</license>"
NASTY = "TODO: a \"b\" & <c> | d, 100% 'é' 机器人"


@pytest.fixture
def report(clean) -> Report:
    """One suppressed warning, and one whose text needs escaping everywhere."""
    text = clean["package.xml"].replace("Apache-2.0", "TODO: x &quot;b&quot; &amp; &lt;c&gt; | d, 100% 'é' 机器人")
    text = text.replace("</license>", f"</license>\n  {IGNORED}")
    files = {**clean, "package.xml": text, "my_pkg/package.xml.in": "x"}
    return Report(lint_files(files, ["XML104", "RPK001"]), Path("/ws"), Path("/ws"))


def rendered(name: str, report: Report) -> str:
    stream = io.StringIO()
    render(name, report, stream)
    return stream.getvalue()


@cache
def linted_examples() -> tuple[tuple[str, frozenset[str], Results], ...]:
    """Return the code of each rule, the paths of each of its examples, and what is found there; linted once for all."""
    return tuple(
        (rule.code, frozenset(example.bad_files()), lint_files(example.bad_files(), None, example.targets))
        for rule in all_rules()
        for example in rule.examples
    )


@pytest.mark.parametrize("name", FORMATS)
def test_every_example_can_be_shown(name: str) -> None:
    for _, _, results in linted_examples():
        assert rendered(name, Report(results, Path("/ws"), Path("/ws")))


@pytest.mark.parametrize("name", FORMATS)
def test_nothing_found_is_shown_too(name: str, clean) -> None:
    shown = rendered(name, Report(lint_files(clean, ["XML104"]), Path("/ws"), Path("/ws")))
    if name in ("json", "sarif", "gitlab", "rdjson"):
        json.loads(shown)


def test_junit_is_counted_by_a_reader(report: Report, tmp_path: Path) -> None:
    (tmp_path / "lint.xml").write_text(rendered("junit", report))
    read = JUnitXml.fromfile(str(tmp_path / "lint.xml"))
    assert (read.tests, read.failures, read.errors) == (1, 1, 0)
    (case,) = [case for suite in read for case in suite]
    assert NASTY.partition("TODO: a")[2].strip('" ')[-3:] in case.result[0].message


def test_gitlab_has_what_gitlab_wants(report: Report) -> None:
    (entry,) = json.loads(rendered("gitlab", report))
    assert entry["severity"] in ("info", "minor", "major", "critical", "blocker")
    assert re.fullmatch("[0-9a-f]{64}", entry["fingerprint"])
    assert entry["location"]["path"] == "package.xml"
    assert entry["location"]["positions"]["begin"] == {"line": 8, "column": 12}


def test_gitlab_would_keep_every_finding() -> None:
    """GitLab drops an entry that its own schema refuses, and keeps one of those with equal fingerprints."""
    place = {
        "type": "object",
        "required": ["path"],
        "properties": {
            "path": {"type": "string", "pattern": "^[^/.]"},
            "positions": {"properties": {"begin": {"properties": {"line": {"type": "integer"}}}}},
        },
    }
    words = {key: {"type": "string"} for key in ("description", "fingerprint", "severity")}
    wanted = {"type": "object", "required": [*words, "location"], "properties": {**words, "location": place}}
    is_wanted = jsonschema.Draft202012Validator(wanted)
    for code, paths, found in linted_examples():
        entries = json.loads(rendered("gitlab", Report(found, Path("/ws"), Path("/ws"))))
        for entry in entries:
            if entry["location"]["path"] in paths:
                is_wanted.validate(entry)
        assert len({entry["fingerprint"] for entry in entries}) == len(found.findings), code


def test_fingerprints_hold_when_lines_move(clean) -> None:
    def marks(files) -> list[str]:
        shown = rendered("gitlab", Report(lint_files(files, ["XML104"]), Path("/ws"), Path("/ws")))
        return [entry["fingerprint"] for entry in json.loads(shown)]

    text = clean["package.xml"].replace("Apache-2.0", "TODO").replace("Drives my robot", "")
    before = marks({**clean, "package.xml": text})
    after = marks({**clean, "package.xml": text.replace("  <name>", "\n\n  <!-- moved -->\n  <name>")})
    assert before == after
    assert len(set(before)) == 2


def test_github_escapes_its_own_signs(report: Report) -> None:
    line = rendered("github", report)
    assert line.count("\n") == 1
    assert line.startswith("::warning file=package.xml,line=8,")
    assert "100%25" in line


def test_markdown_keeps_its_table(report: Report) -> None:
    rows = [line for line in rendered("markdown", report).splitlines() if line.startswith("| warning")]
    assert len(rows) == 1
    assert len(re.findall(r"(?<!\\)\|", rows[0])) == 5


def test_rdjson_suggests_the_edits_of_safe_fixes() -> None:
    example = next(e for r in all_rules() if r.code == "RPK002" for e in r.examples)
    report = Report(lint_files(example.bad_files()), Path("/ws"), Path("/ws"))
    (diagnostic,) = json.loads(rendered("rdjson", report))["diagnostics"]
    assert diagnostic["suggestions"][0]["text"] == ""


def test_text_fits_80_columns_and_underlines_the_spot(report: Report) -> None:
    lines = rendered("text", replace(report, width=80)).splitlines()
    source = next(i for i, line in enumerate(lines) if "<license>" in line)
    assert lines[source + 1].index("^") == lines[source].index("TODO")
    assert all(len(line) <= 80 for line in lines if " | " not in line)
    assert lines[-1].endswith("1 ignored.")


def test_the_sample_is_what_it_says(report: Report) -> None:
    assert [f.code for f in report.results.findings] == ["XML104"]
    assert [f.suppressed for f in report.results.suppressed] == ["it will come"]


def test_equal_findings_have_fingerprints_of_their_own(clean) -> None:
    text = clean["package.xml"].replace("Apache-2.0", "TODO")
    [finding] = lint_files({**clean, "package.xml": text}, ["XML104"]).findings
    report = Report(lint_files(clean), Path("/ws"), Path("/ws"))
    (_, alone), *_ = fingerprints(report, [finding])
    marks = [mark for _, mark in fingerprints(report, [finding, finding, finding])]
    assert marks[0] == alone
    assert len(set(marks)) == 3
