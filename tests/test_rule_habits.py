"""What every rule's file has in common, so that the next one is easy to write and easy to read."""

from __future__ import annotations

import inspect
import re
import sys

import pytest

from rospkg_cli.rule import Rule, all_rules
from rospkg_cli.rule_docs import SUMMARY_WIDTH, summary

RULES = [pytest.param(rule, id=rule.code) for rule in all_rules()]
FAMILIES = {
    "RPK": "tool", "XML": "manifest", "SET": "setup", "DEP": "depends", "CMK": "cmake", "IDL": "interfaces",
    "LCH": "launch", "PRM": "params", "URD": "urdf", "PLG": "plugins", "WSP": "workspace",
}  # fmt: skip
HEADINGS = ["## What it does", "## Why is this bad?", "## When it is quiet", "## Fix safety", "## References"]


@pytest.mark.parametrize("rule", RULES)
def test_the_file_is_called_like_the_rule(rule: Rule) -> None:
    module = rule.check.__module__.rpartition("rules.")[2]
    assert module == f"{FAMILIES[rule.family]}.{rule.code.lower()}_{rule.name.replace('-', '_')}"
    assert rule.check.__name__ == rule.name.replace("-", "_")
    assert re.fullmatch(r"[A-Z]{3}[0-9]{3}", rule.code)
    assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", rule.name)


@pytest.mark.parametrize("rule", RULES)
def test_the_docs_have_their_headings_in_order(rule: Rule) -> None:
    found = re.findall(r"^ *(## .*)$", rule.docs, re.MULTILINE)
    assert found[:2] == HEADINGS[:2]
    assert found == [heading for heading in HEADINGS if heading in found]


@pytest.mark.parametrize("rule", RULES)
def test_the_docs_say_when_the_rule_is_quiet(rule: Rule) -> None:
    """What elsewhere makes a finding harmless: whoever writes it down has looked for it."""
    assert "## When it is quiet" in rule.docs


@pytest.mark.parametrize("rule", RULES)
def test_the_first_line_of_the_docs_is_one_whole_sentence(rule: Rule) -> None:
    """It is the summary in `rospkg rules --format json`, and the title of the rule in SARIF."""
    line = summary(rule)
    assert re.fullmatch(r"(Finds|Compares|Reports) .*[^.]\.", line), line
    assert len(line) <= SUMMARY_WIDTH
    prose = re.sub(r"`[^`]*`", "code", line)
    assert not re.search(r"[.:;`](?: |$)", prose[:-1])
    assert line.count("(") == line.count(")")


@pytest.mark.parametrize("rule", RULES)
def test_the_body_is_short(rule: Rule) -> None:
    source, _ = inspect.getsourcelines(rule.check)
    body = len(source) - rule.docs.count("\n")
    decorator = next(i for i, line in enumerate(source) if line.startswith("def "))
    assert body - decorator <= 32
    assert len(inspect.getsource(sys.modules[rule.check.__module__]).splitlines()) <= 140


def test_names_and_codes_are_unique() -> None:
    rules = all_rules()
    assert len({r.name for r in rules}) == len({r.code for r in rules}) == len(rules)
