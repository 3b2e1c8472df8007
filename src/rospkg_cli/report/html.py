"""One HTML page for people who read no logs: sums, filters, source lines with their spans, what fixes change.

It loads nothing: style and script are in it, and its policy lets no other run.
"""

from __future__ import annotations

import base64
import hashlib
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from ..control_characters import visible, without_workflow_commands
from ..finding import Finding, Severity
from . import Report
from .html_finding import article, text
from .summary import summary

HERE = Path(__file__).parent
LEVELS = tuple(reversed(Severity))


def render(report: Report, stream: IO[str]) -> None:
    style, script = ((HERE / f"html_page.{kind}").read_text("utf-8") for kind in ("css", "js"))
    policy = f"default-src 'none'; style-src {digest(style)}; script-src {digest(script)}; base-uri 'none'"
    stream.write(
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>rospkg lint</title>\n<style>{style}</style>\n</head>\n<body>\n<main>\n"
    )
    stream.writelines(without_workflow_commands(f"{line}\n") for line in body(report))
    stream.write(f"</main>\n<script>{script}</script>\n</body>\n</html>\n")


def digest(code: str) -> str:
    """Return the source expression of a policy that allows one script or style."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(code.encode()).digest()).decode()}'"


def body(report: Report) -> Iterator[str]:
    findings = report.results.findings
    yield f"<h1>rospkg lint</h1>\n<p>{text(summary(report))}</p>"
    yield '<div class="overview">'
    yield from overview("Package", [visible(each.package) for each in findings], findings)
    yield from overview("Rule", [rule_of(each) for each in findings], findings)
    yield '</div>\n<form id="filters" hidden>'
    yield '<label>Search <input id="search" type="search"></label>'
    yield from choice("package", "Package", sorted({visible(each.package) for each in findings}))
    yield from choice("rule", "Rule", sorted({rule_of(each) for each in findings}))
    yield from choice("level", "Level", [level.value for level in LEVELS])
    yield '<button type="reset">Show all</button> <button type="button" id="theme">Dark or light</button>'
    yield '<output id="count"></output>\n</form>\n<h2>Findings</h2>'
    for finding in findings:
        yield from article(report, finding, rule_of(finding))


def rule_of(finding: Finding) -> str:
    return f"{finding.code} {finding.name}"


def overview(heading: str, names: list[str], findings: tuple[Finding, ...]) -> Iterator[str]:
    """Yield a table with the number of findings of each level by name, most errors first, then warnings, then infos."""
    counts = Counter((name, finding.severity) for name, finding in zip(names, findings, strict=True))
    levels = "".join(f'<th scope="col" class="n">{level.value}</th>' for level in LEVELS)
    yield f'<div class="sums" role="region" tabindex="0" aria-label="Findings by {heading.lower()}">'
    yield f'<table>\n<tr><th scope="col">{heading}</th>{levels}</tr>'
    for name in sorted(dict.fromkeys(names), key=lambda name: [-counts[name, level] for level in LEVELS]):
        cells = "".join(f'<td class="n">{counts[name, level] or ""}</td>' for level in LEVELS)
        yield f"<tr><td>{text(name)}</td>{cells}</tr>"
    yield "</table>\n</div>"


def choice(key: str, label: str, values: list[str]) -> Iterator[str]:
    yield f'<label>{label} <select id="{key}"><option value="">all</option>'
    yield from (f"<option>{text(value)}</option>" for value in values)
    yield "</select></label>"
