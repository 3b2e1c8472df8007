"""Which levels of findings are shown, are fixed, and make a run fail."""

from __future__ import annotations

from ...config.file import Config
from ...engine.run.results import Results
from ...engine.selection import rule_names
from ...finding import Severity
from .lint_options import LintOptions


def least_failing(options: LintOptions, config: Config) -> Severity | None:
    """Return the least level that fails; None where none does."""
    if options.exit_zero or options.fixing.fix_only:
        return None
    return Severity(options.fail_on or config.fail_on)


def asks_for_info(options: LintOptions, config: Config) -> bool:
    """Return whether the text shows infos: asked for, or the reason of a failure, or what a rule was named for."""
    fails = (options.fail_on or config.fail_on) == Severity.INFO.value
    return "info" in options.report.show or fails or not set(options.rules.select).isdisjoint(rule_names())


def least_fixed(options: LintOptions, config: Config) -> Severity:
    """Return the least severity that is fixed: infos are left alone where no option asks for them."""
    are_shown = "all" in options.report.show or asks_for_info(options, config)
    default = Severity.INFO if are_shown else Severity.WARNING
    return Severity(options.fixing.fix_level) if options.fixing.fix_level else default


def exit_status(results: Results, fail_on: Severity | None, changed: bool) -> int:
    """Return 3 after an internal error, 2 where nothing was checked, 1 for findings or changes that fail, else 0."""
    if results.crashes:
        return 3
    if any(finding.code == "RPK006" for finding in results.findings):
        return 2
    judged = (finding for finding in results.findings if finding.code != "RPK008")
    fails = fail_on and any(finding.severity.rank >= fail_on.rank for finding in judged)
    return 1 if changed or fails else 0
