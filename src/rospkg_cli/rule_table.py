"""What is known of each rule before its module is imported: `rules/table.txt`, so that a run imports what it needs.

A row has the module (relative to `rules/`, in which code and name are spelled), the profile, `stable` or `preview`, the
type of the input, and the models without which no such input is built. A rule that has no row is imported for them;
`pytest tests/test_rule_table.py --update-golden` writes the table anew.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from .light_dataclasses import dataclass
from .rule import PLUGGED_IN, Profile, Rule, all_rules, rules_in

FOLDER = Path(__file__).parent / "rules"


@dataclass(frozen=True, slots=True)
class RuleEntry:
    code: str
    name: str
    profile: Profile
    preview: bool
    module: str = ""
    """Dotted, below `rules`; "" where the rule has been imported already, or can't be found by its name."""
    over: str = ""
    """The name of its input's type."""
    needs: tuple[str, ...] = ()
    """The names of the models that the input has in any case, as far as they are known."""


@cache
def rule_entries() -> dict[str, RuleEntry]:
    """Return every built-in rule and every rule of a plug-in by its code, sorted."""
    table, found = rows(), [entry_of(rule) for rule in PLUGGED_IN.values()]
    for module in modules():
        if module in table:
            found.append(table[module])
        else:
            found += [entry_of(rule, module) for rule in imported(module).values()]
    return {each.code: each for each in sorted(found, key=lambda each: each.code)}


def entry_of(rule: Rule[Any], module: str = "") -> RuleEntry:
    return RuleEntry(rule.code, rule.name, rule.profile, rule.preview, module, rule.over.__name__)


def rows() -> dict[str, RuleEntry]:
    """Return the rows of the table by their modules."""
    lines = (FOLDER / "table.txt").read_text(encoding="utf-8").split("\n")
    return {line.split(" ", 1)[0]: entry_in(*line.split()) for line in lines if line and line[0] != "#"}


def entry_in(module: str, profile: str, stage: str, over: str, *needs: str) -> RuleEntry:
    code, _, name = module.rpartition(".")[2].partition("_")
    return RuleEntry(code.upper(), name.replace("_", "-"), Profile(profile), stage == "preview", module, over, needs)


def modules() -> Iterator[str]:
    """Yield the dotted name of each module of a rule, below `rules`."""
    with os.scandir(FOLDER) as families:
        folders = sorted(each.name for each in families if each.is_dir() and each.name.isidentifier())
    for folder in folders:
        for name in sorted(os.listdir(FOLDER / folder)):  # noqa: PTH208
            if name.endswith(".py") and name != "__init__.py":
                yield f"{folder}.{name[:-3]}"


@cache
def rule_by_code(code: str) -> Rule[Any]:
    """Return a rule, and import it where that was not done yet; raises KeyError."""
    entry = rule_entries()[code]
    if code in PLUGGED_IN:
        return PLUGGED_IN[code]
    return imported(entry.module)[code]


def imported(module: str) -> dict[str, Rule[Any]]:
    return rules_in(import_module(f".rules.{module}", __package__))


def forget_rules() -> None:
    """Look for rules anew when it is next asked for them, since a plug-in has brought some."""
    for each in (rule_entries, rule_by_code, all_rules):
        each.cache_clear()
