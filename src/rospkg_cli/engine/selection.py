"""Which rules run: profiles, --select, --ignore; codes, names and prefixes alike."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from ..light_dataclasses import dataclass, field
from ..rule import Profile
from ..rule_table import RuleEntry, rule_entries


@dataclass(frozen=True)
class Selection:
    """What the user asked for, as typed; an empty `select` means every rule of the profiles."""

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    extend: tuple[str, ...] = ()
    profiles: frozenset[Profile] = field(default_factory=lambda: frozenset({Profile.DEFAULT}))
    preview: bool = False
    """Whether rules run that are new in this release."""

    def codes(self) -> frozenset[str]:
        """Return the codes of the rules that run."""
        return frozenset(rule.code for rule in rule_entries().values() if self.runs(rule))

    def runs(self, rule: RuleEntry) -> bool:
        """Return whether a rule runs: one named in full does, whatever its profile and whatever prefix is ignored."""
        own = {rule.code, rule.name}
        if own.intersection(self.ignore):
            return False
        if own.intersection(self.select + self.extend):
            return True
        if named_by(rule, self.ignore) or rule.profile not in self.profiles or (rule.preview and not self.preview):
            return False
        return not self.select or named_by(rule, self.select + self.extend)


EVERYTHING = Selection(profiles=frozenset(Profile), preview=True)


def named_by(rule: RuleEntry, names: Iterable[str]) -> bool:
    """Return whether a code, a name or a prefix of the code is among the names."""
    return any(rule.name == name or (name and rule.code.startswith(name.upper())) for name in names)


@cache
def codes_named(name: str) -> frozenset[str]:
    """Return the codes that a name, a code or a prefix means; none if it names no rule."""
    return frozenset(r.code for r in rule_entries().values() if named_by(r, (name,)))


def rule_names() -> list[str]:
    return [name for rule in rule_entries().values() for name in (rule.code, rule.name)]
