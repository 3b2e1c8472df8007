"""One finding as HTML: its message, the source line with the span marked, and what its fix changes."""

from __future__ import annotations

import html
from collections.abc import Iterator

from ..control_characters import visible_lines
from ..finding import Chmod, Create, Delete, Edit, Finding, Location, Move, Operation
from ..lazy_regex import regex
from . import Report
from .excerpt import as_drawn

CODE = regex(r"`([^`\n]+)`")


def text(value: str) -> str:
    """Return a text in which nothing is markup, and nothing would end an attribute or a line unseen."""
    return html.escape(visible_lines(value))


def article(report: Report, finding: Finding, rule: str) -> Iterator[str]:
    """Yield the lines of one finding, with what filters ask for."""
    level = finding.severity.value
    yield f'<article data-package="{text(finding.package)}" data-rule="{text(rule)}" data-level="{level}">'
    yield f'<h3><strong class="{level}">{level}</strong> {text(rule)}: {message(finding.message)}</h3>'
    yield f'<p class="dim"><code>{text(report.where(finding))}</code></p>'
    if finding.excerpt.strip():
        yield f'<pre tabindex="0">{marked(finding.excerpt, finding.location)}</pre>'
    for place, why in finding.related:
        yield f'<p class="dim">{message(why)}: <code>{text(f"{report.path(place.path)}:{place.line}")}</code></p>'
    if finding.fix is not None:
        yield f"<details><summary>{text(finding.fix_options)}: {message(finding.fix.title)}</summary>"
        yield f'<pre tabindex="0">{"".join(changes(report, finding))}</pre></details>'
    yield "</article>"


def message(value: str) -> str:
    """Return a message whose `code` is code."""
    return CODE.sub(r"<code>\1</code>", text(value))


def marked(line: str, place: Location) -> str:
    """Return a line of source with the span marked that begins in it."""
    line = line.removesuffix("\r")
    start = place.column - 1
    end = place.end_column - 1 if place.end_line == place.line else len(line)
    end = max(end, start + 1)
    inside = text(as_drawn(line[start:end])) or " "
    return f"{text(as_drawn(line[:start]))}<mark>{inside}</mark>{text(as_drawn(line[end:]))}"


def changes(report: Report, finding: Finding) -> Iterator[str]:
    """Yield the lines of what a fix changes, with the place of each edit."""
    places = iter(finding.edit_locations)
    for operation in finding.fix.operations if finding.fix else ():
        if isinstance(operation, Edit):
            yield from edit(report, finding, operation, next(places))
        else:
            yield f"{text(said(report, operation))}\n"
            yield from added(operation.text) if isinstance(operation, Create) else ()


def edit(report: Report, finding: Finding, change: Edit, at: Location) -> Iterator[str]:
    """Yield an edit as a diff where its line is the finding's own; elsewhere only what is new is at hand."""
    yield f"@ {text(f'{report.path(at.path)}:{at.line}:{at.column}')}\n"
    line, place = finding.excerpt.removesuffix("\r"), finding.location
    if (at.path, at.line, at.end_line) == (place.path, place.line, place.line) and line:
        yield f"<del>- {text(line)}</del>\n"
        yield from added(line[: at.column - 1] + change.text + line[at.end_column - 1 :])
        return
    if at.span.start != at.span.end:
        upto = f"{at.end_line}:{at.end_column}"
        yield f"<del>- {at.span.end - at.span.start} characters, up to {upto}</del>\n"
    yield from added(change.text) if change.text else ()


def added(new: str) -> Iterator[str]:
    yield from (f"<ins>+ {text(line)}</ins>\n" for line in new.strip("\n").split("\n"))


def said(report: Report, operation: Operation) -> str:
    """Return an operation on a whole file in words."""
    path = report.path(operation.path)
    match operation:
        case Create():
            return f"new file {path}"
        case Delete():
            return f"deletes {path}"
        case Move(to=to):
            return f"moves {path} to {report.path(to)}"
        case Chmod(executable=executable):
            return f"makes {path} {'executable' if executable else 'not executable'}"
    return f"changes {path}"
