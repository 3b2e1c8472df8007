"""`rospkg explain` and `rospkg rules`: find the rules that are named, and show their docs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ... import rule_docs as docs
from ...engine.selection import codes_named, rule_names
from ...rule import Rule, all_rules
from ...suggest import did_you_mean
from .. import UsageError


def explain(name: str) -> str:
    """Return the docs of the rule of a code or a name, as Markdown; raises UsageError."""
    return docs.explain(find_rule(name))


def explained(name: str, every: bool) -> str:
    """Return the docs of a rule, or of all, as Markdown; raises UsageError."""
    return "\n".join(docs.explain(rule) for rule in asked_for(name, every))


def explained_json(name: str, every: bool) -> str:
    """Return the docs of a rule as an object of JSON, or those of all as a list; raises UsageError."""
    return docs.explained_json(asked_for(name, every), every)


def asked_for(name: str, every: bool) -> list[Rule[Any]]:
    """Return the named rule, or all; raises UsageError where it is not clear which."""
    if every and name:
        raise UsageError(f"--all shows every rule, `{name}` among them; leave one of the two out")
    if not every and not name:
        raise UsageError("name a rule: `rospkg explain SET101`; --all shows every rule, and `rospkg rules` lists them")
    return list(all_rules()) if every else [find_rule(name)]


def find_rule(name: str) -> Rule[Any]:
    for rule in all_rules():
        if name.upper() == rule.code or name.lower() == rule.name:
            return rule
    some = sorted(codes_named(name))
    if some:
        raise UsageError(
            f"`{name}` matches several rules: {', '.join(some)}; name one, or list them: rospkg rules {name}"
        )
    raise UsageError(f"there is no rule `{name}`{did_you_mean(name, rule_names())}; `rospkg rules` lists them")


def named_rules(names: Sequence[str]) -> list[Rule[Any]]:
    """Return the rules of codes, names and first letters of codes, all where there are none; raises UsageError."""
    chosen: set[str] = set()
    for name in names:
        found = codes_named(name) or codes_named(name.upper()) or codes_named(name.lower())
        if not found:
            raise UsageError(f"there is no rule `{name}`{did_you_mean(name, rule_names())}; `rospkg rules` lists them")
        chosen |= found
    return [rule for rule in all_rules() if rule.code in chosen or not names]
