"""The table of rules says what the rules themselves say; one that it lacks is found all the same."""

from __future__ import annotations

import typing
from collections.abc import Iterator

import pytest

from rospkg_cli import rule_table
from rospkg_cli.engine.run.rule_inputs import input_parts
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.package.readers import READERS
from rospkg_cli.rule import Profile, Rule, all_rules
from rospkg_cli.rule_table import FOLDER, RuleEntry, forget_rules, rows, rule_by_code, rule_entries

HEAD = """\
# What is known of each rule before it is imported; see rule_table.py.
# Written by `pytest tests/test_rule_table.py --update-golden`.
"""


@pytest.fixture(autouse=True)
def forgotten() -> Iterator[None]:
    forget_rules()
    yield
    forget_rules()


def needs(kind: type) -> Iterator[type]:
    """Yield the models without which no input of a type is built."""
    if kind in READERS:
        yield kind
    elif hasattr(kind, "__dataclass_fields__") and kind.__name__ not in PROVIDED:
        for part in input_parts(kind):
            if not (part.is_optional or part.is_every):
                yield from needs(part.kind)


PROVIDED = {
    "PackageFiles", "Workspace", "Targets", "RuleSettings", "PackageFacts", "Unreadable",
    "UnusedSuppression", "UnknownRuleName", "RuleCrash", "NoPackagesFound",
}  # fmt: skip


def row(rule: Rule[typing.Any]) -> str:
    module = rule.check.__module__.removeprefix("rospkg_cli.rules.")
    stage = "preview" if rule.preview else "stable"
    needed = dict.fromkeys(kind.__name__ for kind in needs(rule.over))
    return " ".join([module, rule.profile.value, stage, rule.over.__name__, *needed])


def test_the_table_says_what_the_rules_say(pytestconfig: pytest.Config) -> None:
    table = HEAD + "".join(sorted(f"{row(rule)}\n" for rule in all_rules()))
    if pytestconfig.getoption("--update-golden"):
        (FOLDER / "table.txt").write_text(table)
    assert (FOLDER / "table.txt").read_text() == table, "write it: pytest tests/test_rule_table.py --update-golden"


def test_entries_and_rules_agree() -> None:
    assert list(rule_entries()) == [rule.code for rule in all_rules()]
    for rule in all_rules():
        entry = rule_entries()[rule.code]
        assert (entry.code, entry.name, entry.profile) == (rule.code, rule.name, rule.profile)
        assert (entry.preview, entry.over) == (rule.preview, rule.over.__name__)
        assert rule_by_code(rule.code) is rule


def test_a_rule_without_a_row_is_imported(monkeypatch: pytest.MonkeyPatch) -> None:
    known = rows()
    row_of_one = known.pop("manifest.xml104_placeholder_metadata")
    monkeypatch.setattr(rule_table, "rows", lambda: known)
    assert rule_entries()["XML104"] == replace(row_of_one, needs=())
    assert rule_by_code("XML104").name == "placeholder-metadata"


def test_a_row_without_a_module_is_no_rule(monkeypatch: pytest.MonkeyPatch) -> None:
    known = rows()
    gone = RuleEntry("XML999", "gone", Profile.DEFAULT, False, "manifest.xml999_gone")
    monkeypatch.setattr(rule_table, "rows", lambda: {**known, "manifest.xml999_gone": gone})
    assert "XML999" not in rule_entries()
    with pytest.raises(KeyError):
        rule_by_code("XML999")
