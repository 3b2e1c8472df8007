"""SARIF 2.1.0: rules with their help, fixes, suppressions. Columns count code points, as `columnKind` says."""

from __future__ import annotations

from itertools import groupby
from typing import IO, Any
from urllib.parse import quote

from .. import __version__
from ..finding import Create, Delete, Edit, Finding, Location, Severity
from ..rule import Rule, all_rules
from ..rule_address import web_address
from ..rule_docs import explain, summary
from . import Report
from .dump import dump
from .fingerprint import fingerprints

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}


def render(report: Report, stream: IO[str]) -> None:
    findings = (*report.results.findings, *report.results.suppressed)
    used = {finding.code for finding in findings}
    rules = [rule for rule in all_rules() if rule.code in used]
    index = {rule.code: number for number, rule in enumerate(rules)}
    run = {
        "tool": {
            "driver": {
                "name": "rospkg",
                "semanticVersion": __version__,
                "rules": [descriptor(rule) for rule in rules],
            }
        },
        "columnKind": "unicodeCodePoints",
        "originalUriBaseIds": {"ROOT": {"uri": report.cwd.as_uri().rstrip("/") + "/"}},
        "results": [result(report, f, mark, index[f.code]) for f, mark in fingerprints(report, findings)],
    }
    dump({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, stream)


def descriptor(rule: Rule[Any]) -> dict[str, Any]:
    described = {
        "id": rule.code,
        "name": "".join(word.capitalize() for word in rule.name.split("-")),
        "shortDescription": {"text": summary(rule)},
        "help": {"text": explain(rule), "markdown": explain(rule)},
        "defaultConfiguration": {"level": LEVELS[rule.severity]},
    }
    page = web_address(rule.code)
    return {**described, "helpUri": page} if page else described


def result(report: Report, finding: Finding, mark: str, rule: int) -> dict[str, Any]:
    found: dict[str, Any] = {
        "ruleId": finding.code,
        "ruleIndex": rule,
        "level": LEVELS[finding.severity],
        "message": {"text": finding.message},
        "locations": [location(report, finding.location)],
        "partialFingerprints": {"rospkg/v1": mark},
    }
    if finding.related:
        found["relatedLocations"] = [
            {"id": number, **location(report, place), "message": {"text": why}}
            for number, (place, why) in enumerate(finding.related, 1)
        ]
    if finding.suppressed is not None:
        kind = "external" if finding.external else "inSource"
        found["suppressions"] = [{"kind": kind, "justification": finding.suppressed}]
    changes = fix(report, finding)
    return {**found, "fixes": [changes]} if changes else found


def artifact(report: Report, path: str) -> dict[str, Any]:
    return {"uri": quote(bytes_of(report.path(path))), "uriBaseId": "ROOT"}


def bytes_of(path: str) -> bytes:
    """Return the bytes of a name on disk, for a name that is no text too."""
    try:
        return path.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:  # half a surrogate pair, as Windows has them
        return path.encode("utf-8", "surrogatepass")


def region(at: Location) -> dict[str, int]:
    return {"startLine": at.line, "startColumn": at.column, "endLine": at.end_line, "endColumn": at.end_column}


def location(report: Report, at: Location) -> dict[str, Any]:
    return {"physicalLocation": {"artifactLocation": artifact(report, at.path), "region": region(at)}}


def fix(report: Report, finding: Finding) -> dict[str, Any] | None:
    """Return the fix where SARIF can say it: edits and new files; moves and modes it has no words for."""
    if finding.fix is None or not all(isinstance(o, Edit | Create | Delete) for o in finding.fix.operations):
        return None
    edits = [o for o in finding.fix.operations if isinstance(o, Edit)]
    replacements = [
        (edit.path, {"deletedRegion": region(at), "insertedContent": {"text": edit.text}})
        for edit, at in zip(edits, finding.edit_locations, strict=True)
    ]
    start = {"startLine": 1, "startColumn": 1, "endLine": 1, "endColumn": 1}
    replacements += [
        (o.path, {"deletedRegion": start, "insertedContent": {"text": o.text}})
        for o in finding.fix.operations
        if isinstance(o, Create)
    ]
    if not replacements or len(replacements) < len(finding.fix.operations):
        return None
    return {
        "description": {"text": finding.fix.title},
        "artifactChanges": [
            {"artifactLocation": artifact(report, path), "replacements": [each for _, each in group]}
            for path, group in groupby(sorted(replacements, key=lambda r: r[0]), key=lambda r: r[0])
        ],
    }
