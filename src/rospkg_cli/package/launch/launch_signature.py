"""What other packages may know of a launch file."""

from __future__ import annotations

from ...light_dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class LaunchSignature:
    source: str
    """The file, relative to its package."""
    places: frozenset[str]
    """Where it goes, relative to the share directory."""
    declared: frozenset[str] = frozenset()
    required: frozenset[str] = frozenset()
    """The declared ones that have no default."""
    used: frozenset[str] = frozenset()
    """The launch configurations that it uses, declared or not."""
    includes: tuple[tuple[str, str], ...] = ()
    """The files that it includes, which see all its arguments: package and path, as in FileReference."""
    may_take_others: bool = False
    """Whether it may take others."""
    defaults: frozenset[tuple[str, str]] = frozenset()
    """The declared ones whose default is known, and that."""
    passed: frozenset[tuple[str, str]] = frozenset()
    """The configurations that it uses for nothing but arguments of what it includes, each with that argument."""
    idle: frozenset[str] = frozenset()
    """The configurations that it only puts where nothing reads them."""

    def reads(self, name: str) -> bool:
        """Return whether it uses a configuration for more than to pass it on."""
        is_used = name in self.used and name not in self.idle
        return is_used and not any(name == passed for passed, _ in self.passed)
