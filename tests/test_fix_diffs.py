"""What each fix writes, to be read: `tests/fixes/<CODE>.diff` holds the diff of every example that is repaired.

`pytest tests/test_fix_diffs.py --update-golden` writes them anew; read the diff of the diffs before it is committed.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from cases import CASES

from rospkg_cli.cli.diff import unified
from rospkg_cli.engine.discovery.cmake_projects import cmake_projects_in
from rospkg_cli.engine.discovery.discover import packages_in, repositories_in
from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import Example
from rospkg_cli.finding import Safety
from rospkg_cli.ros.distros import Targets
from rospkg_cli.rule import Rule, all_rules
from rospkg_cli.tree import MemoryTree

FIXES = Path(__file__).parent / "fixes"
FIXED = [pytest.param(rule, id=rule.code) for rule in all_rules() if rule.fix]
NEEDS_OTHERS = {"RPK002"}


def diffs(rule: Rule) -> str:
    """Return the diff of each example and case that is repaired, under the rule alone, behind a line that names it."""
    shown = []
    for number, example in enumerate(rule.examples):
        if example.fix is not None:
            shown.append(f"# example {number}, {example.fix.value}: {repaired(rule, example)}")
    for number, case in enumerate(CASES.get(rule.code, ())):
        found = repaired(rule, case)
        shown += [f"# case {number}: {found}"] if found.strip() else []
    return "\n".join(shown)


def repaired(rule: Rule, example: Example) -> str:
    """Return the titles of the fixes that are made, and the diff below them."""
    tree = MemoryTree.of(example.bad_files())
    folders = packages_in(tree)
    codes = {rule.code, "XML104"} if rule.code in NEEDS_OTHERS else {rule.code}
    repositories, projects = repositories_in(tree), cmake_projects_in(tree, folders)
    scope = Scope(tuple(folders), frozenset(folders), "my_pkg", repositories=repositories, cmake_projects=projects)
    session = Session(tree, scope, frozenset(codes), Targets(example.targets))
    outcome = fix_all(session, (Safety.SAFE, Safety.UNSAFE))
    assert not outcome.refused
    titles = sorted({finding.fix.title for finding in outcome.applied if finding.fix})
    return f"{'; '.join(titles)}\n{''.join(unified(tree, outcome.changes))}"


@pytest.mark.parametrize("rule", FIXED)
def test_what_a_fix_writes(rule: Rule, pytestconfig: pytest.Config) -> None:
    golden = FIXES / f"{rule.code}.diff"
    if pytestconfig.getoption("--update-golden"):
        FIXES.mkdir(exist_ok=True)
        golden.write_text(diffs(rule))
    assert diffs(rule) == golden.read_text()


def test_no_diff_is_left_over() -> None:
    assert {path.stem for path in FIXES.glob("*.diff")} == {rule.code for rule in all_rules() if rule.fix}
