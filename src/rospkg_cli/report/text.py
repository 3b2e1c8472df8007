"""For people: by package, the worst last; the line of source, what is wrong, how to fix it; counts at the end."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import IO

from ..finding import Finding, Severity
from ..light_dataclasses import replace
from .color import SEVERITY_COLORS
from .excerpt import excerpt
from .package_groups import badness, by_package, by_rule
from .rule_counts import rule_counts, table
from .short_message import lowered, short_message, without_advice
from .summary import counted, summary
from .wrap import Word, words, wrapped

from . import Report  # isort: skip

LONG = 15
"""Findings that are shown in full; of more, only errors are, and a table of the rules follows."""

NOTES = "RPK008"
"""The rule whose findings are notes on the run, not on a package: they are listed after the counts."""

PLACES = 5
"""Related places of one kind that are shown of a finding."""

MORE = "--show all shows each finding in full; `rospkg explain CODE` says why."


def render(report: Report, stream: IO[str]) -> None:
    notes = [f for f in report.results.findings if f.code == NOTES]
    findings = [f for f in report.results.findings if f.code != NOTES]
    report = replace(report, results=replace(report.results, findings=tuple(findings)))
    shown = [f for f in findings if f.severity is not Severity.INFO or report.shows_info]
    is_long = len(shown) > LONG and not report.shows_all
    for package, found in by_package(shown):
        block = [] if report.results.packages < 2 else [heading(report, package, findings)]
        block += short_blocks(report, found) if is_long else full_blocks(report, found)
        stream.writelines(f"{line}\n" for line in block)
    for line in ending(report, findings, len(findings) - len(shown), is_long):
        stream.write(f"{line}\n")
    for note in notes:
        stream.writelines(f"{line}\n" for line in lines(report, words(f"note: {note.message}"), "", "  "))


def heading(report: Report, package: str, findings: Sequence[Finding]) -> str:
    """Return the line above a package: its name, and what it has, with what is not shown."""
    counts = badness(f for f in findings if f.package == package)
    told = [counted(n, level.value) for n, level in zip(counts, reversed(Severity), strict=True) if n]
    return "\n".join(lines(report, [(f"{package or 'workspace'}:", "bold"), *words(", ".join(told))], "", "  "))


def full_blocks(report: Report, findings: Sequence[Finding]) -> Iterator[str]:
    for finding in findings:
        yield from (*full(report, finding), "")


def short_blocks(report: Report, findings: Sequence[Finding]) -> Iterator[str]:
    """Yield each error in full; of the other levels a few lines for each rule, and one for each further file."""
    for first, *others in by_rule(findings):
        if first.severity is Severity.ERROR:
            yield from full(report, first, "  ")
        else:
            head = [(f"{report.where(first)}:", "bold"), *level_and_code(report, first)]
            yield from lines(report, [*head, *words(f"{short_message(first)}{repair(first, '; ')}")], "  ", "    ")
        for _, same_file in groupby(others, key=lambda other: other.location.path):
            yield from lines(report, further(report, list(same_file)), "    ", "      ")


def further(report: Report, others: Sequence[Finding]) -> Iterator[Word]:
    """Yield the places of further findings of a rule in one file, each with its repair, or else what is wrong."""
    for number, other in enumerate(others):
        place = report.where(other) if not number else f"{other.location.line}:{other.location.column}"
        yield f"{place}:", "bold"
        end = ";" if number < len(others) - 1 else ""
        yield from words((lowered(other.fix.title) if other.fix else short_message(other)) + end)


def full(report: Report, finding: Finding, indent: str = "") -> Iterator[str]:
    """Yield the lines that show one finding in full."""
    head = [(f"{report.where(finding)}:", "bold"), *level_and_code(report, finding), (finding.name, "dim")]
    inner = f"{indent}  "
    yield from lines(report, head, indent, inner)
    room = None if report.width is None else report.width - len(indent)
    yield from (indent + line for line in excerpt(finding, room, report.color))
    yield from lines(report, words(without_advice(finding)), inner)
    for why, places in related(report, finding).items():
        yield from lines(report, [("see", ""), *several(places), *words(why)], inner, f"{inner}  ")
    if finding.fix:
        yield from lines(report, words(repair(finding), "green"), inner)


def lines(report: Report, found: Iterable[Word], first: str, rest: str | None = None) -> list[str]:
    return wrapped(found, report.width, first, rest, report.color)


def level_and_code(report: Report, finding: Finding) -> list[Word]:
    """Return both as words; on a terminal, whose width is known, the code leads to the page of its rule."""
    page = None
    if report.color and report.width is not None:
        from ..rule_address import web_address

        page = web_address(finding.code)
    return [(finding.severity.value, SEVERITY_COLORS[finding.severity]), (finding.code, page or "")]


def repair(finding: Finding, before: str = "") -> str:
    """Return the option that fixes a finding and what it does; "" for no fix."""
    return f"{before}{finding.fix_options}: {lowered(finding.fix.title)}" if finding.fix else ""


def related(report: Report, finding: Finding) -> dict[str, list[str]]:
    """Return the related places by what is said of them."""
    found: dict[str, list[str]] = {}
    for place, why in finding.related:
        found.setdefault(why, []).append(f"{report.path(place.path)}:{place.line}:{place.column}")
    return found


def several(places: Sequence[str]) -> list[Word]:
    """Return the first few of some places, and how many there are besides; JSON, SARIF and HTML list all."""
    shown = places if len(places) <= PLACES else places[: PLACES - 1]
    more = words(f"and {len(places) - len(shown)} more:") if len(shown) < len(places) else []
    end = "" if more else ":"
    return [*((f"{place},", "") for place in shown[:-1]), (f"{shown[-1]}{end}", ""), *more]


def ending(report: Report, findings: Sequence[Finding], hidden: int, is_long: bool) -> Iterator[str]:
    """Yield the counts: by rule where the report is long, of the infos that are not shown, and of all."""
    if is_long:
        yield from ("", *table(rule_counts(findings), report.width, report.color), "")
        yield from lines(report, words(MORE), "", "  ")
    elif hidden:
        infos = rule_counts(f for f in findings if f.severity is Severity.INFO)
        told = ", ".join(f"{count.code} {count.name}" for count in infos)
        yield from lines(report, words(f"not shown: {counted(hidden, 'info')} ({told})"), "", "  ")
    yield from lines(report, words(summary(report)), "")
