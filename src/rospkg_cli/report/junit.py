"""JUnit's XML, as `colcon test-result`, Jenkins and GitLab count it: a suite a package, a failure a finding.

A finding below warning is shown in the output of its suite and fails nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import IO
from xml.sax.saxutils import escape, quoteattr

from ..control_characters import visible_lines, without_workflow_commands
from ..finding import Finding, Severity
from . import Report
from .dump import is_unicode


def render(report: Report, stream: IO[str]) -> None:
    text = "".join(document(report))
    stream.write(text if is_unicode(stream) else text.encode("ascii", "xmlcharrefreplace").decode())


def document(report: Report) -> Iterator[str]:
    findings = report.results.findings
    packages = sorted({finding.package for finding in findings}) or ["rospkg"]
    counted = [f for f in findings if f.severity is not Severity.INFO]
    yield '<?xml version="1.0" encoding="utf-8"?>\n'
    yield f'<testsuites name="rospkg" tests="{max(1, len(counted))}" failures="{len(counted)}" errors="0">\n'
    for package in packages:
        yield from suite(report, package, [f for f in findings if f.package == package])
    yield "</testsuites>\n"


def suite(report: Report, package: str, findings: list[Finding]) -> list[str]:
    failures = [f for f in findings if f.severity is not Severity.INFO]
    infos = [f for f in findings if f.severity is Severity.INFO]
    lines = [
        f'  <testsuite name={attribute("rospkg." + package)} tests="{max(1, len(failures))}"'
        f' failures="{len(failures)}" errors="0" skipped="0">\n'
    ]
    if not failures:
        lines.append(f'    <testcase classname={attribute(package)} name="rospkg lint"/>\n')
    for finding in failures:
        name = f"{finding.code} {finding.name} {report.where(finding)}"
        lines += [
            f"    <testcase classname={attribute(package)} name={attribute(name)}>\n",
            f"      <failure type={attribute(finding.severity.value)} message={attribute(finding.message)}>"
            f"{text(report.where(finding) + ': ' + finding.message)}</failure>\n",
            "    </testcase>\n",
        ]
    if infos:
        said = "\n".join(f"{report.where(f)}: {f.code} {f.message}" for f in infos)
        lines.append(f"    <system-out>{text(said)}</system-out>\n")
    return [*lines, "  </testsuite>\n"]


def text(value: str) -> str:
    """Escape; what XML can't hold is shown."""
    return escape(without_workflow_commands(visible_lines(value)), {"\r": "&#13;"})


def attribute(value: str) -> str:
    return quoteattr(visible_lines(value))
