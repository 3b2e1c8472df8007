"""What each rule says: `tests/findings/<CODE>.txt` holds the findings of every example, place, level, sentence, fix.

`tests/cases/` has more cases, for sentences and levels that the examples, which users read, need not show.

`pytest tests/test_findings.py --update-golden` writes them anew; read their diff before it is committed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from cases import CASES

from rospkg_cli.finding import Finding, Location
from rospkg_cli.rule import Rule, all_rules
from rospkg_cli.testing import lint_files

FINDINGS = Path(__file__).parent / "findings"
SHOWN = [pytest.param(rule, id=rule.code) for rule in all_rules() if rule.examples]
NEEDS_OTHERS = {"RPK002", "RPK003"}
"""These judge suppressions of other rules, so those have to run as well."""
LEVEL_OF_AN_INDEX = {("DEP001", "info"), ("DEP203", "info"), ("RPK001", "info"), ("SET205", "warning")}
"""Seen only with names fetched from rosdistro, or where repositories are missing: `tests/test_fetched_names.py`;
those of RPK001 and SET205 with bytes that are no text, and with a link, which no example can hold."""


def findings(rule: Rule) -> str:
    """Return a block for each example, one line a finding; its fix and related places are indented below it."""
    codes = None if rule.code in NEEDS_OTHERS else [rule.code]
    named = [(f"example {number}", example) for number, example in enumerate(rule.examples)]
    named += [(f"case {number}", case) for number, case in enumerate(CASES.get(rule.code, ()))]
    blocks = []
    for name, example in named:
        found = lint_files(example.bad_files(), codes, example.targets).findings
        lines = [line for finding in found if finding.code == rule.code for line in described(finding)]
        blocks.append("\n".join([name, *lines, ""]))
    return "\n".join(blocks)


def described(finding: Finding) -> Iterator[str]:
    yield f"{where(finding.location)} {finding.severity.value}: {one_line(finding.message)}"
    for place, message in finding.related:
        yield f"  see {where(place)}: {one_line(message)}"
    if finding.fix:
        yield f"  {finding.fix.safety.value} fix: {one_line(finding.fix.title)}"


def where(place: Location) -> str:
    """Return `path:line:column-column`, or with the line of the end where that is another one."""
    end = f"{place.end_line}:" if place.end_line != place.line else ""
    return f"{place.path}:{place.line}:{place.column}-{end}{place.end_column}"


def one_line(text: str) -> str:
    return text.replace("\n", "\\n")


@pytest.mark.parametrize("rule", SHOWN)
def test_what_a_rule_says(rule: Rule, pytestconfig: pytest.Config) -> None:
    golden = FINDINGS / f"{rule.code}.txt"
    if pytestconfig.getoption("--update-golden"):
        FINDINGS.mkdir(exist_ok=True)
        golden.write_text(findings(rule), encoding="utf-8", newline="\n")
    assert golden.exists(), "write it with: pytest tests/test_findings.py --update-golden"
    assert findings(rule) == golden.read_text(encoding="utf-8")


def test_each_rule_has_its_findings_and_no_file_is_left_over() -> None:
    assert {path.name for path in FINDINGS.iterdir()} == {f"{rule.code}.txt" for rule in all_rules() if rule.examples}


def test_each_case_is_of_a_rule() -> None:
    assert CASES.keys() <= {rule.code for rule in all_rules()}


@pytest.mark.parametrize("rule", SHOWN)
def test_each_level_that_a_rule_declares_is_shown_and_no_other(rule: Rule) -> None:
    """What `rospkg explain` says of levels is true; a level that nothing shows wants a case in `tests/cases/`."""
    golden = (FINDINGS / f"{rule.code}.txt").read_text(encoding="utf-8")
    shown = set(re.findall(r"^\S.*? (error|warning|info): ", golden, re.MULTILINE))
    shown |= {level for code, level in LEVEL_OF_AN_INDEX if code == rule.code}
    assert shown == {level.value for level in (rule.severity, *rule.levels)}
