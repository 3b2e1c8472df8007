"""Every rule's own examples: they fire where they are marked, and nowhere else."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rospkg_cli.engine.fixing.apply import apply_fixes
from rospkg_cli.example import Example
from rospkg_cli.finding import Safety
from rospkg_cli.rule import Rule, all_rules
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree, TreeEntry

CASES = [
    pytest.param(rule, example, id=f"{rule.code}-{i}")
    for rule in all_rules()
    for i, example in enumerate(rule.examples)
]
GOLDEN = Path(__file__).parent / "beside"
NO_TREE_SHOWS_IT = {"RPK005", "RPK007", "RPK008"}
NOWHERE_IN_A_FILE = {"RPK006"}
NEEDS_OTHERS = {"RPK002", "RPK003"}
"""These judge suppressions of other rules, so those have to run as well."""


def run(rule: Rule, files: dict[str, str | TreeEntry], example: Example) -> list:
    codes = None if rule.code in NEEDS_OTHERS else [rule.code]
    results = lint_files(files, codes, example.targets)
    return [f for f in results.findings if f.code == rule.code]


def fixed(rule: Rule, files: dict[str, str | TreeEntry], example: Example) -> dict[str, str | TreeEntry]:
    """Apply the rule's own fixes until none is left (ten rounds at most)."""
    for _ in range(10):
        fixes = [f.fix for f in run(rule, files, example) if f.fix]
        changes, taken = apply_fixes(MemoryTree.of(files), fixes)
        if not taken:
            return files
        merged = {**files, **changes}
        files = {path: entry for path, entry in merged.items() if entry is not None}
    pytest.fail("the fix does not come to an end")


@pytest.mark.parametrize("rule, example", CASES)
def test_fires_at_each_marked_place(rule: Rule, example: Example) -> None:
    found = [(f.location.path, f.location.span) for f in run(rule, example.bad_files(), example)]
    if rule.code in NOWHERE_IN_A_FILE:
        assert found
    else:
        assert example.marks(), "an example shows the place between « and »"
        assert sorted(found) == example.marks()


@pytest.mark.parametrize("rule, example", CASES)
def test_good_is_silent(rule: Rule, example: Example) -> None:
    assert [f.message for f in run(rule, example.good_files(), example)] == []


@pytest.mark.parametrize("rule, example", CASES)
def test_fix_makes_good_of_bad(rule: Rule, example: Example) -> None:
    findings = run(rule, example.bad_files(), example)
    offered = {f.fix.safety for f in findings if f.fix}
    if example.fix is None:
        assert not offered, "the rule has a fix that its example does not show"
        return
    assert example.fix in offered
    after = fixed(rule, dict(example.bad_files()), example)
    assert contents(after) == contents(example.good_files())
    assert contents(fixed(rule, after, example)) == contents(after)


def contents(files: dict) -> dict[str, tuple[str, bool]]:
    entries = MemoryTree.of(files).content
    return {path: (entry.text.text, entry.is_executable) for path, entry in entries.items()}


@pytest.mark.parametrize("rule, example", CASES)
def test_one_fault_one_finding(rule: Rule, example: Example, request: pytest.FixtureRequest) -> None:
    """Under all rules an example shows its own code, and what the golden list grants beside it."""
    codes = sorted({f.code for f in lint_files(example.bad_files(), None, example.targets).findings})
    granted = json.loads((GOLDEN / f"{rule.family}.json").read_text()).get(request.node.callspec.id, [])
    assert codes == sorted({rule.code, *granted})


def test_examples_are_there() -> None:
    assert {rule.code for rule in all_rules() if not rule.examples} == NO_TREE_SHOWS_IT


def test_every_level_is_declared() -> None:
    for rule in all_rules():
        for example in rule.examples:
            for finding in run(rule, example.bad_files(), example):
                assert finding.severity in {rule.severity, *rule.levels}


def test_the_fix_of_an_example_is_safe_or_unsafe() -> None:
    assert {rule.fix for rule in all_rules()} <= {Safety.SAFE, Safety.UNSAFE, None}
