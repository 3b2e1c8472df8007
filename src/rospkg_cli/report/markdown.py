"""Markdown for the summary of a workflow run: a table of findings, at most 200 of them."""

from __future__ import annotations

import re
from typing import IO

from ..finding import Finding
from ..lazy_regex import regex
from . import Report
from .summary import summary

MOST = 200
SPAN = regex(r"`([^`]+)`")
BREAKS = regex(r"[`|\\]")
MARKUP = regex(r"[\\`*\[\]<>&|!~$]|(?<![^\W_])_|_(?![^\W_])|[@#](?=\w)|:(?=//)|\bwww(?=\.)")
LINKED = ("@", "#", ":", "www")


def render(report: Report, stream: IO[str]) -> None:
    findings = report.results.findings
    stream.write(f"## rospkg lint\n\n{summary(report)}\n")
    if findings:
        stream.write("\n| | Rule | Where | What |\n|---|---|---|---|\n")
        stream.writelines(row(report, finding) for finding in findings[:MOST])
    if len(findings) > MOST:
        stream.write(f"\n… and {len(findings) - MOST} more.\n")


def row(report: Report, finding: Finding) -> str:
    cells = (
        finding.severity.value,
        f"{finding.code} {finding.name}",
        code(report.where(finding)),
        message_markup(finding.message),
    )
    return "| " + " | ".join(cells) + " |\n"


def message_markup(message: str) -> str:
    """Return a message whose `code` is code, and nothing else is markup: no HTML, no link, no name that is notified."""
    *pairs, last = SPAN.split(" ".join(message.split()))
    return "".join(code(part) if number % 2 else plain(part) for number, part in enumerate(pairs)) + plain(last)


def code(text: str) -> str:
    """Return a code span for a cell of a table; one that ends neither at a backtick nor at a `|` of its own."""
    return f"`{text}`" if text.strip() and not BREAKS.search(text) else f"<code>{plain(text)}</code>"


def plain(text: str) -> str:
    """Return a text in which nothing is markup; what GitHub would link is parted by a blank of no width."""
    return MARKUP.sub(entity, text)


def entity(found: re.Match[str]) -> str:
    text = found.group()
    return f"{text}&#8203;" if text in LINKED else f"&#{ord(text)};"
