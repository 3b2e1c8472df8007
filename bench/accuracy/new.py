"""What lint says now and another state of it does not: errors and warnings, a few of each rule in a repository."""

from __future__ import annotations

import random
import sys
from collections.abc import Iterator
from pathlib import Path

from bench.accuracy.reports import Finding, Report, lint

MILD = "info"


def new_reports(repositories: list[Path], base: str, options: list[str], most: int, seed: int) -> Iterator[Report]:
    """Yield the report of each repository with what `base`, the Python of another installation, does not say.

    A finding is known where the other state has an error or a warning of its rule in the same line. At most so many
    of a rule are drawn: copies of one file say one thing. A repository in which the other state crashes is left out.
    """
    draw = random.Random(seed)
    for repository in repositories:
        try:
            before = lint(repository.resolve(), [], base)
        except RuntimeError as error:
            print(f"left out: {error}", file=sys.stderr)
            continue
        now = lint(repository.resolve(), options)
        known = {place(each) for each in before.findings if each["severity"] != MILD}
        found = [each for each in now.findings if each["severity"] != MILD and place(each) not in known]
        yield Report(now.repository, now.packages, tuple(drawn(found, most, draw)))


def place(finding: Finding) -> tuple[str, str, int]:
    return finding["code"], finding["path"], finding["line"]


def drawn(findings: list[Finding], most: int, draw: random.Random) -> Iterator[Finding]:
    for code in sorted({each["code"] for each in findings}):
        of_rule = [each for each in findings if each["code"] == code]
        yield from of_rule if len(of_rule) <= most else draw.sample(of_rule, most)
