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
        in_profile = rule.profile in self.profiles or any(map(is_everything, self.select + self.extend))
        if named_by(rule, self.ignore) or not in_profile or (rule.preview and not self.preview):
            return False
        return not self.select or named_by(rule, self.select + self.extend)


EVERYTHING = Selection(profiles=frozenset(Profile), preview=True)


def named_by(rule: RuleEntry, names: Iterable[str]) -> bool:
    """Return whether a code, a name, a prefix of the code or ALL is among the names."""
    return any(
        rule.name == name or is_everything(name) or (name and rule.code.startswith(name.upper())) for name in names
    )


def is_everything(name: str) -> bool:
    """Return whether a name means every rule, of all profiles."""
    return name.upper() == "ALL"


@cache
def codes_named(name: str) -> frozenset[str]:
    """Return the codes that a name, a code or a prefix means; none if it names no rule."""
    return frozenset(r.code for r in rule_entries().values() if named_by(r, (name,)))


def rule_names() -> list[str]:
    return [name for rule in rule_entries().values() for name in (rule.code, rule.name)]
