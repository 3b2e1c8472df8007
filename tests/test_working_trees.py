"""Trees as they lie on disks: what lints clean stays clean whatever a tool, an editor or a lost file leaves in it."""

from __future__ import annotations

from pathlib import Path

import pytest
from working_trees import PUT, folders_of

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.engine.session import Scope, Session
from rospkg_cli.example import BACKDROPS, present
from rospkg_cli.rule import Rule, all_rules

BACKDROP = [name for name in BACKDROPS if name]
HELD = {"config": {"config/notes.txt": "What is installed must be there\n"}}


MAY_NOT_BE_KNOWN = "RPK004"
"""Where links to folders lie about, it can't be told what find_namespace_packages() finds, and that may be said."""


def findings(package: Path) -> list[tuple[str, str]]:
    session = Session(DiskTree(package), Scope(("",), frozenset({""}), "my_pkg"), EVERYTHING.codes())
    found = session.run().findings
    return [(each.code, each.message) for each in found if each.code != MAY_NOT_BE_KNOWN]


@pytest.mark.parametrize("put", PUT)
@pytest.mark.parametrize("backdrop", BACKDROP)
def test_a_clean_package_stays_clean(tmp_path: Path, write, backdrop: str, put: str) -> None:
    package = write(tmp_path / "my_pkg", {**present(BACKDROPS[backdrop]), **HELD.get(backdrop, {})})
    assert findings(package) == []
    for folder in folders_of(package):
        PUT[put](folder)
    assert findings(package) == []


@pytest.mark.parametrize("rule", [pytest.param(rule, id=rule.code) for rule in all_rules() if rule.examples])
def test_every_good_example_stays_good(tmp_path: Path, write, rule: Rule) -> None:
    """The same findings (of all rules) as without what lies about, for each good example of each rule."""
    for number, example in enumerate(rule.examples):
        package = write(tmp_path / f"{number}" / "my_pkg", example.good_files())
        if not (package / "package.xml").is_file():
            continue
        before = findings(package)
        for folder in folders_of(package):
            for put in PUT.values():
                put(folder)
        assert findings(package) == before
