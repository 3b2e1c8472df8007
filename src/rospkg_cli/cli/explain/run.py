"""`rospkg explain`."""

from __future__ import annotations

from typing import Any

from ... import rule_docs as docs
from ...engine.selection import codes_named, rule_names
from ...rule import Rule, all_rules
from ...suggest import did_you_mean
from .. import UsageError


def explain(name: str) -> str:
    """Return the docs of the rule of a code or a name, as Markdown; raises UsageError."""
    return docs.explain(find_rule(name))


def find_rule(name: str) -> Rule[Any]:
    for rule in all_rules():
        if name.upper() == rule.code or name.lower() == rule.name:
            return rule
    some = sorted(codes_named(name))
    if some:
        raise UsageError(f"`{name}` matches several rules: {', '.join(some)}; name one")
    raise UsageError(f"there is no rule `{name}`{did_you_mean(name, rule_names())}; `rospkg rules` lists them")
