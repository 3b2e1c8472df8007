"""What a rule is, and the registry that finds them all by walking `rules/`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from enum import Enum
from functools import cache
from types import ModuleType
from typing import Any, Generic, TypeVar

from .example import Example as Example
from .finding import Hit, Safety, Severity
from .light_dataclasses import dataclass, field

S = TypeVar("S")


class Profile(Enum):
    """When a rule runs: always, only under --pedantic, or only under --release."""

    DEFAULT = "default"
    PEDANTIC = "pedantic"
    RELEASE = "release"


@dataclass(frozen=True)
class Rule(Generic[S]):
    """A pure function over one input, with its docs (the function's docstring) and its examples."""

    code: str
    name: str
    over: type[S]
    severity: Severity
    check: Callable[[S], Iterator[Hit]] = field(repr=False)
    levels: Mapping[Severity, str] = field(default_factory=dict, repr=False)
    """Other levels that a hit may carry, each with its condition."""
    profile: Profile = Profile.DEFAULT
    since: str = "0.1"
    preview: bool = False
    """New in this release: runs only under --preview, so that an upgrade does not break CI."""
    examples: tuple[Example, ...] = field(default=(), repr=False)

    @property
    def docs(self) -> str:
        return self.check.__doc__ or ""

    @property
    def family(self) -> str:
        return self.code[:3]

    @property
    def fix(self) -> Safety | None:
        """The safety of the rule's fix, as its examples show it; None when it has none."""
        offered = [example.fix for example in self.examples if example.fix]
        return Safety.SAFE if Safety.SAFE in offered else Safety.UNSAFE if offered else None


def rule(
    code: str,
    name: str,
    *,
    over: type[S],
    severity: Severity,
    levels: Mapping[Severity, str] | None = None,
    profile: Profile = Profile.DEFAULT,
    since: str = "0.1",
    preview: bool = False,
    examples: tuple[Example, ...],
) -> Callable[[Callable[[S], Iterator[Hit]]], Rule[S]]:
    """Make a rule of a generator over `over`: a file's model, or a joined input."""

    def make(check: Callable[[S], Iterator[Hit]]) -> Rule[S]:
        return Rule(code, name, over, severity, check, levels or {}, profile, since, preview, examples)

    return make


PLUGGED_IN: dict[str, Rule[Any]] = {}
"""Rules of other installed packages, by code; `engine.run.rule_plugins` puts them here when a config names them."""


@cache
def all_rules() -> tuple[Rule[Any], ...]:
    """Every built-in rule and every rule of a plugin, by code."""
    import importlib
    import pkgutil

    from . import rules

    found = dict(PLUGGED_IN)
    for info in pkgutil.walk_packages(rules.__path__, rules.__name__ + "."):
        if not info.ispkg:
            found |= rules_in(importlib.import_module(info.name))
    return tuple(found[code] for code in sorted(found))


def rules_in(module: ModuleType) -> dict[str, Rule[Any]]:
    """Return the rules of a module by code."""
    return {value.code: value for value in vars(module).values() if isinstance(value, Rule)}
