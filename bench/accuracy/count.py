"""How much is said: findings a package by level, and how many packages make a run exit with 1."""

from __future__ import annotations

from collections import Counter

from bench.accuracy.reports import Report

ROW = "{:44} {:>8} {:>6} {:>8} {:>6} {:>8}"


def count(found: list[Report]) -> str:
    """Return a table by repository, its sum a package, and the codes by how often they are said."""
    lines = [ROW.format("repository", "packages", "errors", "warnings", "infos", "exit 1")]
    for report in found:
        numbers = (report.number(level) for level in ("error", "warning", "info"))
        lines.append(ROW.format(report.repository.name, report.packages, *numbers, len(report.failing())))
    packages = sum(report.packages for report in found) or 1
    per_package = (sum(report.number(level) for report in found) / packages for level in ("error", "warning", "info"))
    failing = sum(len(report.failing()) for report in found) / packages
    shares = [f"{share:.2f}" for share in per_package]
    lines.append(ROW.format("a package", packages, *shares, f"{failing:.0%}"))
    return "\n".join([*lines, "", *by_code(found)])


def by_code(found: list[Report]) -> list[str]:
    codes = Counter((finding["code"], finding["severity"]) for report in found for finding in report.findings)
    return [f"{number:6} {code} {severity}" for (code, severity), number in codes.most_common()]
