"""Rules of other installed packages, where the user's config names them.

A package offers a module of rules under a name, as an entry point of the group `rospkg_cli.rules`. A config can only
name what is installed, never a path: the config of a repository that is linted loads no code of that repository.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from typing import Any

from ..rule import PLUGGED_IN, Rule, all_rules, rules_in
from ..suggest import did_you_mean
from .selection import codes_named
from .stamp import rule_by_code

GROUP = "rospkg_cli.rules"
CODE = re.compile(r"[A-Z]{3}[0-9]{3}")


class PluginError(Exception):
    """A plug-in that can't be used; the message says which and what to do."""


def plug_in(names: Iterable[str]) -> None:
    """Make the rules of the named plug-ins known, once; raises PluginError."""
    for name in names:
        load(name)


@cache
def load(name: str) -> None:
    there = {point.name: point for point in entry_points(group=GROUP)}
    if name not in there:
        known = f"; installed are {', '.join(sorted(there))}" if there else "; no plug-in is installed"
        hint = did_you_mean(name, there)
        raise PluginError(f"plugins: there is no plug-in `{name}`{hint}{known}: install it beside rospkg, or remove it")
    found = rules_of(there[name])
    own = {rule.code: rule.name for rule in all_rules()}
    for code in found:
        if code in own or not CODE.fullmatch(code):
            why = f"is that of our `{own[code]}`" if code in own else "is not three capitals and three digits"
            raise PluginError(f"plugins: `{name}` has a rule `{code}`, and that code {why}")
    PLUGGED_IN.update(found)
    all_rules.cache_clear()
    codes_named.cache_clear()
    rule_by_code.cache_clear()


def rules_of(point: EntryPoint) -> dict[str, Rule[Any]]:
    try:
        found = rules_in(point.load())
    except Exception as error:
        raise PluginError(f"plugins: `{point.name}` can't be loaded: {type(error).__name__}: {error}") from error
    if not found:
        raise PluginError(f"plugins: `{point.name}` offers no rules: its entry point must name a module that has some")
    return found
