"""What a user's config tells the rules; everything else in it is the engine's."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class RuleSettings:
    build_types: frozenset[str] = frozenset()
    """Build types that are known here beside those of `ros.manifest`."""
    plugins: tuple[str, ...] = ()
    """Installed packages of rules, which every process of a run must load."""
